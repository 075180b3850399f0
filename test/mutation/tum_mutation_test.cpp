// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "modeler/io/tum.hpp"
#include "test/mutation/mutator.hpp"

namespace ribbon_mapper::mutation {
namespace {

/// What was read can be written, and read again.
TEST(TumMutations, AreReadOrRefused) {
  std::vector<StampedPose> trajectory;
  for (int i = 0; i < 10; ++i) trajectory.push_back({Time(i + 1), planar_pose(0.1 * i, 2.0, 0.3)});
  expect_read_or_refused(Mutator({to_tum(trajectory)}, {"\n", "#", " ", "1.0e5", "\r\n"}), "tum",
                         [](const std::string& text) {
                           const auto poses = from_tum(text, "text");
                           EXPECT_EQ(poses.size(), from_tum(to_tum(poses), "again").size()) << text;
                         });
}

}  // namespace
}  // namespace ribbon_mapper::mutation
