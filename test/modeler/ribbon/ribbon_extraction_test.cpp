// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/ribbon_extraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "modeler/geometry/angles.hpp"
#include "modeler/observations/posed_ribbon.hpp"
#include "test/modeler/ribbon/three_lines.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

/// Returns the configuration for a laser with less noise than the default.
ScanConfig precise() {
  ScanConfig config;
  config.range_sigma_m = 0.005;
  return config;
}

/// Returns the ribbons of the middle line; their samples last as long as the test.
std::vector<Ribbon> ribbons_of(const ThreeLines& lines, const RibbonConfig& config = {}) {
  static std::vector<std::unique_ptr<RibbonExtraction>> extractions;  // own the samples
  extractions.push_back(std::make_unique<RibbonExtraction>(precise(), config));
  return extractions.back()->extract(lines).ribbons;
}

/// Returns three lines of a laser with little noise.
LineTriple precise_lines(const World& world, const Motion& motion, double middle_s = 0.0) {
  return three_lines(world, motion, middle_s, {361, 0.005, 3}, precise());
}

/// Returns the azimuth of a beam.
double azimuth_rad(std::uint32_t beam) { return -M_PI_2 + beam * M_PI / 360.0; }

/// Returns the face that a ribbon lies on, or null.
const Face* face_of(const World& world, const Ribbon& ribbon, const Pose& T_map_base,
                    double angle_deg = 5.0) {
  const Eigen::Vector3d normal = T_map_base.linear() * ribbon.normal.cast<double>();
  const Eigen::Vector3d centroid = T_map_base * ribbon.moments.mean();
  for (const Face& face : world) {
    if (face.normal.dot(normal) > std::cos(angle_deg * kDegree) &&
        std::abs(face.normal.dot(centroid) + face.d_m) < 0.01) {
      return &face;
    }
  }
  return nullptr;
}

TEST(RibbonExtraction, FindsOneRibbonPerWallBetweenCorners) {
  const auto ribbons = ribbons_of(precise_lines(room(), tilting(0.8)));
  ASSERT_EQ(3u, ribbons.size());
  const double corner = std::atan2(2.5, 3.0);
  EXPECT_NEAR(-corner, azimuth_rad(ribbons[0].last_beam), 1.5 * kDegree);
  EXPECT_NEAR(-corner, azimuth_rad(ribbons[1].first_beam), 1.5 * kDegree);
  EXPECT_NEAR(corner, azimuth_rad(ribbons[1].last_beam), 1.5 * kDegree);
  EXPECT_NEAR(corner, azimuth_rad(ribbons[2].first_beam), 1.5 * kDegree);
  EXPECT_NEAR(5.0, ribbons[1].samples.length_m(), 0.2);
  EXPECT_GT(std::abs(ribbons[1].along.y()), 0.999);
}

TEST(RibbonExtraction, PutsRibbonsOnTheirFacesInTheFrameOfTheirPose) {
  const World world = room();
  const Pose T_map_base = planar_pose(0.4, -0.3, 0.7);
  for (const double tilt_rad : {-0.3, 0.0, 0.4}) {
    const auto ribbons = ribbons_of(precise_lines(world, tilting(0.8, tilt_rad, T_map_base)));
    EXPECT_GE(ribbons.size(), 2u);
    for (const Ribbon& ribbon : ribbons) {
      const Face* face = face_of(world, ribbon, T_map_base);
      ASSERT_TRUE(face) << "tilt " << tilt_rad << ", from beam " << ribbon.first_beam;
      const Moments moments = ribbon.moments.transformed(T_map_base);
      EXPECT_LT(moments.mean_square_distance(face->normal, face->d_m), 0.008 * 0.008);
      EXPECT_NEAR(0.0, ribbon.normal.dot(ribbon.along), 0.02);
    }
  }
}

TEST(RibbonExtraction, GivesMomentsWhosePlaneIsTheRibbons) {
  for (const Ribbon& ribbon : ribbons_of(precise_lines(room(), tilting(0.8)))) {
    EXPECT_GT(std::abs(fit_plane(ribbon.moments.transformed(Pose::Identity()))
                           .normal()
                           .dot(ribbon.normal.cast<double>())),
              0.999);
    EXPECT_NEAR(ribbon.last_beam - ribbon.first_beam + 1.0, ribbon.moments.weight(), 1e-9);
  }
}

TEST(RibbonExtraction, PutsEachReturnInOneRibbonOrAmongTheUnassigned) {
  const LineTriple lines = precise_lines(room(), {around_the_middle, to_and_fro, no_drift}, 1.7);
  RibbonExtraction extraction(precise(), {});
  const LineObservations& line = extraction.extract(lines);
  double points = 0.0;
  for (const Ribbon& ribbon : line.ribbons) {
    double samples = 0.0;
    ribbon.samples.for_each([&](float, float, std::uint32_t count) { samples += count; });
    EXPECT_EQ(ribbon.moments.weight(), samples);
    points += samples;
  }
  for (const PackedPoint& point : line.unassigned) points += point.count;
  EXPECT_EQ(lines.middle.moments(0, 361).weight(), points);
}

/// Returns a table in the corner of two walls, which is seen from above and far away.
World table_in_a_corner() {
  return {plane(-Eigen::Vector3d::UnitX(), 4.8), plane(-Eigen::Vector3d::UnitY(), 0.8),
          plane(Eigen::Vector3d::UnitZ(), -0.75, {3.4, -0.6, 0}, {4.8, 0.8, 2}),
          plane(Eigen::Vector3d::UnitZ(), 0.0)};
}

/// Returns how far the highest sample of a ribbon on the table lies above it, on average over
/// ribbons [m].
double highest_over_the_table_m(const ScanConfig& scan) {
  double sum_m = 0.0;
  int ribbons = 0;
  for (unsigned i = 0; i < 12; ++i) {
    const LineTriple lines = three_lines(table_in_a_corner(), tilting(0.3, 0.1 + 0.002 * i), 0.0,
                                         {721, 0.01, 3 + i}, scan);
    RibbonExtraction extraction(scan, {});
    for (const Ribbon& source : extraction.extract(lines).ribbons) {
      const PosedRibbon ribbon(source, Pose::Identity());
      if (ribbon.normal.z() < 0.97 || std::abs(ribbon.centroid.z() - 0.75) > 0.05) continue;
      double highest_m = 0.0;
      source.samples.for_each([&](float along_m, float height_m, std::uint32_t) {
        highest_m = std::max(highest_m, ribbon.point(along_m, height_m).z() - 0.75);
      });
      sum_m += highest_m;
      ++ribbons;
    }
  }
  EXPECT_GT(ribbons, 8);
  return sum_m / ribbons;
}

TEST(RibbonExtraction, SeparatesTheBaseOfTheWallBehindAtAGrazingAngle) {
  ScanConfig scan, as_if_seen_from_above;
  as_if_seen_from_above.direction_sigma_deg = 0.25;  // makes both errors similar
  EXPECT_LT(highest_over_the_table_m(scan), 0.02);
  EXPECT_GT(highest_over_the_table_m(as_if_seen_from_above), 0.03);
}

TEST(RibbonExtraction, CapsTheAreaOfFarRibbons) {
  const World far{plane(-Eigen::Vector3d::UnitX(), 20.0)};
  const auto ribbons = ribbons_of(precise_lines(far, tilting(0.8)));
  ASSERT_FALSE(ribbons.empty());
  for (const Ribbon& ribbon : ribbons) {
    EXPECT_NEAR(RibbonConfig{}.area_cap_m2 * ribbon.moments.weight(), ribbon.area_m2, 1e-6);
  }
}

/// Returns a wall that steps back by 9 cm at y = 0, too little for a jump in depth.
World stepped_wall() {
  return {plane(-Eigen::Vector3d::UnitX(), 3.0, {0, -9, -9}, {9, 0, 9}),
          plane(-Eigen::Vector3d::UnitX(), 3.09, {0, 0, -9}, {9, 9, 9})};
}

TEST(RibbonExtraction, SplitsParallelFacesByDistance) {
  const World world = stepped_wall();
  const LineTriple lines = precise_lines(world, tilting(0.8));
  ASSERT_GT(lines.middle.end_of_segment[175], 190u);  // one segment for both
  const auto ribbons = ribbons_of(lines);
  ASSERT_EQ(2u, ribbons.size());
  EXPECT_EQ(&world[0], face_of(world, ribbons[0], Pose::Identity()));
  EXPECT_EQ(&world[1], face_of(world, ribbons[1], Pose::Identity()));
  EXPECT_NEAR(180.0, ribbons[0].last_beam, 2.0);
  EXPECT_NEAR(180.0, ribbons[1].first_beam, 2.0);
  RibbonConfig undivided;
  undivided.distance_gap_m = 10.0;
  EXPECT_NE(2u, ribbons_of(lines, undivided).size());
}

/// Returns the number of ribbons that lie on neither face while lines pass the edge of a floor.
int count_ribbons_across_edge(const RibbonConfig& config) {
  const Eigen::Vector3d corner(9.0, 1.5, 9.0);
  const World world{plane(-Eigen::Vector3d::UnitX(), 3.0, -corner, corner),
                    plane(Eigen::Vector3d::UnitZ(), 0.0, -corner, corner)};
  int count = 0;
  for (double tilt_rad = 0.35; tilt_rad < 0.41; tilt_rad += 0.00025) {
    const LineTriple lines = precise_lines(world, tilting(0.8, tilt_rad));
    for (const Ribbon& ribbon : ribbons_of(lines, config)) {
      count += face_of(world, ribbon, Pose::Identity(), 12.0) == nullptr;
    }
  }
  return count;
}

TEST(RibbonExtraction, RejectsRibbonsAcrossAnEdge) {
  RibbonConfig tolerant;  // the rest is removed as spurious planes
  tolerant.edge_sigmas = 100.0;
  tolerant.edge_slack_m = 1.0;
  const int without_check = count_ribbons_across_edge(tolerant);
  EXPECT_GT(without_check, 8);
  EXPECT_LT(count_ribbons_across_edge({}), without_check / 4);
}

/// Returns lines with mixed pixels at a horizontal edge: each line sees the wall further away.
LineTriple mixed_pixels() {
  std::vector<Line> lines;
  for (int k = 0; k < 3; ++k) {
    const double depth_m = 2.0 + 0.5 * k, tilt_rad = std::atan2(0.02 * k, depth_m);
    const World wall{plane(-Eigen::Vector3d::UnitX(), depth_m)};
    lines.push_back(drive(wall, tilting(0.0, tilt_rad), 0.0, 0.02, {361, 0.002, 1}).front());
  }
  return placed(lines, precise());
}

TEST(RibbonExtraction, RejectsMixedPixelsAlongTheBeams) {
  RibbonConfig tolerant;
  tolerant.min_grazing_angle_deg = 0.0;
  EXPECT_FALSE(ribbons_of(mixed_pixels(), tolerant).empty());
  EXPECT_TRUE(ribbons_of(mixed_pixels()).empty());
}

TEST(RibbonExtraction, RejectsShortRibbons) {
  const auto board = [](double width_m) {
    const Eigen::Vector3d corner(9.0, 0.5 * width_m, 9.0);
    return World{plane(-Eigen::Vector3d::UnitX(), 1.0, -corner, corner)};
  };
  EXPECT_TRUE(ribbons_of(precise_lines(board(0.09), tilting(0.8))).empty());
  const auto ribbons = ribbons_of(precise_lines(board(0.3), tilting(0.8)));
  ASSERT_EQ(1u, ribbons.size());
  EXPECT_NEAR(0.3, ribbons[0].samples.length_m(), RibbonConfig{}.sample_length_m);
}

TEST(RibbonExtraction, FindsNothingWithoutReturns) {
  EXPECT_TRUE(ribbons_of(precise_lines({}, tilting(0.8))).empty());
}

TEST(RibbonExtraction, IsIndependentOfFormerLines) {
  const LineTriple a = precise_lines(room(), tilting(0.8, 0.2));
  const LineTriple b = precise_lines(stepped_wall(), tilting(0.8));
  RibbonExtraction extraction(precise(), {});
  const std::vector<Ribbon> first = extraction.extract(a).ribbons;
  extraction.extract(b);
  const std::vector<Ribbon> again = extraction.extract(a).ribbons;
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].first_beam, again[i].first_beam);
    EXPECT_EQ(first[i].last_beam, again[i].last_beam);
    EXPECT_EQ(first[i].normal, again[i].normal);
    EXPECT_EQ(first[i].area_m2, again[i].area_m2);
    EXPECT_EQ(first[i].samples.size, again[i].samples.size);
  }
}

}  // namespace
}  // namespace ribbon_mapper
