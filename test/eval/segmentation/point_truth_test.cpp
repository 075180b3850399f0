// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/segmentation/point_truth.hpp"

#include <gmock/gmock.h>

#include "eval/experiment/run.hpp"
#include "eval/experiment/sim_conversion.hpp"

namespace ribbon_mapper::eval {
namespace {

/// A tour of a bare room with the face that every beam hit. As the room has one true plane per
/// face, faces are an independent source of the points' labels.
struct RoomTour {
  RoomTour() {
    RunOptions run;
    run.world = "test/ros/room.sdf";
    run.drift = 0.0;
    const sim::World world = load_world(run);
    sim::Tour tour(world, load_route(run), tour_config(run));
    sim::TruthCollector collector(world);
    while (const std::optional<sim::Scan> scan = tour.next_scan()) {
      const LaserBeams beams = beams_of(*scan);
      const Time middle = middle_of(beams);
      modeler.add_scan_line(beams, noisy_poses(tour, beams));
      truth.add(middle, collector.add(*scan));
      faces[middle] = scan->faces;
    }
    true_planes = collector.planes();
    truth.settle(true_planes);
    planes = modeler.planes();
  }

  /// Returns the number of points in ribbons of `plane` that lie on faces of `true_plane`.
  std::size_t shared(const Plane& plane, const sim::TruthPlane& true_plane) const {
    std::size_t count = 0;
    for (const std::uint32_t index : plane.ribbons) {
      const Ribbon& ribbon = modeler.ribbons()[index];
      const std::vector<int>& hit = faces.at(modeler.trajectory()[ribbon.pose].stamp);
      for (std::size_t beam = ribbon.first_beam; beam <= ribbon.last_beam; ++beam) {
        for (const int face : true_plane.faces) count += face == hit[beam] ? 1 : 0;
      }
    }
    return count;
  }

  Modeler modeler{ModelerConfig()};
  PointTruth truth;
  std::map<Time, std::vector<int>> faces;
  std::vector<sim::TruthPlane> true_planes;
  std::vector<Plane> planes;
};

/// Shares one tour among all tests, which do not change it.
class PointTruthInARoom : public testing::Test {
 protected:
  static void SetUpTestSuite() { tour_ = std::make_unique<RoomTour>(); }
  static void TearDownTestSuite() { tour_.reset(); }
  Overlaps overlaps(const std::vector<Plane>& planes, PointTruth::Points which) const {
    return tour_->truth.overlaps(tour_->modeler, planes, which);
  }

  static std::unique_ptr<RoomTour> tour_;
};

std::unique_ptr<RoomTour> PointTruthInARoom::tour_;

TEST_F(PointTruthInARoom, RibbonsAreRelatedToBeamsByStamp) {
  const Overlaps found = overlaps(tour_->planes, PointTruth::Points::of_ribbons);
  ASSERT_EQ(found.truth(), 5U);
  ASSERT_EQ(found.estimates(), 5U);
  for (std::size_t t = 0; t < found.truth(); ++t) {
    for (std::size_t e = 0; e < found.estimates(); ++e) {
      EXPECT_EQ(found.shared(t, e), tour_->shared(tour_->planes[e], tour_->true_planes[t]))
          << t << ", " << e;
    }
  }
}

TEST_F(PointTruthInARoom, ThePlanesOfTheRoomAreRight) {
  for (const auto which : {PointTruth::Points::of_ribbons, PointTruth::Points::all}) {
    const SegComp s = segcomp(overlaps(tour_->planes, which));
    EXPECT_EQ(s.correct, 5U);
    EXPECT_EQ(s.estimates, 5U);
  }
}

// The range noise is 1 cm, and lines are some centimetres apart.
TEST_F(PointTruthInARoom, RibbonsLieOnTheirTruePlanes) {
  const auto errors = tour_->truth.ribbon_errors(tour_->modeler);
  ASSERT_TRUE(errors);
  EXPECT_GT(errors->angle_deg, 0.01);
  EXPECT_LT(errors->angle_deg, 2.0);
  EXPECT_GT(errors->distance_m, 1e-5);
  EXPECT_LT(errors->distance_m, 0.005);
  EXPECT_FALSE(tour_->truth.ribbon_errors(Modeler{ModelerConfig()}));
}

TEST_F(PointTruthInARoom, ReturnsOfNoRibbonCountOnlyAmongAll) {
  const Overlaps ribbons = overlaps({}, PointTruth::Points::of_ribbons);
  const Overlaps all = overlaps({}, PointTruth::Points::all);
  std::size_t of_ribbons = 0, of_all = 0, hits = 0;
  for (std::size_t t = 0; t < all.truth(); ++t) {
    of_ribbons += ribbons.truth_points(t);
    of_all += all.truth_points(t);
  }
  for (const StampedPose& pose : tour_->modeler.trajectory()) {
    for (const int face : tour_->faces.at(pose.stamp)) hits += face >= 0 ? 1 : 0;
  }
  EXPECT_LT(of_ribbons, of_all);
  EXPECT_EQ(of_all, hits) << "every face of the room is part of a true plane";
}

}  // namespace
}  // namespace ribbon_mapper::eval
