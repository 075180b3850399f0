// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/pieces.hpp"

#include <gtest/gtest.h>

#include "modeler/surface/surface.hpp"
#include "modeler/surface/surface_config.hpp"
#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Vector = Eigen::Vector3d;

/// Returns two patches of a floor, 0.5 m apart. The second one is smaller, and higher by `step_m`.
Scene two_patches(double step_m) {
  Scene scene;
  scene.add(patch({1.0, 0.0, 0.0}, Vector::UnitX(), 2.0 * Vector::UnitY()));
  scene.add(patch({2.5, 0.0, step_m}, Vector::UnitX(), Vector::UnitY()));
  return scene;
}

std::vector<Hypothesis> pieces_of(const Scene& scene, double gap_m) {
  const Hypothesis whole = scene.whole();
  const Surface surface(whole, scene.observations(), SurfaceConfig{}.cell_size_m);
  return split(whole, surface.plane(), gap_m, scene.observations());
}

TEST(Split, SplitsAtWideGaps) {
  const Scene scene = two_patches(0.0);
  EXPECT_EQ(1u, pieces_of(scene, 0.6).size());
  const auto pieces = pieces_of(scene, 0.3);
  ASSERT_EQ(2u, pieces.size());
  EXPECT_EQ(51u, pieces[0].members().size());  // the largest first
  EXPECT_EQ(26u, pieces[1].members().size());
  EXPECT_EQ(0, pieces[0].id);
  EXPECT_NE(0, pieces[1].id);
  EXPECT_NEAR(1.5, pieces[0].fit().mean.x(), 1e-6);
  EXPECT_NEAR(3.0, pieces[1].fit().mean.x(), 1e-6);
}

/// Returns two table tops of 2 m2 and 1 m2 in line, 0.5 m apart, and a third of 0.2 m2 between
/// them.
Scene tables(double z_m) {
  Scene scene;
  scene.add(patch({1.0, 0.0, z_m}, Vector::UnitX(), 2.0 * Vector::UnitY()));
  scene.add(patch({2.5, 0.0, z_m}, Vector::UnitX(), Vector::UnitY()));
  scene.add(patch({2.5, 1.42, z_m}, Vector::UnitX(), 0.2 * Vector::UnitY()));
  return scene;
}

std::vector<Hypothesis> tops_of(const Scene& scene, double min_area_m2) {
  const Hypothesis whole = scene.whole();
  const Surface surface(whole, scene.observations(), SurfaceConfig{}.cell_size_m);
  return divide_tops(whole, surface.plane(), SurfaceConfig{}.stripe_gap_m, min_area_m2,
                     scene.observations());
}

TEST(DivideTops, MakesATopOfEachLargePart) {
  const auto tops = tops_of(tables(0.75), 0.5);
  ASSERT_EQ(2u, tops.size());
  EXPECT_EQ(0, tops[0].id);
  EXPECT_NE(0, tops[1].id);
  EXPECT_NEAR(1.5, tops[0].fit().mean.x(), 1e-6);
  EXPECT_NEAR(3.0, tops[1].fit().mean.x(), 1e-6);
  EXPECT_GT(tops[1].fit().mean.y(), 0.51) << "the small part is with the nearer table";
}

TEST(DivideTops, KeepsATopOfWhichOnePartIsLarge) {
  EXPECT_EQ(1u, tops_of(tables(0.75), 1.5).size());
  EXPECT_EQ(tables(0.75).whole().members().size(), tops_of(tables(0.75), 1.5)[0].members().size());
}

TEST(IsTop, IsTrueForLevelSurfacesAboveTheGround) {
  EXPECT_TRUE(is_top(tables(0.75).whole(), tables(0.75).observations()));
  EXPECT_FALSE(is_top(tables(0.0).whole(), tables(0.0).observations()));
  Scene wall;
  wall.add(patch({1.0, 0.0, 1.0}, Vector::UnitZ(), Vector::UnitY()));
  EXPECT_FALSE(is_top(wall.whole(), wall.observations()));
}

TEST(GroupAgreeing, UnitesPiecesWhoseFitsAgree) {
  const AssociationGates gates{2.0, 0.03};
  EXPECT_EQ(1u, group_agreeing(pieces_of(two_patches(0.0), 0.3), gates, 0.5).size());
  EXPECT_EQ(1u, group_agreeing(pieces_of(two_patches(0.02), 0.3), gates, 0.5).size());
  const auto groups = group_agreeing(pieces_of(two_patches(0.06), 0.3), gates, 0.5);
  ASSERT_EQ(2u, groups.size());
  EXPECT_NEAR(1.0, groups[1].normal().z(), 1e-9);  // neither is tilted
  EXPECT_NEAR(-0.06, groups[1].d_m(), 1e-6);
}

TEST(GroupAgreeing, RequiresShortPiecesToBeLevel) {
  const AssociationGates gates{2.0, 0.03};
  EXPECT_EQ(1u, group_agreeing(pieces_of(two_patches(0.005), 0.3), gates, 2.0).size());
  EXPECT_EQ(2u, group_agreeing(pieces_of(two_patches(0.02), 0.3), gates, 2.0).size());
}

}  // namespace
}  // namespace ribbon_mapper
