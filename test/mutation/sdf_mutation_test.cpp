// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "sim/tour/route.hpp"
#include "sim/world/world.hpp"
#include "test/mutation/mutator.hpp"

namespace ribbon_mapper::mutation {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the contents of the files with this ending that are small enough to be read often.
std::vector<std::string> samples(const std::string& ending) {
  std::vector<std::string> texts;
  for (const char* folder : {"worlds", "test/data/field", "test/mutation/worlds"})
    for (const auto& entry : fs::directory_iterator(fs::path(PROJECT_DIR) / folder)) {
      const std::string name = entry.path().filename().string();
      const bool ends = name.size() > ending.size() &&
                        name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
      if (ends && entry.file_size() < 6000) texts.push_back(content_of(entry.path()));
    }
  return texts;
}

TEST(SdfMutations, AreReadOrRefused) {
  std::vector<std::string> worlds = samples(".world");
  for (std::string& world : samples(".sdf")) worlds.push_back(std::move(world));
  const fs::path path = fs::temp_directory_path() / "mutated.sdf";
  bool visuals = false;
  expect_read_or_refused(Mutator(worlds, {"<model name='a'>",
                                          "</model>",
                                          "<link name='l'>",
                                          "</link>",
                                          "'",
                                          "<",
                                          ">",
                                          "::",
                                          "__model__",
                                          "relative_to='b'",
                                          "attached_to='a'",
                                          "model://sun",
                                          "model://ground_plane",
                                          "1.4",
                                          "1.10",
                                          "<state>",
                                          "<pose>",
                                          "<frame name='f'/>",
                                          "<sphere><radius>900</radius></sphere>",
                                          "<!--",
                                          "<![CDATA[",
                                          "&#0;"}),
                         "sdf", [&](const std::string& text) {
                           std::ofstream(path, std::ios::binary) << text;
                           visuals = !visuals;
                           const auto world = sim::World::load(path.string(), {},
                                                               sim::RayCasterKind::bullet, visuals);
                           EXPECT_FALSE(world.content().empty());
                         });
  fs::remove(path);
}

TEST(RouteMutations, AreReadOrRefused) {
  const fs::path path = fs::temp_directory_path() / "mutated.route.yaml";
  expect_read_or_refused(Mutator(samples(".route.yaml"), {"[", "]", "- ", ": ", "\n", "&a ", "*a",
                                                          "{", "}", "rest: 5\n", "1e-9", "1e5"}),
                         "route", [&](const std::string& text) {
                           std::ofstream(path, std::ios::binary) << text;
                           const sim::Route route = sim::Route::load(path.string());
                           EXPECT_FALSE(route.poses_to_check().empty());
                         });
  fs::remove(path);
}

}  // namespace
}  // namespace ribbon_mapper::mutation
