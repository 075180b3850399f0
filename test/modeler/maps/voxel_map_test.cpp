// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/maps/voxel_map.hpp"

#include <gtest/gtest.h>

#include "modeler/maps/navigation_map.hpp"
#include "modeler/observations/observations.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

struct Maps {
  explicit Maps(const Modeler& modeler, const MapsConfig& config = {})
      : model(modeler.plane_model()),
        sights(sight_lines_of(modeler.observations().posed(), model, config)),
        voxels(make_voxel_map(model.planes, sights, config)),
        level(make_navigation_map(voxels, sights, config)) {}

  VoxelState at(double x, double y, double z) const {
    return voxels[voxel_at(
        Eigen::Vector3d(Eigen::Vector3d(x, y, z) / voxels.voxel_m()).cast<float>())];
  }
  int level_at(double x, double y) const {
    const auto column = static_cast<std::size_t>((x - level.corner_m.x()) / level.cell_m);
    const auto row = static_cast<std::size_t>((y - level.corner_m.y()) / level.cell_m);
    return level.cells.at(row * level.width + column);
  }

  PlaneModel model;
  SightLines sights;
  VoxelMap voxels;
  NavigationMap level;
};

/// A room with a screen of 1 m that stands across it, 1.5 m before the robot.
World room_with_screen() {
  World world = room();
  world.push_back(plane(-Eigen::Vector3d::UnitX(), 1.52, {1.5, -0.5, 0.0}, {1.54, 0.5, 2.0}));
  return world;
}

Maps maps_of(const World& world, const Motion& motion = tilting_in_place()) {
  return Maps(model_of(drive(world, motion, 0.0, 8.0)));
}

TEST(VoxelMap, ARoomIsFreeUpToItsWalls) {
  const Maps maps = maps_of(room());
  EXPECT_EQ(maps.at(1.0, 0.0, 1.0), VoxelState::free);
  EXPECT_EQ(maps.at(2.9, 0.3, 1.0), VoxelState::free);
  std::size_t outside = 0, free = 0;
  maps.voxels.for_each([&](const MapVoxel& voxel, VoxelState state) {
    if (state != VoxelState::free) return;
    ++free;
    const Eigen::Vector3d centre =
        0.05 * Eigen::Vector3d(voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5);
    const bool inside = std::abs(centre.x()) < 3.0 && std::abs(centre.y()) < 2.5 &&
                        centre.z() > 0.0 && centre.z() < 2.5;
    if (!inside) ++outside;
  });
  EXPECT_GT(free, 100000U);
  EXPECT_EQ(outside, 0U);
}

TEST(VoxelMap, NothingIsKnownBehindAScreen) {
  const Maps maps = maps_of(room_with_screen());
  EXPECT_EQ(maps.at(1.4, 0.0, 1.2), VoxelState::free);
  EXPECT_EQ(maps.at(1.52, 0.0, 1.2), VoxelState::occupied);
  EXPECT_EQ(maps.at(2.0, 0.0, 1.2), VoxelState::unknown);
  EXPECT_EQ(maps.at(2.8, 0.2, 1.2), VoxelState::unknown);
  EXPECT_EQ(maps.at(2.0, 1.5, 1.2), VoxelState::free);
}

TEST(VoxelMap, ACorrectedModelHasTheMapOfOneThatNeverDrifted) {
  const Motion drifting{around_the_middle, to_and_fro, wandering_drift};
  const Lines lines = drive(room_with_screen(), drifting, 0.0, 8.0);
  Modeler modeler = model_of(lines);
  const Maps drifted(modeler);
  modeler.correct(true_trajectory(lines));
  const Maps corrected(modeler), exact(model_of(with_true_acquisition_poses(lines)));
  std::size_t all = 0, as_drifted = 0, as_corrected = 0;
  exact.voxels.for_each([&](const MapVoxel& voxel, VoxelState state) {
    ++all;
    if (drifted.voxels[voxel] == state) ++as_drifted;
    if (corrected.voxels[voxel] == state) ++as_corrected;
  });
  // Rounding decides where a fan ends on the border of a voxel.
  EXPECT_GE(static_cast<double>(as_corrected), 0.999 * static_cast<double>(all));
  EXPECT_LT(static_cast<double>(as_drifted), 0.98 * static_cast<double>(all));
}

/// Returns the number of loose returns where the screen of room_with_screen() stands.
int returns_at_screen(const SightLines& sights) {
  const Eigen::AlignedBox3f screen(Eigen::Vector3f(1.4F, -0.4F, 0.2F),
                                   Eigen::Vector3f(1.6F, 0.4F, 1.8F));
  int count = 0;
  for (const LooseReturn& loose : sights.returns) count += screen.contains(loose.point);
  return count;
}

TEST(SightLines, WhatIsGoneHasNoReturns) {
  Lines lines = drive(room_with_screen(), tilting_in_place(), 0.0, 12.0);
  for (const Line& line : drive(room(), tilting_in_place(), 12.0, 24.0)) lines.push_back(line);
  Modeler modeler = model_of(lines);
  modeler.correct(true_trajectory(lines));
  PlaneModel model = modeler.plane_model();
  const PosedObservations observations = modeler.observations().posed();
  const SightLines without = sight_lines_of(observations, model, {});
  model.gone_ribbons.clear();
  const SightLines with = sight_lines_of(observations, model, {});
  EXPECT_GT(returns_at_screen(with), 1000);
  EXPECT_EQ(returns_at_screen(without), 0);
  EXPECT_EQ(without.fans.size(), with.fans.size()) << "its beams were free up to it";
}

TEST(VoxelMap, WithoutLinesItIsEmpty) {
  const Maps maps{Modeler(ModelerConfig{})};
  maps.voxels.for_each([](const MapVoxel&, VoxelState) { FAIL(); });
  EXPECT_EQ(maps.level.width, 0U);
  EXPECT_TRUE(maps.level.cells.empty());
}

TEST(VoxelMap, FarFromTheOriginVoxelsGrow) {
  World far = room();
  for (Face& face : far) {
    face.d_m -= 5e4 * face.normal.x();
    face.bounds.translate(Eigen::Vector3d(5e4, 0.0, 0.0));
  }
  const Maps maps(model_of(drive(
      far, {[](double) { return planar_pose(5e4, 0.0, 0.0); }, to_and_fro, no_drift}, 0.0, 1.0)));
  EXPECT_DOUBLE_EQ(maps.voxels.voxel_m(), 1.6);
  EXPECT_EQ(maps.voxels.origin(), Eigen::Vector3d::Zero());
}

TEST(VoxelMap, OverALargeAreaVoxelsGrow) {
  SightLines sights;
  sights.returns = {{{0.0F, 0.0F, 1.0F}, false}, {{390.0F, 390.0F, 1.0F}, false}};
  sights.lines = {{{1.0F, 0.0F, 1.0F}, 0, 2}};
  const VoxelMap voxels = make_voxel_map({}, sights, {});
  EXPECT_DOUBLE_EQ(voxels.voxel_m(), 0.1);
  EXPECT_LE(make_navigation_map(voxels, sights, {}).cells.size(), 16'000'000U);
}

TEST(NavigationMap, TellsFreeFromOccupiedAndUnknown) {
  const Maps maps = maps_of(room_with_screen());
  EXPECT_EQ(maps.level_at(1.0, 0.3), NavigationMap::kFree);
  EXPECT_EQ(maps.level_at(1.52, 0.0), NavigationMap::kOccupied);
  EXPECT_EQ(maps.level_at(2.2, 0.0), NavigationMap::kUnknown);
  EXPECT_EQ(maps.level_at(2.0, 1.5), NavigationMap::kFree);
}

TEST(NavigationMap, HeightsAreThoseAboveTheRobotsFloor) {
  const auto raised = [](double) -> Pose { return Pose(Eigen::Translation3d(0.0, 0.0, 7.0)); };
  World world = room();
  for (Face& face : world) {
    face.d_m -= 7.0 * face.normal.z();
    face.bounds.translate(Eigen::Vector3d(0.0, 0.0, 7.0));
  }
  const Maps maps = maps_of(world, {raised, to_and_fro, no_drift});
  EXPECT_EQ(maps.level_at(1.0, 0.3), NavigationMap::kFree);
  EXPECT_EQ(maps.level_at(2.0, 1.5), NavigationMap::kFree);
}

}  // namespace
}  // namespace ribbon_mapper
