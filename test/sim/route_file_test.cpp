// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/tour/route.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class RouteFile : public testing::Test {
 protected:
  Route load(const std::string& text) const {
    write_file(path(), text);
    return Route::load(path().string());
  }
  std::string error_of(const std::string& text) const {
    try {
      load(text);
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(path().string())) << "names the file";
      return error.what();
    }
    ADD_FAILURE() << "was loaded: " << text;
    return "";
  }
  std::filesystem::path path() const { return directory_.path() / "test.route.yaml"; }

  TemporaryDirectory directory_;
};

const std::string kWay = "waypoints: [[0, 0], [3.5, -1]]\n";

TEST_F(RouteFile, IsRead) {
  const Route route = load("speed: 0.25\nturn_rate: 0.7\n" + kWay);
  EXPECT_DOUBLE_EQ(route.speed_m_s(), 0.25);
  ASSERT_EQ(route.waypoints().size(), 2U);
  EXPECT_EQ(route.waypoints()[1], Eigen::Vector2d(3.5, -1.0));
  EXPECT_FALSE(route.closed());
}

TEST_F(RouteFile, ThatIsNoYamlIsRefusedWithThePlace) {
  EXPECT_THAT(error_of("speed: 0.25\nwaypoints: [[0, 0], [3.5\nrest: 1"),
              AllOf(HasSubstr("line 3, column"), HasSubstr("no YAML"),
                    HasSubstr("worlds/apartment.route.yaml")));
  EXPECT_THROW(Route::load((directory_.path() / "none.yaml").string()), std::runtime_error);
}

TEST_F(RouteFile, TheRestIsOptional) {
  const std::string head = "speed: 0.25\nturn_rate: 0.7\n" + kWay;
  const Time moving = load(head).duration();
  EXPECT_EQ(load(head + "rest: 12.5\n").duration(), moving + from_seconds(12.5));
  EXPECT_THAT(error_of(head + "rest: long\n"), HasSubstr("'rest' must be a number"));
  EXPECT_THAT(error_of(head + "rest: -1\n"), HasSubstr("rest must be in 0..1000 s"));
}

TEST_F(RouteFile, AWaypointMayHaveTheHeightOfTheGround) {
  const Route route =
      load("speed: 0.25\nturn_rate: 0.7\nwaypoints: [[0, 0], [1, 0], [3, 0, 0.1], [4, 0, 0.1]]\n");
  EXPECT_FALSE(route.is_level());
  EXPECT_NEAR(route.T_map_base(route.duration()).translation().z(), 0.1, 1e-9);
  EXPECT_NEAR(route.T_map_base(Time(0)).translation().z(), 0.0, 1e-9) << "0 where it has none";
  EXPECT_THAT(error_of("speed: 0.3\nturn_rate: 0.6\nwaypoints: [[0, 0], [1, 0, high]]\n"),
              HasSubstr("must be a number"));
}

TEST_F(RouteFile, MissingOrBroken) {
  EXPECT_THROW(Route::load(path().string()), std::runtime_error);
  EXPECT_FALSE(error_of("speed: [0.3\n  : {").empty());
  EXPECT_THAT(error_of(""), HasSubstr("speed, turn_rate and waypoints"));
  EXPECT_THAT(error_of("just a line of text"), HasSubstr("speed, turn_rate and waypoints"));
}

TEST_F(RouteFile, NamesTheKey) {
  EXPECT_THAT(error_of("speed: 0.3\nturn_rate: 0.6\nspeeed: 1\n" + kWay),
              HasSubstr("unknown key 'speeed'"));
  EXPECT_THAT(error_of("speed: 0.3\n" + kWay), HasSubstr("'turn_rate' is missing"));
  EXPECT_THAT(error_of("speed: 0.3\nspeed: 0.4\nturn_rate: 0.6\n" + kWay),
              HasSubstr("'speed' is given twice"));
  EXPECT_THAT(error_of("speed: fast\nturn_rate: 0.6\n" + kWay),
              HasSubstr("'speed' must be a number"));
  EXPECT_THAT(error_of("speed: 3\nturn_rate: 0.6\n" + kWay),
              HasSubstr("speed must be in 0.001..1"));
}

TEST_F(RouteFile, NamesTheWaypoint) {
  const std::string head = "speed: 0.3\nturn_rate: 0.6\nwaypoints: ";
  EXPECT_THAT(error_of(head + "[[0, 0], [1, 2, 3, 4]]\n"), HasSubstr("waypoint 2 is not [x, y]"));
  EXPECT_THAT(error_of(head + "[[0, 0], [1]]\n"), HasSubstr("waypoint 2 is not [x, y]"));
  EXPECT_THAT(error_of(head + "[[0, 0], 5]\n"), HasSubstr("waypoint 2 is not [x, y]"));
  EXPECT_THAT(error_of(head + "[[0, 0], [a, 1]]\n"), HasSubstr("must be a number"));
  EXPECT_THAT(error_of(head + "7\n"), HasSubstr("must be a list"));
  EXPECT_THAT(error_of(head + "[[0, 0]]\n"), HasSubstr("two or more"));
  EXPECT_THAT(error_of(head + "[[0, 0], [.nan, 1]]\n"), HasSubstr("finite"));
}

}  // namespace
}  // namespace ribbon_mapper::sim
