// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/calibrate.hpp"

#include <gmock/gmock.h>

#include "modeler/io/calibrated_preset.hpp"
#include "modeler/io/config_file.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper::eval {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

RunOptions before_the_wall(double drift) {
  RunOptions run;
  run.route = "worlds/apartment_calibration.route.yaml";
  run.drift = drift;
  return run;
}

Calibration calibration_of(const RunOptions& run) {
  return make_calibration(run, [](const Progress&) {});
}

// The range noise is 1 cm at the wall's distance of 3.4 m; quantisation and incidence hardly
// matter.
TEST(Calibrate, VSensorIsTheNoiseOfTheLaserWhateverTheDrift) {
  const Calibration exact = calibration_of(before_the_wall(0.0));
  const Calibration drifting = calibration_of(before_the_wall(2.0));
  EXPECT_NEAR(exact.plane.d_m, 8.0, 0.01);
  EXPECT_NEAR(std::sqrt(exact.stopped.distance_variance_m2), 0.009, 0.0015);
  EXPECT_NEAR(exact.stopped.tolerance.distance_m, 0.027, 0.0045);
  // Equal but for rounding, as the robot stands elsewhere in map.
  EXPECT_NEAR(exact.stopped.distance_variance_m2, drifting.stopped.distance_variance_m2,
              1e-9 * exact.stopped.distance_variance_m2);
  EXPECT_NEAR(exact.travel_m, 3.2, 0.2);
  EXPECT_NEAR(exact.turn_deg, 110.0, 5.0);
}

TEST(Calibrate, VSlamGrowsWithTheDrift) {
  const Calibration exact = calibration_of(before_the_wall(0.0));
  const Calibration drifting = calibration_of(before_the_wall(2.0));
  EXPECT_NEAR(exact.moving.tolerance.distance_m, exact.stopped.tolerance.distance_m, 0.005);
  EXPECT_GT(drifting.moving.distance_variance_m2, 4.0 * exact.moving.distance_variance_m2);
  EXPECT_GT(drifting.moving.scalar_product_variance, exact.moving.scalar_product_variance);
  EXPECT_GT(drifting.moving.tolerance.angle_deg, exact.moving.tolerance.angle_deg);
}

TEST(Calibrate, WithoutARestOrMotionItSaysWhatToDo) {
  RunOptions run = before_the_wall(0.0);
  run.route = "worlds/apartment.route.yaml";
  EXPECT_THAT([&] { calibration_of(run); },
              ThrowsMessage<std::runtime_error>(HasSubstr("let it stand")));
  const Calibrator unmoved{ModelerConfig()};
  EXPECT_THAT([&] { unmoved.result(); },
              ThrowsMessage<std::runtime_error>(HasSubstr("drive it 3 to 5 m")));
}

Calibration learned() {
  Calibration calibration;
  calibration.stopped.tolerance = {0.7, 0.2};
  calibration.moving.tolerance = {7.5, 0.193456};
  return calibration;
}

TEST(CalibratedPreset, IsLoadedWithEveryKey) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "calibrated.yaml";
  ModelerConfig config;
  config.ribbon.min_points = 9;
  config.scan.deskew = false;
  write_content(path, calibrated_preset(config, learned(), "a bag\nwith: lines"));
  const ModelerConfig loaded = load_config(path.string());
  EXPECT_EQ(loaded.association.slam.angle_deg, 7.5);
  EXPECT_EQ(loaded.association.slam.distance_m, 0.193);
  EXPECT_EQ(loaded.association.corrected.distance_m, 0.2);
  EXPECT_EQ(loaded.association.corrected.angle_deg, config.association.corrected.angle_deg)
      << "never narrower";
  EXPECT_EQ(loaded.ribbon.min_points, 9);
  EXPECT_FALSE(loaded.scan.deskew);
}

TEST(CalibratedPreset, StaysWithinTheAllowedRanges) {
  Calibration wild = learned();
  wild.moving.tolerance = {400.0, 1e-9};
  const ModelerConfig config = with_tolerances(ModelerConfig(), wild);
  EXPECT_NO_THROW(config.validate());
  EXPECT_EQ(config.association.slam.angle_deg, 45.0);
}

TEST(ConfigToYaml, IsReadAsTheSameValues) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "all.yaml";
  ModelerConfig config;
  config.surface.bridged_gap_m = 0.1 + 0.2;  // needs all digits
  config.trajectory.poses_follow = !config.trajectory.poses_follow;
  write_content(path, config_to_yaml(config));
  const ModelerConfig loaded = load_config(path.string());
  EXPECT_EQ(loaded.surface.bridged_gap_m, config.surface.bridged_gap_m);
  EXPECT_EQ(config_to_yaml(loaded), config_to_yaml(config));
  EXPECT_THAT(content_of(path), HasSubstr("\nassociation:\n  slam:\n    angle_deg: 3.2\n"));
}

}  // namespace
}  // namespace ribbon_mapper::eval
