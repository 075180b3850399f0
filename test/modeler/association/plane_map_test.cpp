// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/association/plane_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Vector = Eigen::Vector3d;

const Vector kX = Vector::UnitX(), kY = Vector::UnitY(), kZ = Vector::UnitZ();
const AssociationGates kSlamGates = AssociationConfig{}.slam;

/// Returns ribbons on a wall at `x_m`, seen from the origin, from `y_m` to the right.
std::vector<Ribbon> wall(double x_m, double y_m, double width_m) {
  return patch({x_m, y_m, 0.0}, -width_m * kY, kZ);
}

/// Returns a scene of several patches.
Scene scene_of(const std::vector<std::vector<Ribbon>>& patches) {
  Scene scene;
  for (const auto& ribbons : patches) scene.add(ribbons);
  return scene;
}

/// Returns a board 10 cm in front of the middle of a wall. The ribbons of the wall are ordered from
/// its middle outwards.
Scene board_and_wall() {
  std::vector<Ribbon> ribbons = wall(2.1, 1.0, 2.0);
  const auto height = [](const Ribbon& r) { return std::abs(r.moments.mean().z() - 0.5); };
  std::stable_sort(ribbons.begin(), ribbons.end(),
                   [&](const Ribbon& a, const Ribbon& b) { return height(a) < height(b); });
  return scene_of({patch({2.0, 0.5, 0.25}, -kY, 0.5 * kZ), ribbons});
}

TEST(PlaneMap, MakesOneHypothesisOfAWall) {
  const Scene scene = scene_of({wall(2.0, 1.0, 2.0)});
  const auto hypotheses = scene.map().hypotheses();
  ASSERT_EQ(1u, hypotheses.size());
  EXPECT_EQ(scene.ribbons.size(), hypotheses[0].members().size());
  EXPECT_EQ(0, hypotheses[0].id);
}

TEST(PlaneMap, MakesTwoHypothesesOfACorner) {
  const Scene scene = scene_of({wall(2.0, 1.0, 2.0), patch({2.0, -1.0, 0.0}, -2.0 * kX, kZ)});
  EXPECT_EQ(2u, scene.map().hypotheses().size());
}

TEST(PlaneMap, SeparatesTheSidesOfAThinWall) {
  const Scene scene = scene_of({wall(2.0, 1.0, 2.0), patch({2.02, -1.0, 0.0}, 2.0 * kY, kZ)});
  const auto hypotheses = scene.map(kSlamGates).merged_hypotheses();
  ASSERT_EQ(2u, hypotheses.size());
  EXPECT_LT(hypotheses[0].normal().x(), -0.99);
  EXPECT_GT(hypotheses[1].normal().x(), 0.99);
}

TEST(PlaneMap, UnitesParallelWallsOnlyWithinTheGates) {
  EXPECT_EQ(1u, scene_of({wall(2.0, 1.0, 1.0), wall(2.02, 0.0, 1.0)}).map().hypotheses().size());
  EXPECT_EQ(2u, board_and_wall().map().hypotheses().size());
  EXPECT_EQ(
      1u,
      board_and_wall().map(kSlamGates).hypotheses().size());  // the wider gates of SLAM unite them
}

TEST(PlaneMap, AddsARibbonToTheMostLikelyHypothesis) {
  for (const double x_m : {2.18, 2.22}) {
    Scene scene = scene_of({wall(2.0, 1.0, 2.0), wall(2.4, 1.0, 2.0)});
    scene.ribbons.push_back(ribbon_between({x_m, 0.3, 0.5}, {x_m, -0.3, 0.5}, -kX));
    const auto hypotheses = scene.map(kSlamGates).hypotheses();
    ASSERT_EQ(2u, hypotheses.size());
    const Hypothesis& nearer = hypotheses[x_m < 2.2 ? 0 : 1];
    EXPECT_EQ(scene.ribbons.size() - 1, nearer.members().back().ribbon);
  }
}

TEST(PlaneMap, SeparatesPatchesUntilTheyGrowTogether) {
  Scene scene = scene_of({patch({2.0, 5.0, 0.0}, -0.5 * kY, 0.5 * kZ), wall(2.0, 0.0, 1.0)});
  EXPECT_EQ(2u, scene.map().merged_hypotheses().size());
  scene.add(wall(2.0, 4.2, 4.4));
  const auto hypotheses = scene.map().hypotheses();
  ASSERT_EQ(1u, hypotheses.size());
  EXPECT_EQ(0, hypotheses[0].id);  // that of the older one
  EXPECT_EQ(scene.ribbons.size(), hypotheses[0].members().size());
}

/// The ribbon joins the smaller of two patches of the floor first, which then goes into the larger
/// one. What was merged away is not compared again: it has no points (`make sanitize` sees that).
TEST(PlaneMap, MergesAPatchOnce) {
  Scene scene = scene_of({patch({0.0, 0.0, 0.002}, kX, kY), patch({3.0, 0.0, 0.0}, 0.5 * kX, kY)});
  scene.ribbons.push_back(ribbon_between({1.1, 0.5, 0.0}, {2.9, 0.5, 0.0}, kZ));
  ASSERT_EQ(1u, scene.map().hypotheses().size());
  scene.add(wall(8.0, 1.0, 1.0));
  scene.add(wall(9.0, 1.0, 1.0));
  const auto hypotheses = scene.map().hypotheses();
  EXPECT_EQ(3u, hypotheses.size());
  std::size_t members = 0;
  for (const Hypothesis& hypothesis : hypotheses) members += hypothesis.members().size();
  EXPECT_EQ(scene.ribbons.size(), members);
}

TEST(PlaneMap, MergesIdempotently) {
  const Scene scene = scene_of({wall(2.0, 1.0, 2.0), wall(2.2, -1.0, 2.0), wall(2.1, 4.0, 1.0)});
  const PlaneMap map = scene.map(kSlamGates);
  const auto once = map.merged_hypotheses(), twice = map.merged_hypotheses();
  ASSERT_EQ(once.size(), twice.size());
  EXPECT_LE(once.size(), map.hypotheses().size());
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].d_m(), twice[i].d_m());
}

std::set<std::int64_t> ids_of(const PlaneMap& map) {
  std::set<std::int64_t> ids;
  for (const Hypothesis& hypothesis : map.hypotheses()) ids.insert(hypothesis.id);
  return ids;
}

TEST(TakeIdsFrom, KeepsTheIdsOfUnchangedPlanes) {
  const Scene scene = scene_of({wall(2.0, 1.0, 2.0), wall(2.5, 1.0, 2.0), wall(3.0, 1.0, 2.0)});
  const PlaneMap before = scene.map();
  PlaneMap after = scene.map(AssociationConfig{}.corrected, before.next_id());
  EXPECT_EQ((std::set<std::int64_t>{3, 4, 5}), ids_of(after));
  after.take_ids_from(before);
  EXPECT_EQ((std::set<std::int64_t>{0, 1, 2}), ids_of(after));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(before.hypotheses()[i].d_m(), after.hypotheses()[i].d_m());
  }
  EXPECT_EQ(6, after.next_id());
}

TEST(TakeIdsFrom, GivesTheIdOfASplitPlaneToItsLargerPart) {
  const Scene scene = board_and_wall();
  const PlaneMap before = scene.map(kSlamGates);
  ASSERT_EQ(1u, before.hypotheses().size());
  PlaneMap after = scene.map(AssociationConfig{}.corrected, before.next_id());
  after.take_ids_from(before);
  const auto hypotheses = after.hypotheses();
  ASSERT_EQ(2u, hypotheses.size());
  EXPECT_EQ(0, hypotheses[0].id);
  EXPECT_NEAR(2.1, hypotheses[0].d_m(), 1e-6);
  EXPECT_GE(hypotheses[1].id, before.next_id());
}

TEST(TakeIdsFrom, GivesAMergedPlaneTheIdOfTheLargerOne) {
  const Scene scene = board_and_wall();
  const PlaneMap before = scene.map();
  ASSERT_EQ(2u, before.hypotheses().size());
  PlaneMap after = scene.map(kSlamGates, before.next_id());
  after.take_ids_from(before);
  ASSERT_EQ(1u, after.hypotheses().size());
  EXPECT_EQ(before.hypotheses()[1].id, after.hypotheses()[0].id);
}

}  // namespace
}  // namespace ribbon_mapper
