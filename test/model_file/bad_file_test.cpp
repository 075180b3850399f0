// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is no whole model file of a known format is refused, with the reason.
#include <gmock/gmock.h>

#include <cstring>
#include <limits>
#include <map>

#include "modeler/model_file/byte_writer.hpp"
#include "modeler/model_file/model_file.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/model_file/small_model.hpp"

namespace ribbon_mapper {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string& good() {
  static const std::string bytes = to_model_file(small_model());
  return bytes;
}

void expect_refused(const std::string& bytes, const std::string& reason) {
  EXPECT_THAT([&] { from_model_file(bytes); },
              ThrowsMessage<std::runtime_error>(HasSubstr(reason)));
}

/// Returns the CRC-32 of IEEE 802.3, bit by bit as it is defined.
std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

/// Returns the good file with another format, and the right checksum.
std::string of_format(std::uint32_t format) {
  ByteWriter number, crc;
  number.integer(format);
  std::string bytes = good();
  bytes.replace(8, 4, number.take());
  crc.integer(crc_of(bytes.substr(0, kHeaderSize - 4)));
  return bytes.replace(kHeaderSize - 4, 4, crc.take());
}

TEST(BadModelFile, OfAnotherKindIsNamed) {
  for (const std::string& bytes : {std::string(), std::string("ply\n"), std::string(1000, '\0'),
                                   good().substr(1), "\x89RIBBON\r\n" + good().substr(8)}) {
    expect_refused(bytes, "it is no model file of ribbon_mapper");
  }
}

TEST(BadModelFile, CutAnywhereIsRefused) {
  for (std::size_t size = 8; size < good().size(); size += 1 + size / 50) {
    expect_refused(good().substr(0, size), "it is cut off");
  }
  expect_refused(good() + '\0', "it is too long");
}

TEST(BadModelFile, AnyChangedByteIsFound) {
  for (std::size_t at = 0; at < good().size(); at += at < 2000 ? 1 : 101) {
    std::string bytes = good();
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    EXPECT_THROW(from_model_file(bytes), std::runtime_error) << "byte " << at;
  }
}

TEST(BadModelFile, OfANewerFormatIsNamed) {
  EXPECT_EQ(good(), of_format(kModelFormat));
  expect_refused(of_format(kModelFormat + 1), "it is of format 2, and this program reads up to");
  expect_refused(of_format(0), "it is damaged");
}

/// The sections of the good file, to be changed.
struct Parts {
  Parts() {
    for (const SectionView& each : split_sections(good())) {
      sections.push_back({each.name, std::string(each.bytes)});
    }
  }
  std::string& operator[](const std::string& name) {
    for (Section& each : sections) {
      if (each.name == name) return each.bytes;
    }
    throw std::logic_error("no section " + name);
  }
  std::string file() const { return join_sections(sections); }

  std::vector<Section> sections;
};

TEST(BadModelFile, EachPartIsNeeded) {
  const std::size_t count = Parts().sections.size();
  EXPECT_EQ(7u, count);
  for (std::size_t i = 0; i < count; ++i) {
    Parts parts;
    const std::string name = parts.sections[i].name;
    parts.sections.erase(parts.sections.begin() + static_cast<std::ptrdiff_t>(i));
    expect_refused(parts.file(), "it lacks part " + name);
  }
}

TEST(BadModelFile, APartThatIsCutOrTooLongIsNamed) {
  for (std::size_t i = 0; i < Parts().sections.size(); ++i) {
    Parts cut, longer, empty;
    const std::string name = cut.sections[i].name;
    cut.sections[i].bytes.pop_back();
    longer.sections[i].bytes += '\0';
    empty.sections[i].bytes.clear();
    for (const Parts& parts : {cut, longer, empty}) expect_refused(parts.file(), "part " + name);
  }
}

TEST(BadModelFile, UnknownPartsAreRefusedOrPassedOn) {
  Parts parts;
  parts.sections.push_back({"NEWS", "of a later version"});
  expect_refused(parts.file(), "it has a part NEWS that this program does not know");
  parts.sections.back().name = "note";
  ModelFile file = from_model_file(parts.file());
  ASSERT_EQ(1u, file.additions.size());
  EXPECT_EQ("of a later version", file.additions[0].bytes);
  const auto additions = file.additions;
  const Modeler modeler(file.config, std::move(file.model));
  EXPECT_EQ(parts.file(), to_model_file(modeler, "map", additions));
}

TEST(BadModelFile, NamesOfPartsAreChecked) {
  EXPECT_THROW(join_sections({{"abc", ""}}), std::invalid_argument);
  EXPECT_THROW(join_sections({{"ab1d", ""}}), std::invalid_argument);
  EXPECT_THROW(join_sections({{"abcd", ""}, {"abcd", ""}}), std::invalid_argument);
  EXPECT_THROW(to_model_file(small_model(), "map", {{"NOTE", ""}}), std::invalid_argument);
}

template <typename Number>
std::string bytes_of_number(Number number) {
  ByteWriter writer;
  if constexpr (std::is_integral_v<Number>) {
    writer.integer(number);
  } else {
    writer.number(number);
  }
  return writer.take();
}

/// A number in a part that no model can have.
struct Absurd {
  const char* part;
  std::size_t at;
  std::string bytes;
  const char* reason;
};
class AbsurdNumber : public testing::TestWithParam<Absurd> {};

TEST_P(AbsurdNumber, IsRefused) {
  const Absurd& absurd = GetParam();
  Parts parts;
  parts[absurd.part].replace(absurd.at, absurd.bytes.size(), absurd.bytes);
  expect_refused(parts.file(), std::string("part ") + absurd.part + " " + absurd.reason);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr float kNanFloat = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint64_t kHuge = std::numeric_limits<std::uint64_t>::max();

INSTANTIATE_TEST_SUITE_P(
    BadModelFile, AbsurdNumber,
    testing::Values(
        Absurd{"TRAJ", 0, bytes_of_number(kHuge), "states more elements than it has"},
        Absurd{"TRAJ", 8 + 120, bytes_of_number(std::int64_t{-1}), "has stamps"},
        Absurd{"TRAJ", 8 + 8, bytes_of_number(kNan), "has a pose that cannot be"},
        Absurd{"TRAJ", 8 + 8 + 32, bytes_of_number(1e11), "has a pose that cannot be"},
        Absurd{"RIBS", 0, bytes_of_number(kHuge), "states more elements than it has"},
        Absurd{"RIBS", 8, bytes_of_number(std::uint32_t{1000000}), "has a ribbon that cannot be"},
        Absurd{"RIBS", 8 + 12, bytes_of_number(0.0F), "has a ribbon that cannot be"},
        Absurd{"RIBS", 8 + 16, bytes_of_number(kNanFloat), "has a ribbon that cannot be"},
        Absurd{"RIBS", 8 + 52, bytes_of_number(2.0F), "has a ribbon that cannot be"},
        Absurd{"RIBS", 8 + 96, bytes_of_number(~std::uint32_t{0}), "states more samples"},
        Absurd{"LEFT", 0, bytes_of_number(std::uint64_t{1}), "has not one element for each line"},
        Absurd{"LEFT", 8, bytes_of_number(kNanFloat), "has points that cannot be"},
        Absurd{"LEFT", 8 + 16, bytes_of_number(~std::uint32_t{0}), "has points that cannot be"},
        Absurd{"IDEN", 0, bytes_of_number(std::int64_t{-1}), "has a number of planes"},
        Absurd{"IDEN", 8, bytes_of_number(std::int64_t{-1}), "has an id that cannot be"},
        Absurd{"WAIT", 0, bytes_of_number(kNan), "has an origin that cannot be"},
        Absurd{"WAIT", 24, bytes_of_number(kHuge), "states more elements than it has"},
        Absurd{"WAIT", 32, bytes_of_number(std::uint8_t{0}), "has lines that wait in no order"},
        Absurd{"WAIT", 33 + 8 + 8, bytes_of_number(0.0), "has a line that waits: angles"},
        Absurd{"CONF", 0, bytes_of_number(kHuge), "states more elements than it has"}));

TEST(BadModelFile, ValuesOutOfRangeAreNamed) {
  Parts parts;
  std::string& config = parts["CONF"];
  const std::string key = "ribbon.min_points";
  const std::size_t at = config.find(key) + key.size();
  for (const double value : {-1.0, 6.5, kNan, 1e300}) {
    config.replace(at, 8, bytes_of_number(value));
    expect_refused(parts.file(), "part CONF has a value of ribbon.min_points that is out of range");
  }
}

TEST(BadModelFile, CannotBeRead) {
  const TemporaryDirectory directory;
  const auto refuse = [](const std::filesystem::path& path, const std::string& reason) {
    EXPECT_THAT([&] { load_model_file(path); }, ThrowsMessage<std::runtime_error>(AllOf(
                                                    HasSubstr(path.string()), HasSubstr(reason))));
  };
  refuse(directory.path() / "none.ribbons", "cannot be read");
  refuse(directory.path(), "cannot be read");
  refuse("/dev/null", "no model file");
  refuse("/dev/zero", "no model file");
  write_content(directory.path() / "cut.ribbons", good().substr(0, 1000));
  refuse(directory.path() / "cut.ribbons", "it is cut off: 1000 bytes instead of");
}

TEST(Differences, AreNamedWithWhatHolds) {
  ModelFile file = from_model_file(good());
  EXPECT_TRUE(differences(file, file.config, "map").empty());
  ModelerConfig now = file.config;
  now.scan.range_sigma_m = 0.02;
  now.assembly.min_area_m2 = 1.0;
  EXPECT_THAT(differences(file, now, "world"),
              testing::ElementsAre(HasSubstr("frame was 'map', is 'world'"),
                                   AllOf(HasSubstr("scan.range_sigma_m was 0.018, is 0.02"),
                                         HasSubstr("the loaded ribbons stay")),
                                   AllOf(HasSubstr("assembly.min_area_m2 was "),
                                         HasSubstr(", is 1: for the whole model"))));
}

}  // namespace
}  // namespace ribbon_mapper
