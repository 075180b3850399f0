// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {

/// Tests that write world files into a folder of their own.
class WorldFile : public testing::Test {
 protected:
  /// Writes a file and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    write_file(directory_.path() / name, text);
    return directory_.path() / name;
  }

  /// Returns the world with `content`, or the one of a whole SDF file if it starts with <sdf.
  World load(const std::string& content, const std::vector<std::string>& folders = {}) const {
    const bool is_whole = content.rfind("<sdf", 0) == 0;
    return World::load(write("w.sdf", is_whole ? content : sdf_world(content)).string(), folders);
  }

  /// Returns the message that a world is refused with, and checks that it names the file.
  std::string error_of(const std::filesystem::path& path,
                       const std::vector<std::string>& folders = {}) const {
    try {
      World::load(path.string(), folders);
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(path.string())) << "names the file";
      return error.what();
    }
    ADD_FAILURE() << path << " was loaded";
    return "";
  }

  /// Returns the message that the world with `content` is refused with.
  std::string error_of_content(const std::string& content) const {
    return error_of(write("w.sdf", sdf_world(content)));
  }

  /// Returns the path of a file or folder.
  std::string folder(const std::string& name) const { return (directory_.path() / name).string(); }

  TemporaryDirectory directory_;
};

/// Returns the range along +x from `origin`, -1 if nothing is there.
inline double range_ahead(const World& world,
                          const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) {
  const auto hit = world.cast(origin, Eigen::Vector3d::UnitX(), 50.0);
  return hit ? hit->range_m : -1.0;
}

/// A box whose side is 4 m ahead of the origin.
inline const std::string kBoxAhead = sdf_model("box", "5 0 0 0 0 0", sdf_box("2 2 2"));

}  // namespace ribbon_mapper::sim
