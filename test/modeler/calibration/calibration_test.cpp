// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/calibration/calibration.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "modeler/config_keys.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper {
namespace {

using mini_world::Motion;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kRest_s = 8.0;

/// Stands for some seconds, then drives along y and turns to and fro, facing +x.
Pose rest_then_drive(double time_s) {
  const double moving_s = std::max(0.0, time_s - kRest_s);
  return planar_pose(0.0, 0.3 * std::sin(moving_s), 0.15 * std::sin(2.0 * moving_s));
}

Pose at_rest(double) { return Pose::Identity(); }

Calibrator calibrator_after(const mini_world::PoseByTime& path, double seconds) {
  const Motion motion{path, mini_world::to_and_fro, mini_world::no_drift};
  Calibrator calibrator{ModelerConfig{}};
  for (const mini_world::Line& line : mini_world::drive(mini_world::room(), motion, 0.0, seconds)) {
    calibrator.add(line.beams, line.poses);
  }
  return calibrator;
}

TEST(Calibrator, MeasuresTheDeviationOfRibbonsFromThePlaneAhead) {
  const Calibration calibration = calibrator_after(rest_then_drive, 24.0).result();
  EXPECT_LT((calibration.plane.normal + Eigen::Vector3d::UnitX()).norm(), 0.01);
  // The mini world's ranges have a sigma of 5 mm.
  EXPECT_NEAR(std::sqrt(calibration.stopped.distance_variance_m2), 0.005, 0.002);
  EXPECT_NEAR(calibration.stopped.tolerance.distance_m,
              3.0 * std::sqrt(calibration.stopped.distance_variance_m2), 1e-9);
  EXPECT_NEAR(calibration.stopped.tolerance.angle_deg * M_PI / 180.0,
              3.0 * std::sqrt(calibration.stopped.angle_variance_rad2), 1e-9);
  EXPECT_GE(calibration.stopped.ribbons, 100U);
  EXPECT_GE(calibration.moving.ribbons, 100U);
  EXPECT_GT(calibration.travel_m, 1.0);
  EXPECT_THAT(calibration_table(calibration), HasSubstr("stopped"));
}

TEST(Calibrator, CountsLinesAtRestUntilTheFirstMotion) {
  EXPECT_FALSE(calibrator_after(at_rest, 4.0).has_rested());
  EXPECT_TRUE(calibrator_after(at_rest, 6.0).has_rested());
  const Calibrator moved = calibrator_after(rest_then_drive, 12.0);
  EXPECT_NEAR(40.0 * kRest_s, static_cast<double>(moved.lines_stopped()), 2.0);
}

TEST(Calibrator, SaysWhatIsMissing) {
  const auto expect_complaint = [](const Calibrator& calibrator, const char* what) {
    EXPECT_THAT([&] { calibrator.result(); }, ThrowsMessage<std::runtime_error>(HasSubstr(what)));
  };
  expect_complaint(calibrator_after(at_rest, 1.0), "has not moved yet");
  expect_complaint(calibrator_after(mini_world::around_the_middle, 4.0), "let it stand for 200");
  expect_complaint(calibrator_after(rest_then_drive, kRest_s + 1.0), "hardly moved");
}

Calibration learned(const AssociationGates& stopped, const AssociationGates& moving) {
  Calibration calibration;
  calibration.stopped.tolerance = stopped;
  calibration.moving.tolerance = moving;
  return calibration;
}

/// The allowed range of a key.
struct RangeOf {
  std::string key;
  double min = NAN, max = NAN;
  void operator()(const char* name, double, double min_, double max_) {
    if (name == key) min = min_, max = max_;
  }
  void operator()(const char*, bool) {}
};

RangeOf range_of(const std::string& key) {
  RangeOf range{key};
  const ModelerConfig config;
  visit_keys(config, range);
  return range;
}

TEST(WithTolerances, AreLimitedToTheRangesOfTheirKeys) {
  const ModelerConfig wide = with_tolerances({}, learned({400.0, 1e6}, {400.0, 1e6}));
  EXPECT_EQ(range_of("association.slam.angle_deg").max, wide.association.slam.angle_deg);
  EXPECT_EQ(range_of("association.slam.distance_m").max, wide.association.slam.distance_m);
  EXPECT_EQ(range_of("association.corrected.angle_deg").max, wide.association.corrected.angle_deg);
  const ModelerConfig narrow = with_tolerances({}, learned({0.0, 0.0}, {0.0, 0.0}));
  EXPECT_EQ(range_of("association.slam.angle_deg").min, narrow.association.slam.angle_deg);
  EXPECT_EQ(range_of("association.slam.distance_m").min, narrow.association.slam.distance_m);
  EXPECT_NO_THROW(narrow.validate());
  EXPECT_NO_THROW(wide.validate());
}

TEST(WithTolerances, WidenTheGatesAfterACorrectionOnly) {
  const AssociationGates before = ModelerConfig{}.association.corrected;
  const ModelerConfig config = with_tolerances({}, learned({0.5, 0.2}, {4.0, 0.1}));
  EXPECT_EQ(before.angle_deg, config.association.corrected.angle_deg);
  EXPECT_EQ(0.2, config.association.corrected.distance_m);
  EXPECT_EQ(4.0, config.association.slam.angle_deg);
  EXPECT_EQ(0.1, config.association.slam.distance_m);
}

}  // namespace
}  // namespace ribbon_mapper
