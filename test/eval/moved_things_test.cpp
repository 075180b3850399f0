// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "eval/experiment/run.hpp"
#include "eval/experiment/sim_conversion.hpp"
#include "modeler/maps/model_maps.hpp"
#include "modeler/modeler.hpp"
#include "modeler/observations/observations.hpp"
#include "test/io/environment_number.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr const char* kBefore = "test/data/moved/before.sdf";
constexpr const char* kAfter = "test/data/moved/after.sdf";

/// Returns how many seeds are tried: three, or as many as RIBBON_MAPPER_SEEDS says.
int number_of_seeds() { return environment_number("RIBBON_MAPPER_SEEDS", 3); }

/// A tour in two laps: somebody moves a cupboard and a chair and opens a door between them.
class MovedThings : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    run_.world = kBefore;
    run_.seed = static_cast<std::uint64_t>(GetParam());
    const sim::World before = load_world(run_), after = load_world(after_run());
    const sim::Route route = load_route(run_);
    const sim::Tour first(before, route, tour_config(run_)),
        second(after, route, tour_config(run_));
    static std::map<int, Models> models_by_seed;  // a tour takes seconds
    const auto known = models_by_seed.find(GetParam());
    models_ = known != models_by_seed.end()
                  ? &known->second
                  : &models_by_seed.emplace(GetParam(), modelled(first, second)).first->second;
  }

  /// The corrected models of both laps: one keeps all that was seen.
  struct Models {
    Modeler all, modeler;
  };

  RunOptions after_run() const {
    RunOptions run = run_;
    run.world = kAfter;
    return run;
  }

  Models modelled(const sim::Tour& first, const sim::Tour& second) const {
    const ModelerConfig config = modeler_config(run_);
    ModelerConfig keeps_all = config;
    keeps_all.assembly.passed_lines = 0;
    Models models{Modeler(keeps_all), Modeler(config)};
    std::vector<StampedPose> poses;
    for (std::size_t i = 0; i < first.line_count(); ++i) {
      const sim::Scan scan = (i < first.line_count() / 2 ? first : second).scan(i);
      const LaserBeams beams = beams_of(scan);
      const LinePoses line_poses = noisy_poses(first, beams);
      models.all.add_scan_line(beams, line_poses);
      models.modeler.add_scan_line(beams, line_poses);
      poses.push_back({middle_of(beams), first.true_T_map_base(middle_of(beams))});
    }
    models.all.correct(poses);
    models.modeler.correct(poses);
    return models;
  }

  RunOptions run_;
  const Models* models_ = nullptr;
};

/// Returns the area of planes like n . p + d = 0.
double area_m2(const std::vector<Plane>& planes, const Eigen::Vector3d& normal, double d_m) {
  double sum_m2 = 0.0;
  for (const Plane& plane : planes) {
    if (plane.normal.dot(normal) > 0.99 && std::abs(plane.d_m - d_m) < 0.05) {
      sum_m2 += plane.area_m2;
    }
  }
  return sum_m2;
}

TEST_P(MovedThings, PlanesAreThoseOfTheEnd) {
  const std::vector<Plane> all = models_->all.planes(), planes = models_->modeler.planes();
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
  EXPECT_GT(area_m2(all, -y, 2.45), 2.0) << "the cupboard was never seen";
  EXPECT_EQ(area_m2(planes, -y, 2.45), 0.0) << "the front of the cupboard where it was";
  EXPECT_EQ(area_m2(planes, x, 2.4), 0.0) << "its side";
  EXPECT_GT(area_m2(planes, x, 5.35), 2.0) << "the front of the cupboard where it is";
  EXPECT_GT(area_m2(planes, -y, 0.5), 1.5) << "the open leaf";
  EXPECT_GT(area_m2(all, -x, 1.9) - area_m2(planes, -x, 1.9), 1.2) << "the closed leaf";
}

TEST_P(MovedThings, NothingStaticIsLost) {
  const std::vector<Plane> planes = models_->modeler.planes();
  for (const Plane& plane : models_->all.planes()) {
    const bool has_moved = area_m2({plane}, -Eigen::Vector3d::UnitY(), 2.45) > 0.0 ||
                           area_m2({plane}, Eigen::Vector3d::UnitX(), 2.4) > 0.0 ||
                           area_m2({plane}, -Eigen::Vector3d::UnitX(), 1.9) > 0.0;
    if (has_moved) continue;
    EXPECT_EQ(area_m2(planes, plane.normal, plane.d_m),
              area_m2(models_->all.planes(), plane.normal, plane.d_m))
        << plane.normal.transpose() << " at " << plane.centroid.transpose();
  }
}

TEST_P(MovedThings, TheLevelMapIsThatOfTheEnd) {
  const PlaneModel model = models_->modeler.plane_model();
  const PosedObservations observations = models_->modeler.observations().posed();
  const MapsConfig config;
  const NavigationMap map =
      make_maps(model.planes, sight_lines_of(observations, model, config), config).level;
  const auto occupied_near = [&](double x, double y) {
    int count = 0;
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
      const double dx =
          map.corner_m.x() + map.cell_m * (static_cast<double>(i % map.width) + 0.5) - x;
      const double dy =
          map.corner_m.y() + map.cell_m * (static_cast<double>(i / map.width) + 0.5) - y;
      if (std::max(std::abs(dx), std::abs(dy)) < 0.2 && map.cells[i] == NavigationMap::kOccupied) {
        ++count;
      }
    }
    return count;
  };
  // 64 columns each. A few are passed by less than three lines once things have moved.
  EXPECT_LE(occupied_near(-0.5, -2.2), 5) << "the chair where it was";
  EXPECT_GE(occupied_near(-2.5, -2.2), 10) << "the chair where it is";
  EXPECT_LE(occupied_near(-3.0, 2.4), 5) << "the cupboard where it was";
  EXPECT_GE(occupied_near(-5.4, -1.0), 8) << "the cupboard where it is";
}

INSTANTIATE_TEST_SUITE_P(Seeds, MovedThings, testing::Range(1, number_of_seeds() + 1));

}  // namespace
}  // namespace ribbon_mapper::eval
