// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/route_view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/tour/tour.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::HasSubstr;

const std::string kRoom =
    sdf_block("floor", {-4, -3, -0.1}, {4, 3, 0}) + sdf_block("wall", {3, -3, 0}, {3.1, 3, 2.5});
const std::string kGround =
    sdf_model("ground", "0 0 -0.1 0 0 0", "<plane><normal>0 0 1</normal></plane>");

Route route_at(double x_m, double y_m) { return Route(0.5, 1.0, {{x_m, y_m}, {x_m + 1, y_m}}); }

std::string refusal(const std::string& content, const Route& route) {
  const World world = world_of(content);
  try {
    Tour(world, route, {});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(RouteView, SaysWhatTheRouteSees) {
  const World world = world_of(kRoom);
  EXPECT_THAT(
      Tour(world, route_at(0, 0), {}).view(),
      testing::MatchesRegex("the route of 1 m sees [2-4] of 12 faces, .* % of its rays return"));
}

TEST(RouteView, ARouteOutsideOfTheWorldIsRefused) {
  EXPECT_THAT(refusal(kRoom, route_at(500, 0)),
              testing::AllOf(HasSubstr("outside"), HasSubstr("sees nothing;"),
                             HasSubstr("x -4 to 4, y -3 to 3 m")));
  EXPECT_THAT(refusal(kRoom, route_at(-4000, 3000)), HasSubstr("outside"));
  EXPECT_THAT(refusal(kRoom + kGround, route_at(60, 0)), HasSubstr("nothing but unbounded ground"));
  EXPECT_THAT(refusal(kRoom + kGround, route_at(0, -1500)), HasSubstr("sees nothing;"));
}

TEST(RouteView, AWorldOfNothingButAGroundPlaneIsSeen) {
  EXPECT_EQ(refusal(kGround, route_at(0, 0)), "none");
  EXPECT_EQ(refusal(kRoom + kGround, Route(0.5, 1.0, {{7, 0}, {6, 0}})), "none")
      << "the room from outside";
}

}  // namespace
}  // namespace ribbon_mapper::sim
