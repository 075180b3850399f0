// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <type_traits>

#include "modeler/config_keys.hpp"
#include "modeler/io/config_file.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

/// A visitor of visit_keys() that calls test(key, min, max) for each number.
template <typename Test>
struct Numbers {
  Test test;
  void operator()(const char* key, double, double min, double max) const { test(key, min, max); }
  void operator()(const char*, bool) const {}
};

/// Calls test(key, min, max) for each number of the configuration.
template <typename Test>
void for_each_number(Test test) {
  const ModelerConfig config;
  const Numbers<Test> numbers{test};
  visit_keys(config, numbers);
}

/// A visitor of visit_keys() that sets the number with this key.
struct Setter {
  std::string key;
  double value;
  bool is_integer = false;
  template <typename Number>
  void operator()(const char* name, Number& number, double, double) {
    if (name != key) return;
    number = static_cast<Number>(value);
    is_integer = std::is_integral_v<Number>;
  }
  void operator()(const char*, bool&) {}
};

/// Returns the message of validate() for this value, or an empty string if it is valid.
std::string complaint(const std::string& key, double value) {
  ModelerConfig config;
  Setter setter{key, value};
  visit_keys(config, setter);
  try {
    config.validate();
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

bool is_integer(const std::string& key) {
  ModelerConfig config;
  Setter setter{key, 5.0};
  visit_keys(config, setter);
  return setter.is_integer;
}

TEST(Config, HasValidDefaults) { EXPECT_NO_THROW(ModelerConfig{}.validate()); }

TEST(Config, ChecksTheRangeOfEachNumber) {
  int keys = 0;
  for_each_number([&](const char* key, double min, double max) {
    ++keys;
    EXPECT_LT(min, max) << key;
    EXPECT_GE(min, 0.0) << key;
    const double step = is_integer(key) ? 1.0 : 1e-3 * min + 1e-6;
    for (const double bad : {min - step, max + std::max(step, 1e-3 * max)}) {
      const std::string words = complaint(key, bad);
      EXPECT_EQ(0u, words.find(std::string(key) + " is ")) << key << " = " << bad << ": " << words;
      std::ostringstream range;
      range << min << " .. " << max;
      EXPECT_NE(std::string::npos, words.find(range.str())) << words;
    }
    if (!is_integer(key)) {
      const double nan_ = std::numeric_limits<double>::quiet_NaN();
      EXPECT_EQ(0u, complaint(key, nan_).find(key)) << key;
      EXPECT_EQ(0u, complaint(key, std::numeric_limits<double>::infinity()).find(key)) << key;
    }
    const bool depends_on_another = std::regex_search(key, std::regex("_range_m|obstacle_"));
    if (!depends_on_another) {
      EXPECT_EQ("", complaint(key, min));
      EXPECT_EQ("", complaint(key, max));
    }
  });
  EXPECT_GE(keys, 30);
}

TEST(Config, RefusesEmptyRanges) {
  EXPECT_NE(std::string::npos, complaint("scan.min_range_m", 31.0).find("scan.max_range_m"));
  EXPECT_NE(std::string::npos, complaint("scan.max_range_m", 0.2).find("scan.min_range_m"));
}

/// A folder for configuration files.
class ConfigFile : public ::testing::Test {
 protected:
  ConfigFile() { fs::create_directories(folder); }
  ~ConfigFile() override { fs::remove_all(folder); }

  std::string write(const std::string& text) const {
    std::ofstream(folder / "my.yaml") << text;
    return folder / "my.yaml";
  }
  std::string complaint_about(const std::string& path) const {
    try {
      load_config(path);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  }
  void expect_complaint(const std::string& text, const std::vector<std::string>& parts) const {
    const std::string words = complaint_about(write(text));
    EXPECT_NE(std::string::npos, words.find("my.yaml")) << words;
    for (const std::string& part : parts) {
      EXPECT_NE(std::string::npos, words.find(part)) << "'" << text << "': " << words;
    }
  }

  const fs::path folder = fs::path(::testing::TempDir()) / "ribbon_mapper_config_test";
};

TEST_F(ConfigFile, SetsItsKeysAndLeavesTheOthers) {
  const ModelerConfig config = load_config(write(
      "surface: {cell_size_m: 0.1}\nassociation: {slam: {angle_deg: 5}}\nribbon:\n  min_points: 8\n"
      "scan: {deskew: false}\n"));
  EXPECT_EQ(0.1, config.surface.cell_size_m);
  EXPECT_EQ(5.0, config.association.slam.angle_deg);
  EXPECT_EQ(8, config.ribbon.min_points);
  EXPECT_FALSE(config.scan.deskew);
  EXPECT_EQ(ModelerConfig{}.association.slam.distance_m, config.association.slam.distance_m);
  EXPECT_EQ(ModelerConfig{}.scan.range_sigma_m, config.scan.range_sigma_m);
}

TEST_F(ConfigFile, MayBeEmpty) {
  EXPECT_EQ(0.05, load_config(write("")).surface.cell_size_m);
  EXPECT_EQ(0.05, load_config(write("# nothing\n")).surface.cell_size_m);
}

TEST_F(ConfigFile, WithUnknownKeysIsRefusedWithTheKnownOnes) {
  expect_complaint("surface: {cell_sise_m: 0.1}",
                   {"unknown key surface.cell_sise_m", "surface.cell_size_m"});
  EXPECT_EQ(std::string::npos, complaint_about(write("surface: {cell_sise_m: 0.1}")).find("scan."))
      << "keys of other sections would hide the one that was meant";
  expect_complaint("surfaces: {cell_size_m: 0.1}", {"unknown key surfaces.cell_size_m"});
  expect_complaint("cell_size_m: 0.1", {"unknown key cell_size_m"});
  expect_complaint("association: {slam: {cell_size_m: 0.1}}",
                   {"unknown key association.slam.cell_size_m"});
  expect_complaint("surface: 3", {"unknown key surface"});
}

TEST_F(ConfigFile, WithRenamedKeysIsRefusedWithTheirNewNames) {
  expect_complaint("map: {cell_size_m: 0.1}",
                   {"map.cell_size_m was renamed", "write surface.cell_size_m"});
  expect_complaint("correction: {poses_follow: true}", {"write trajectory.poses_follow"});
  expect_complaint("ribbon: {least_points: 6}", {"write ribbon.min_points"});
}

TEST_F(ConfigFile, WithWrongValuesIsRefusedWithTheKey) {
  expect_complaint("surface: {cell_size_m: wide}", {"surface.cell_size_m must be a number"});
  expect_complaint("surface: {cell_size_m: [1, 2]}", {"surface.cell_size_m must be a number"});
  expect_complaint("surface: {cell_size_m: }", {"surface.cell_size_m must be a number"});
  expect_complaint("ribbon: {min_points: 6.5}", {"ribbon.min_points must be a number"});
  expect_complaint("scan: {deskew: 7}", {"scan.deskew must be true or false"});
  expect_complaint("surface: {cell_size_m: 7}", {"surface.cell_size_m is 7", "0.01 .. 1"});
  expect_complaint("surface: {cell_size_m: .nan}", {"surface.cell_size_m is nan"});
}

TEST_F(ConfigFile, WithAliasesThatLeadToThemselvesIsRefused) {
  expect_complaint("&a {scan: *a}", {"unknown key scan.scan.scan.scan.scan"});
  expect_complaint("scan: &a {scan: *a}", {"unknown key scan.scan.scan.scan.scan"});
  expect_complaint("surface: &a\n  cell_size_m: *a\n", {"surface.cell_size_m must be a number"});
  expect_complaint("association: &a {slam: *a}", {"unknown key association.slam.slam"});
  expect_complaint("foo: &a [*a]", {"unknown key foo"});
  expect_complaint("surface: {cell_size_m: &a [*a]}", {"surface.cell_size_m must be a number"});
}

/// Nine levels of nine aliases are 400 million keys.
TEST_F(ConfigFile, WithManyAliasesIsRefusedAtTheFirstUnknownKey) {
  std::string text = "l0: &l0 {a: 1, b: 1, c: 1, d: 1, e: 1, f: 1, g: 1, h: 1, i: 1}\n";
  for (int level = 1; level < 10; ++level) {
    const std::string name = "l" + std::to_string(level), below = "*l" + std::to_string(level - 1);
    text += name + ": &" + name + " {";
    for (char key = 'a'; key <= 'i'; ++key) text += std::string(1, key) + ": " + below + ", ";
    text += "}\n";
  }
  expect_complaint(text, {"unknown key l0.a"});
  expect_complaint("scan: {x: 1}\n" + text, {"unknown key scan.x"});
}

TEST_F(ConfigFile, MayUseAliases) {
  const ModelerConfig config = load_config(
      write("association: {slam: &gates {angle_deg: 5, distance_m: 0.5}, corrected: *gates}"));
  EXPECT_EQ(5.0, config.association.corrected.angle_deg);
  EXPECT_EQ(0.5, config.association.corrected.distance_m);
}

TEST_F(ConfigFile, TakesNumbersAsYamlWritesThem) {
  for (const char* number : {"0.5", "+0.5", ".5", "5e-1", "5.E-1", "'0.5'"}) {
    const auto text = std::string("surface: {cell_size_m: ") + number + "}";
    EXPECT_EQ(0.5, load_config(write(text)).surface.cell_size_m) << number;
  }
  for (const char* text : {"'0,5'", "0.5 m", "1e999", "0x1p-1", "\"\"", "[0.5]", "~"}) {
    expect_complaint(std::string("surface: {cell_size_m: ") + text + "}", {"must be a number"});
  }
  expect_complaint("ribbon: {min_points: 99999999999}", {"ribbon.min_points must be a number"});
}

TEST_F(ConfigFile, WithLongNamesIsRefusedInFewWords) {
  for (const std::size_t length : {1000u, 2'000'000u}) {
    const std::string words = complaint_about(write(std::string(length, 'x') + ": 1"));
    EXPECT_NE(std::string::npos, words.find("my.yaml: ")) << words.substr(0, 100);
    EXPECT_LT(words.size(), 3000u);
  }
}

TEST_F(ConfigFile, WithoutSectionsAndKeysIsRefused) {
  expect_complaint("- 1\n- 2\n", {"sections with keys"});
  expect_complaint("just words", {"sections with keys"});
  expect_complaint("surface: {cell_size_m: 0.1", {"line 1, column", "no YAML", "config/pr2.yaml"});
  expect_complaint("surface:\n  cell_size_m: [0.1\nscan: 2", {"line 3, column"});
  expect_complaint("surface: {cell_size_m: 0.1}\nsurface: {cell_size_m: 0.2}", {"given twice"});
  EXPECT_NE(std::string::npos, complaint_about(folder / "none.yaml").find("does the file exist"));
  EXPECT_NE("", complaint_about(folder));
}

/// Returns the keys in a configuration file, without their sections.
std::set<std::string> keys_in(const std::string& path) {
  std::set<std::string> found;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const auto begin = line.find_first_not_of(' ');
    const auto colon = line.find(':');
    if (begin == std::string::npos || line[begin] == '#' || colon == std::string::npos) continue;
    found.insert(line.substr(begin, colon - begin));
  }
  return found;
}

/// A visitor of visit_keys() that collects all values.
struct Values {
  std::vector<double> values;
  template <typename Value, typename... Range>
  void operator()(const char*, const Value& value, Range...) {
    values.push_back(value);
  }
};
std::vector<double> values_of(const ModelerConfig& config) {
  Values values;
  visit_keys(config, values);
  return values.values;
}

TEST(Presets, CanBeLoaded) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(PROJECT_DIR "/config")) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(load_config(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST(Presets, ForThePr2ListEachKeyWithItsDefault) {
  const std::string path = PROJECT_DIR "/config/pr2.yaml";
  EXPECT_EQ(values_of({}), values_of(load_config(path)));
  const std::set<std::string> keys = keys_in(path);
  for_each_number([&](const std::string& key, double, double) {
    EXPECT_TRUE(keys.count(key.substr(key.rfind('.') + 1))) << key;
  });
}

}  // namespace
}  // namespace ribbon_mapper
