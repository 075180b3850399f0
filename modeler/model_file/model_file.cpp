// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/model_file/model_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <new>
#include <stdexcept>
#include <utility>

#include "modeler/model_file/byte_reader.hpp"
#include "modeler/model_file/byte_writer.hpp"
#include "modeler/model_file/config_section.hpp"
#include "modeler/model_file/observation_sections.hpp"
#include "modeler/model_file/trajectory_section.hpp"
#include "modeler/model_file/waiting_section.hpp"
#include "modeler/storage/atomic_file.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

constexpr const char *kInfo = "INFO", *kConfig = "CONF", *kTrajectory = "TRAJ", *kRibbons = "RIBS",
                     *kUnassigned = "LEFT", *kPlanes = "IDEN", *kWaiting = "WAIT";

bool is_addition(const std::string& name) { return name[0] >= 'a' && name[0] <= 'z'; }

/// Returns a section that write(to) fills.
template <typename Write>
Section section(const char* name, const Write& write) {
  ByteWriter to;
  write(to);
  return {name, to.take()};
}

void write_info(const Modeler& modeler, const std::string& frame, ByteWriter& to) {
  const ModelStatistics statistics = modeler.statistics();
  to.text(frame);
  for (const std::size_t count :
       {statistics.lines, statistics.thinned, statistics.revision, statistics.associated_again}) {
    to.integer(std::uint64_t{count});
  }
}

void write_planes(const Modeler& modeler, ByteWriter& to) {
  to.integer(modeler.next_plane_id());
  for (const std::int64_t id : modeler.plane_ids()) to.integer(id);
}

std::vector<std::int64_t> read_plane_ids(ByteReader& from, std::size_t ribbons,
                                         std::int64_t next_id) {
  // Each correction takes as many ids as there are planes: a session cannot come near the end.
  constexpr std::int64_t kMostIds = std::numeric_limits<std::int64_t>::max() / 2;
  if (next_id < 0 || next_id > kMostIds) from.fail("has a number of planes that cannot be");
  if (from.left() != ribbons * sizeof(std::int64_t)) from.fail("has not one id for each ribbon");
  std::vector<std::int64_t> ids(ribbons);
  for (std::int64_t& id : ids) {
    id = from.integer<std::int64_t>();
    if (id < 0 || id >= next_id) from.fail("has an id that cannot be");
  }
  return ids;
}

/// The parts of a file by name.
class Parts {
 public:
  explicit Parts(const std::vector<SectionView>& sections) {
    for (const SectionView& each : sections) parts_.emplace(each.name, each.bytes);
  }

  /// Returns what read(from) makes of a part, all of it.
  template <typename Read>
  auto read(const char* name, const Read& read) {
    const auto found = parts_.find(name);
    if (found == parts_.end()) {
      throw std::runtime_error("it lacks part " + std::string(name));
    }
    ByteReader from(found->second, name);
    parts_.erase(found);
    auto result = read(from);
    from.expect_end();
    return result;
  }

  /// Returns what was not read. Throws if it is needed to understand the model.
  std::vector<Section> additions() const {
    std::vector<Section> all;
    for (const auto& [name, bytes] : parts_) {
      if (!is_addition(name)) {
        throw std::runtime_error("it has a part " + name +
                                 " that this program does not know: use the version that wrote it");
      }
      all.push_back({name, std::string(bytes)});
    }
    return all;
  }

 private:
  std::map<std::string, std::string_view> parts_;
};

Observations read_observations(Parts& parts, const TrajectoryConfig& config) {
  Observations::Parts o{
      Trajectory(config, parts.read(kTrajectory, read_trajectory)), {}, {}, {}, {}};
  const std::size_t lines = o.trajectory.size();
  o.ribbons =
      parts.read(kRibbons, [&](ByteReader& from) { return read_ribbons(from, lines, o.samples); });
  o.unassigned = parts.read(
      kUnassigned, [&](ByteReader& from) { return read_unassigned(from, lines, o.points); });
  return Observations(std::move(o));
}

ModelFile read_model(Parts parts) {
  const ModelerConfig config = parts.read(kConfig, read_config);
  ModelFile file{config, {read_observations(parts, config.trajectory)}, {}, {}};
  SavedModel& model = file.model;
  parts.read(kInfo, [&](ByteReader& from) {
    file.frame = from.text();
    for (std::size_t* count :
         {&model.lines, &model.thinned, &model.revision, &model.associated_again}) {
      *count = static_cast<std::size_t>(from.integer<std::uint64_t>());
    }
    return true;
  });
  model.plane_ids = parts.read(kPlanes, [&](ByteReader& from) {
    model.next_plane_id = from.integer<std::int64_t>();
    return read_plane_ids(from, model.observations.ribbons().size(), model.next_plane_id);
  });
  model.waiting = parts.read(kWaiting, read_waiting);
  file.additions = parts.additions();
  return file;
}

/// Reads a file of which the header is right, so that its size is that of a model.
std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(kHeaderSize, '\0');
  file.peek();  // a directory can be opened but not read
  if (!file.is_open() || file.bad()) {
    throw std::runtime_error(std::string("it cannot be read: ") + std::strerror(errno));
  }
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  std::error_code unknown;
  const std::uint64_t size = fs::file_size(path, unknown);
  check_header(bytes, unknown ? bytes.size() : size);
  bytes.resize(static_cast<std::size_t>(size));
  file.read(bytes.data() + kHeaderSize, static_cast<std::streamsize>(size - kHeaderSize));
  if (static_cast<std::uint64_t>(file.gcount()) != size - kHeaderSize) {
    throw std::runtime_error("it cannot be read to its end");
  }
  return bytes;
}

}  // namespace

std::string to_model_file(const Modeler& modeler, const std::string& frame,
                          const std::vector<Section>& additions) {
  const Observations& observations = modeler.observations();
  std::vector<Section> sections;
  const auto add = [&](const char* name, const auto& write) {
    sections.push_back(section(name, write));
  };
  add(kInfo, [&](ByteWriter& to) { write_info(modeler, frame, to); });
  add(kConfig, [&](ByteWriter& to) { write_config(modeler.config(), to); });
  add(kTrajectory, [&](ByteWriter& to) { write_trajectory(observations.trajectory(), to); });
  add(kRibbons, [&](ByteWriter& to) { write_ribbons(observations.ribbons(), to); });
  add(kUnassigned, [&](ByteWriter& to) { write_unassigned(observations.unassigned(), to); });
  add(kPlanes, [&](ByteWriter& to) { write_planes(modeler, to); });
  add(kWaiting, [&](ByteWriter& to) { write_waiting(modeler.waiting(), to); });
  for (const Section& addition : additions) {
    if (addition.name.empty() || !is_addition(addition.name)) {
      throw std::invalid_argument("the name of an addition begins with a small letter: " +
                                  addition.name);
    }
    sections.push_back(addition);
  }
  return join_sections(sections);
}

ModelFile from_model_file(std::string_view bytes) {
  try {
    return read_model(Parts(split_sections(bytes)));
  } catch (const std::bad_alloc&) {
    throw std::runtime_error("there is not enough memory for it");
  }
}

std::vector<std::string> differences(const ModelFile& file, const ModelerConfig& config,
                                     const std::string& frame) {
  std::vector<std::string> sentences;
  if (file.frame != frame) {
    sentences.push_back("the model's frame was '" + file.frame + "', is '" + frame +
                        "': its coordinates stay");
  }
  for (const std::string& change : changed_keys(file.config, config)) {
    const bool is_of_lines = change.rfind("scan.", 0) == 0 || change.rfind("ribbon.", 0) == 0;
    sentences.push_back(change + (is_of_lines ? ": for new lines, the loaded ribbons stay"
                                              : ": for the whole model"));
  }
  return sentences;
}

void save_model_file(const Modeler& modeler, const fs::path& path, const std::string& frame,
                     const std::vector<Section>& additions) {
  write_file_atomically(path, to_model_file(modeler, frame, additions));
}

ModelFile load_model_file(const fs::path& path) {
  try {
    return from_model_file(content_of(path));
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot load " + path.string() + ": " + error.what());
  }
}

}  // namespace ribbon_mapper
