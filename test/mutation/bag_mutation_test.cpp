// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "modeler/ros/bag_check/bag_check.hpp"
#include "modeler/ros/offline/offline_run.hpp"
#include "test/bag/wall_bag.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/mutation/mutator.hpp"

namespace ribbon_mapper::mutation {
namespace {

std::string sample(bool is_compressed) {
  const TemporaryDirectory directory;
  WallBag bag;
  bag.lines = 8, bag.is_compressed = is_compressed;
  bag.write(directory.path() / "a.bag");
  return content_of(directory.path() / "a.bag");
}

/// A bag is checked and modelled, or refused.
TEST(BagMutations, AreReadOrRefused) {
  ros::Time::init();
  OfflineOptions options;
  options.bags = {std::filesystem::temp_directory_path() / "mutation.bag"};
  options.config = PROJECT_DIR "/config/pr2.yaml";
  const std::vector<std::string> words{"/tf",
                                       "/tilt_scan",
                                       "laser_tilt_link",
                                       "op=\x05",
                                       "bz2",
                                       std::string("\xff\xff\xff\x7f", 4),
                                       std::string("\x04\0\0\0", 4),
                                       std::string("\0\0\0\0", 4)};
  expect_read_or_refused(Mutator({sample(false), sample(true)}, words), "bag",
                         [&](const std::string&) {
                           EXPECT_FALSE(check_bags(options.bags, options.bag).text().empty());
                           model_bags(options, [](const Progress&) {});
                         });
}

}  // namespace
}  // namespace ribbon_mapper::mutation
