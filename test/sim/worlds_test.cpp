// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every world of the package loads, its route is free, and its tour sees as many planes as the
// world was designed to show.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/tour/tour.hpp"
#include "sim/truth/truth.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

namespace fs = std::filesystem;

const fs::path kWorlds = PROJECT_DIR "/worlds";

/// Returns the route that belongs to a world.
Route route_of(const fs::path& path) {
  return Route::load(fs::path(path).replace_extension(".route.yaml").string());
}

/// Returns the planes that the tour of the world's own route sees. Throws if the route collides.
std::vector<TruthPlane> seen_planes(const fs::path& path) {
  const World world = World::load(path.string());
  const Route route = route_of(path);
  EXPECT_EQ(route.closed(), path.stem().string().find("open_path") == std::string::npos);
  Tour tour(world, route, {});
  TruthCollector truth(world);
  while (const auto scan = tour.next_scan()) truth.add(*scan);
  return truth.planes();
}

struct Shipped {
  std::string file;
  std::size_t planes;
};

class ShippedWorld : public testing::TestWithParam<Shipped> {};

TEST_P(ShippedWorld, ShowsThePlanesItWasDesignedFor) {
  EXPECT_EQ(seen_planes(kWorlds / GetParam().file).size(), GetParam().planes);
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, ShippedWorld,
    testing::Values(Shipped{"apartment.sdf", 22}, Shipped{"room.sdf", 9},
                    Shipped{"corridor_ring.sdf", 19}, Shipped{"slopes.sdf", 16},
                    Shipped{"hotel.sdf", 59}, Shipped{"ring_pilasters.sdf", 121},
                    Shipped{"ring_bare.sdf", 10}, Shipped{"open_path_flat.sdf", 20},
                    Shipped{"open_path_corridor.sdf", 7}, Shipped{"ramps.sdf", 10},
                    Shipped{"doorways.sdf", 33}, Shipped{"flush_fronts.sdf", 33}),
    [](const auto& test) { return fs::path(test.param.file).stem().string(); });

/// Compares the room with its drawing: each plane and its largest visible area.
TEST(Room, HasThePlanesOfItsDrawing) {
  struct Drawn {
    Eigen::Vector3d normal;
    double d_m, area_m2;
  };
  const std::vector<Drawn> drawing{{{0, 0, 1}, 0.0, 7 * 5 - 1.2 * 0.45},
                                   {{0, 0, -1}, 2.6, 7 * 5},
                                   {{1, 0, 0}, 3.5, 5 * 2.6},
                                   {{-1, 0, 0}, 3.5, 5 * 2.6 - 0.45 * 1.9},
                                   {{0, 1, 0}, 2.5, 7 * 2.6},
                                   {{0, -1, 0}, 2.5, 7 * 2.6 - 1.2 * 1.9},
                                   {{0, 0, 1}, -0.75, 1.4 * 0.8},
                                   {{0, -1, 0}, 2.05, 1.2 * 1.9},
                                   {{-1, 0, 0}, 2.3, 0.45 * 1.9}};
  const auto planes = seen_planes(kWorlds / "room.sdf");
  for (const Drawn& drawn : drawing) {
    const auto same = [&](const TruthPlane& plane) {
      return plane.normal.isApprox(drawn.normal, 1e-9) && std::abs(plane.d_m - drawn.d_m) < 1e-9;
    };
    const auto found = std::find_if(planes.begin(), planes.end(), same);
    ASSERT_NE(found, planes.end()) << drawn.normal.transpose() << ", " << drawn.d_m;
    EXPECT_EQ(std::count_if(planes.begin(), planes.end(), same), 1);
    EXPECT_LT(found->area_m2, drawn.area_m2 * 1.02);
    EXPECT_GT(found->area_m2, drawn.area_m2 * 0.65) << "the tour sees most of it";
  }
}

/// The modeler must not assume that planes are level, upright or at right angles.
TEST(Slopes, HaveFewRightAngles) {
  const auto planes = seen_planes(kWorlds / "slopes.sdf");
  const auto is_oblique = [](const TruthPlane& plane) {
    return plane.normal.cwiseAbs().maxCoeff() < std::cos(0.1);
  };
  EXPECT_GE(std::count_if(planes.begin(), planes.end(), is_oblique), 10);
}

TEST(SmallOffice, IsLoadedAsOthersMadeIt) {
  const auto planes = seen_planes(kWorlds / "small_office.world");
  const auto is_floor = [](const TruthPlane& plane) {
    return plane.normal.isApprox(Eigen::Vector3d::UnitZ(), 1e-6) && plane.area_m2 > 50.0;
  };
  EXPECT_EQ(std::count_if(planes.begin(), planes.end(), is_floor), 1);
  EXPECT_GT(planes.size(), 20U);
}

TEST(ShippedWorlds, AreAllListedAndHaveARoute) {
  const std::string list = content_of(kWorlds / "README.md");
  int worlds = 0;
  for (const auto& entry : fs::directory_iterator(kWorlds)) {
    const fs::path file = entry.path();
    if (file.extension() != ".sdf" && file.extension() != ".world") continue;
    ++worlds;
    EXPECT_THAT(list, testing::HasSubstr("`" + file.filename().string() + "`"));
    EXPECT_TRUE(fs::exists(fs::path(file).replace_extension(".route.yaml"))) << file;
  }
  EXPECT_GE(worlds, 2);
}

}  // namespace
}  // namespace ribbon_mapper::sim
