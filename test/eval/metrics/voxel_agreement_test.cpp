// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/voxel_agreement.hpp"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <optional>

#include "eval/experiment/run.hpp"
#include "eval/experiment/self_closure.hpp"
#include "eval/experiment/sim_conversion.hpp"
#include "modeler/maps/model_maps.hpp"
#include "modeler/modeler.hpp"
#include "modeler/observations/observations.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr double kVoxel_m = 0.05;

Eigen::AlignedBox3d box(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return {a, b}; }

TEST(Touches, ATriangleThatCutsACornerOrPassesBeside) {
  const auto corner = [](double sum) {  // the plane x + y + z = sum, around the first diagonal
    return std::array<Eigen::Vector3d, 3>{
        Eigen::Vector3d(sum, 0.0, 0.0), {0.0, sum, 0.0}, {0.0, 0.0, sum}};
  };
  const Eigen::AlignedBox3d unit = box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
  EXPECT_TRUE(touches(corner(0.1), unit));
  EXPECT_TRUE(touches(corner(2.9), unit));
  EXPECT_FALSE(touches(corner(3.1), unit));
  EXPECT_FALSE(touches(corner(-0.1), unit));
}

sim::Triangle wall() {  // x = 1.02, from y = 0 to 1 and z = 0 to 1
  sim::Triangle triangle;
  triangle.corners_m = {Eigen::Vector3d(1.02, 0.0, 0.0), {1.02, 1.0, 0.0}, {1.02, 0.0, 1.0}};
  return triangle;
}

TEST(TrueVoxels, HoldSurfacesAndTheWayOfBeams) {
  TrueVoxels truth(kVoxel_m);
  truth.add_surfaces({wall()}, box({-5.0, -5.0, -5.0}, {5.0, 5.0, 5.0}));
  EXPECT_TRUE(truth.touches_surface({20, 2, 2}));
  EXPECT_TRUE(truth.holds_surface({20, 2, 2}));
  EXPECT_FALSE(truth.touches_surface({19, 2, 2}));
  EXPECT_TRUE(truth.is_near_surface({19, 2, 2}));
  EXPECT_FALSE(truth.is_near_surface({18, 2, 2}));
  EXPECT_FALSE(truth.touches_surface({20, 18, 18})) << "the other half of the square";

  sim::Scan scan;
  scan.rays = {{Eigen::Vector3d(0.01, 0.12, 0.12), Eigen::Vector3d::UnitX()}};
  scan.ranges_m = scan.true_ranges_m = {1.01F};
  truth.add_beams(scan);
  std::size_t free = 0;
  truth.for_each_free([&](const MapVoxel& voxel) {
    ++free;
    EXPECT_EQ(voxel[1], 2);
    EXPECT_EQ(voxel[2], 2);
  });
  EXPECT_EQ(free, 20U) << "the voxel of the wall is none";
  EXPECT_TRUE(truth.was_passed_near({5, 3, 3}));
  EXPECT_FALSE(truth.was_passed_near({5, 4, 2}));
  EXPECT_FALSE(truth.was_passed({22, 2, 2}));
}

TEST(VoxelAgreement, CountsWhatIsWrong) {
  TrueVoxels truth(kVoxel_m);
  truth.add_surfaces({wall()}, box({-5.0, -5.0, -5.0}, {5.0, 5.0, 5.0}));
  VoxelGrid grid;
  grid.at({20, 2, 2}) = static_cast<std::uint8_t>(VoxelState::occupied);
  grid.at({24, 2, 2}) = static_cast<std::uint8_t>(VoxelState::occupied);  // three voxels behind
  grid.at({20, 3, 2}) = static_cast<std::uint8_t>(VoxelState::free);      // on the wall
  grid.at({30, 2, 2}) = static_cast<std::uint8_t>(VoxelState::free);      // no beam came here
  const VoxelAgreement found =
      agreement_of(VoxelMap(kVoxel_m, Eigen::Vector3d::Zero(), std::move(grid)), truth);
  EXPECT_EQ(found.occupied, 2U);
  EXPECT_EQ(found.occupied_near, 1U);
  EXPECT_EQ(found.free, 2U);
  EXPECT_EQ(found.free_on_surface, 1U);
  EXPECT_EQ(found.free_not_passed, 1U);
  EXPECT_EQ(found.free_right(), 0.0);
}

octomap::point3d to_octomap(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// Returns the leaves of a tree as voxels.
VoxelMap voxels_of(const octomap::OcTree& tree) {
  VoxelGrid grid;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const auto side = static_cast<int>(std::lround(leaf.getSize() / kVoxel_m));
    const auto first = [&](double centre) {
      return static_cast<int>(std::lround((centre - 0.5 * leaf.getSize()) / kVoxel_m));
    };
    const VoxelState state = tree.isNodeOccupied(*leaf) ? VoxelState::occupied : VoxelState::free;
    for (int i = 0; i < side * side * side; ++i) {
      grid.at({first(leaf.getX()) + i % side, first(leaf.getY()) + i / side % side,
               first(leaf.getZ()) + i / side / side}) = static_cast<std::uint8_t>(state);
    }
  }
  return {kVoxel_m, Eigen::Vector3d::Zero(), std::move(grid)};
}

/// Where the maps of a tour come from.
struct MappedTour {
  const char* world;    // file of the world
  const char* closure;  // what corrects the trajectory, as RunOptions::closure
};

/// A tour through a world: the truth, the corrected model, and OctoMap's of the same lines at their
/// true poses.
class MapsOfATour : public testing::TestWithParam<MappedTour> {
 protected:
  void SetUp() override {
    RunOptions run;
    run.world = GetParam().world;
    const sim::World world = load_world(run);
    sim::Tour tour(world, load_route(run), tour_config(run));
    Modeler modeler(modeler_config(run));
    std::optional<SelfClosure> slam;
    if (GetParam().closure == std::string("self"))
      slam.emplace(modeler, modeler_config(run), false);
    std::vector<StampedPose> poses;
    while (const auto scan = tour.next_scan()) {
      const LaserBeams beams = beams_of(*scan);
      modeler.add_scan_line(beams, noisy_poses(tour, beams));
      if (slam) slam->update(tour, middle_of(beams));
      poses.push_back({middle_of(beams), tour.true_T_map_base(middle_of(beams))});
      truth_.add_beams(*scan);
      insert(*scan);
    }
    modeler.correct(slam ? slam->finish(tour) : poses);
    const PlaneModel model = modeler.plane_model();
    sights_ = sight_lines_of(modeler.observations().posed(), model, config_);
    maps_.emplace(make_maps(model.planes, sights_, config_));
    truth_.add_surfaces(world.triangles(), extent());
  }

  void insert(const sim::Scan& scan) {
    octomap::Pointcloud cloud;
    for (std::size_t i = 0; i < scan.rays.size(); ++i) {
      const auto range_m = static_cast<double>(scan.ranges_m[i]);
      if (!std::isfinite(range_m)) continue;
      cloud.push_back(to_octomap(scan.rays[i].origin + range_m * scan.rays[i].direction));
    }
    tree_.insertPointCloud(cloud, to_octomap(scan.rays[scan.rays.size() / 2].origin), -1.0, true,
                           true);
  }

  Eigen::AlignedBox3d extent() const {
    Eigen::AlignedBox3d extent;
    maps_->voxels.for_each([&](const MapVoxel& v, VoxelState) {
      extent.extend(kVoxel_m * Eigen::Vector3d(v[0] - 3, v[1] - 3, v[2] - 3));
      extent.extend(kVoxel_m * Eigen::Vector3d(v[0] + 4, v[1] + 4, v[2] + 4));
    });
    return extent;
  }

  MapsConfig config_;
  TrueVoxels truth_{kVoxel_m};
  octomap::OcTree tree_{kVoxel_m};
  SightLines sights_;
  std::optional<ModelMaps> maps_;
};

TEST_P(MapsOfATour, VoxelsAgreeWithTheWorldAsWellAsOctoMaps) {
  tree_.updateInnerOccupancy();
  const VoxelAgreement ours = agreement_of(maps_->voxels, truth_);
  const VoxelAgreement octomap = agreement_of(voxels_of(tree_), truth_);
  EXPECT_GE(ours.occupied_right(), 0.97);
  EXPECT_EQ(ours.free_not_passed, 0U) << "free space behind a surface";
  EXPECT_GE(ours.free_right(), octomap.free_right() - 0.001);
  EXPECT_GE(ours.free_found(), octomap.free_found() - 0.01);
  EXPECT_GT(ours.truly_free, 50000U);
}

TEST_P(MapsOfATour, TheLevelMapAgreesWithTheWorldsCut) {
  const LevelAgreement level =
      agreement_of(maps_->level, truth_, config_.obstacle_min_m, config_.obstacle_max_m);
  EXPECT_GE(level.right(), 0.97);
  EXPECT_GT(level.free, 1000U);
  EXPECT_GT(level.occupied, 200U);
}

INSTANTIATE_TEST_SUITE_P(Worlds, MapsOfATour,
                         testing::Values(MappedTour{"test/ros/room.sdf", "truth"},
                                         MappedTour{"worlds/doorways.sdf", "truth"},
                                         MappedTour{"test/ros/room.sdf", "self"}));

}  // namespace
}  // namespace ribbon_mapper::eval
