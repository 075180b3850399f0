// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A model that was saved and loaded is the one that never left memory, to the byte.
#include "modeler/model_file/model_file.hpp"

#include <gmock/gmock.h>

#include "modeler/io/planes_json.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/modeler/mini_world.hpp"
#include "test/modeler/plane_matchers.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

const Lines& tour() {
  static const Lines lines =
      drive(room(), {around_the_middle, to_and_fro, wandering_drift}, 0.0, 15.0);
  return lines;
}

Lines part(std::size_t begin, std::size_t end) {
  return {tour().begin() + static_cast<std::ptrdiff_t>(begin),
          tour().begin() + static_cast<std::ptrdiff_t>(end)};
}

void add(const Lines& lines, Modeler& modeler) {
  for (const Line& line : lines) modeler.add_scan_line(line.beams, line.poses);
}

Modeler reloaded(const Modeler& modeler) {
  ModelFile file = from_model_file(to_model_file(modeler));
  return Modeler(file.config, std::move(file.model));
}

/// Expects the same planes, trajectory and counts, and the same bytes in a file.
void expect_equal(const Modeler& expected, const Modeler& actual) {
  EXPECT_EQ(planes_to_json(expected.planes()), planes_to_json(actual.planes()));
  EXPECT_EQ(bytes_of(expected.planes()), bytes_of(actual.planes()));
  EXPECT_EQ(bytes_of(expected.planes_as_built()), bytes_of(actual.planes_as_built()));
  EXPECT_EQ(to_model_file(expected), to_model_file(actual));
}

struct History {
  const char* name;
  bool poses_follow;
  int max_ribbons;
  std::size_t pose_stride;  ///< of the first correction; 0: there is none
};
class Histories : public testing::TestWithParam<History> {
 protected:
  /// Returns a model with lines before and after a correction, if there is one.
  static Modeler model() {
    ModelerConfig config;
    config.trajectory.poses_follow = GetParam().poses_follow;
    config.observations.max_ribbons = GetParam().max_ribbons;
    config.association.checkpoint_ribbons = 0;  // or corrections may cost the one less
    Modeler modeler(config);
    add(part(0, 300), modeler);
    if (GetParam().pose_stride > 0) {
      modeler.correct(true_trajectory(part(0, 290), GetParam().pose_stride));
    }
    add(part(300, 350), modeler);
    return modeler;
  }
};

TEST_P(Histories, SavedAndLoadedGiveTheSameBytes) {
  const Modeler modeler = model();
  expect_equal(modeler, reloaded(modeler));
  EXPECT_EQ(GetParam().max_ribbons > 0, modeler.statistics().thinned > 0);
}

TEST_P(Histories, TakeACorrectionAsIfTheyHadNeverLeftMemory) {
  for (const std::size_t stride : {1, 40}) {
    Modeler modeler = model(), other = reloaded(modeler);
    const auto trajectory = true_trajectory(part(0, 340), stride);
    modeler.correct(trajectory);
    other.correct(trajectory);
    expect_equal(modeler, other);
    modeler.correct(true_trajectory(part(0, 200), 10));
    other.correct(true_trajectory(part(0, 200), 10));
    expect_equal(modeler, other);
  }
}

TEST_P(Histories, TakeLinesAsIfTheyHadNeverLeftMemory) {
  Modeler modeler = model(), other = reloaded(modeler);
  add(part(350, 450), modeler);
  add(part(350, 450), other);
  expect_equal(modeler, other);
  modeler.correct(true_trajectory(part(0, 440)));
  other.correct(true_trajectory(part(0, 440)));
  expect_equal(modeler, other);
}

INSTANTIATE_TEST_SUITE_P(ModelFile, Histories,
                         testing::Values(History{"recorded", true, 0, 0},
                                         History{"corrected", true, 0, 1},
                                         History{"drifts_on", false, 0, 1},
                                         History{"registered", true, 0, 40},
                                         History{"thinned", true, 500, 0},
                                         History{"corrected_and_thinned", false, 500, 40}),
                         [](const auto& each) { return std::string(each.param.name); });

std::vector<LineResult> results_of(const Lines& lines, Modeler& modeler) {
  std::vector<LineResult> results;
  for (const Line& line : lines) results.push_back(modeler.add_scan_line(line.beams, line.poses));
  return results;
}

TEST(ModelFile, GoesOnWhereARecordingIsPlayedFromItsStart) {
  Modeler modeler = model_of(part(0, 200)), other = reloaded(modeler);
  EXPECT_THAT(results_of(part(0, 200), other), testing::Each(LineResult::out_of_order));
  add(part(200, 300), modeler);
  add(part(200, 300), other);
  EXPECT_EQ(bytes_of(modeler.planes()), bytes_of(other.planes()));
}

/// Returns the lines as odometry has them that has begun anew, so much later.
Lines of_new_odometry(Lines lines, Time later) {
  const Pose T_new_old = lines.front().poses.T_odom_base_first.inverse(Eigen::Isometry);
  for (Line& line : lines) {
    line.beams.stamp += later;
    line.poses.T_odom_base_first = T_new_old * line.poses.T_odom_base_first;
    line.poses.T_odom_base_last = T_new_old * line.poses.T_odom_base_last;
  }
  return lines;
}

TEST(ModelFile, DoesNotPairLinesBeforeAndAfterAPause) {
  const Lines later = of_new_odometry(part(200, 300), std::chrono::seconds(60));
  const Modeler alone = model_of(later), before = model_of(part(0, 200));
  Modeler modeler = reloaded(before);
  add(later, modeler);
  EXPECT_EQ(before.ribbons().size() + alone.ribbons().size(), modeler.ribbons().size());
  const auto trajectory = modeler.trajectory(), of_alone = alone.trajectory();
  ASSERT_EQ(before.trajectory().size() + of_alone.size(), trajectory.size());
  EXPECT_EQ(of_alone.front().stamp, trajectory[before.trajectory().size()].stamp);
}

TEST(ModelFile, OfOtherGatesIsTheModelThatTheyMake) {
  ModelerConfig wide;
  wide.association.slam = {10.0, 0.5};
  ModelFile file = from_model_file(to_model_file(model_of(part(0, 300))));
  const Modeler modeler(wide, std::move(file.model));
  EXPECT_EQ(bytes_of(anonymous(model_of(part(0, 300), wide).planes())),
            bytes_of(anonymous(modeler.planes())));
}

TEST(ModelFile, CanBeEmpty) {
  const Modeler empty{ModelerConfig{}};
  Modeler other = reloaded(empty);
  expect_equal(empty, other);
  add(part(0, 100), other);
  expect_equal(model_of(part(0, 100)), other);
}

}  // namespace
}  // namespace ribbon_mapper
