// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "modeler/ros/messages/plane_edges.hpp"
#include "modeler/ros/messages/plane_markers.hpp"
#include "modeler/ros/messages/room_messages.hpp"
#include "modeler/ros/messages/text_places.hpp"
#include "test/report/sample_model.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::UnorderedElementsAre;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kStripeGap_m = 0.3;

const std::vector<PlaneLabel> kLabels{{"floor", 0.9, "", Label::floor},
                                      {"wall", 0.9, "", Label::wall}};

std::vector<Plane> floor_and_wall() { return {sample_floor(), sample_wall(2, 4.0)}; }

std::vector<std::string> namespaces_of(const MarkerArray& array) {
  std::vector<std::string> names;
  for (const Marker& marker : array.markers) names.push_back(marker.ns);
  return names;
}

const Marker& only(const MarkerArray& array, const std::string& ns, int id) {
  const auto found = std::find_if(array.markers.begin(), array.markers.end(),
                                  [&](const Marker& m) { return m.ns == ns && m.id == id; });
  if (found == array.markers.end()) throw std::runtime_error("no marker in " + ns);
  return *found;
}

TEST(PlaneMarkers, HaveNamespacesOfTheirOwn) {
  PlaneMarkers markers;
  const MarkerArray all = markers.changes(floor_and_wall(), kLabels, kStripeGap_m, {});
  EXPECT_THAT(namespaces_of(all),
              UnorderedElementsAre("planes", "labels", "normals", "outlines", "planes", "labels",
                                   "normals", "outlines", "edges"));
  EXPECT_EQ(only(all, "labels", 2).text, "2 wall\n13.0 m2");
  const Marker& normal = only(all, "normals", 2);
  ASSERT_EQ(normal.points.size(), 2U);
  EXPECT_LT(normal.points[1].y, normal.points[0].y) << "to the side it was seen from";
}

TEST(PlaneMarkers, FloorsAreGreyAndWallsAreNot) {
  PlaneMarkers markers;
  const MarkerArray all = markers.changes(floor_and_wall(), kLabels, kStripeGap_m, {});
  const auto spread = [&](int id) {
    const std_msgs::ColorRGBA& c = only(all, "planes", id).colors.front();
    return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b});
  };
  EXPECT_LT(spread(1), 0.05F);
  EXPECT_GT(spread(2), 0.1F);
}

TEST(PlaneMarkers, OnlyChangesAreSent) {
  PlaneMarkers markers;
  const std::vector<Plane> planes = floor_and_wall();
  markers.changes(planes, kLabels, kStripeGap_m, {});
  EXPECT_TRUE(markers.changes(planes, kLabels, kStripeGap_m, {}).markers.empty());
  std::vector<PlaneLabel> renamed = kLabels;
  renamed[1].text = "my wall";
  EXPECT_THAT(namespaces_of(markers.changes(planes, renamed, kStripeGap_m, {})),
              ElementsAre("labels"));
  markers.forget();
  EXPECT_EQ(markers.changes(planes, renamed, kStripeGap_m, {}).markers.size(), 9U);
}

TEST(PlaneMarkers, PlanesThatAreGoneAreDeleted) {
  PlaneMarkers markers;
  markers.changes(floor_and_wall(), kLabels, kStripeGap_m, {});
  const MarkerArray gone = markers.changes({sample_floor()}, {kLabels[0]}, kStripeGap_m, {});
  EXPECT_THAT(namespaces_of(gone),
              UnorderedElementsAre("planes", "labels", "normals", "outlines", "edges"));
  for (const Marker& marker : gone.markers) EXPECT_EQ(marker.action, Marker::DELETE) << marker.ns;
}

TEST(PlaneMarkers, APlaneThatBecomesACeilingLeavesTheOthers) {
  PlaneMarkers markers;
  markers.changes({sample_ceiling()}, {{"slope", 0.5, "", Label::slope}}, kStripeGap_m, {});
  const MarkerArray now =
      markers.changes({sample_ceiling()}, {{"ceiling", 0.5, "", Label::ceiling}}, kStripeGap_m, {});
  EXPECT_EQ(only(now, "planes", 3).action, Marker::DELETE);
  EXPECT_EQ(only(now, "ceilings", 3).action, Marker::ADD);
}

TEST(PlaneEdges, AreWherePlanesMeet) {
  // The wall stands on the floor with two pieces beside its door; the floor ends at the wall.
  const std::vector<Edge> edges = edges_of(floor_and_wall());
  ASSERT_EQ(edges.size(), 3U);
  double length_m = 0.0;
  for (const Edge& edge : edges) {
    for (const Vector3d& end : edge) {
      EXPECT_NEAR(end.y(), 4.0, 1e-9);
      EXPECT_NEAR(end.z(), 0.0, 1e-9);
    }
    length_m += (edge[1] - edge[0]).norm();
  }
  EXPECT_NEAR(length_m, 6.0 + 2.0 + 3.0, 1e-9);
  EXPECT_TRUE(edges_of({sample_floor(), sample_table()}).empty());
  EXPECT_TRUE(edges_of({}).empty());
}

TEST(TextPlaces, NoTextStandsBeforeAnother) {
  TextPlaces places(0.2);
  const Vector3d first = places.take({0, 0, 1}, "12 wall\n3.0 m2");
  const Vector3d second = places.take({0.1, 0.3, 1.1}, "13 wall\n4.0 m2");
  const Vector3d far = places.take({5, 0, 1}, "14 wall\n4.0 m2");
  EXPECT_EQ(first, Vector3d(0, 0, 1));
  EXPECT_EQ(far, Vector3d(5, 0, 1));
  EXPECT_EQ(second.head<2>(), Eigen::Vector2d(0.1, 0.3));
  EXPECT_GE(second.z() - first.z(), 2 * 2 * 0.2 - 1e-6) << "two lines, each twice its letters";
}

TEST(TextPlaces, ManyTextsAtOnePlaceStayThere) {
  TextPlaces places(0.2);
  for (int i = 0; i < 100; ++i) EXPECT_LT(places.take({0, 0, 0}, "text").z(), 10.0);
}

TEST(RoomMessages, SayWhereRoomsAreAndDrawThem) {
  const Polygon square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{{0.5, 0.5}, {0.5, 1}, {1, 1}}}};
  Rooms rooms;
  rooms.rooms = {{3.875, {1.5, 1.5, 0.1}, {square}}, {3.875, {1.5, 1.5, 0.1}, {square}}};
  rooms.passages.push_back({{0, 1}, {}});
  const FloorRooms message = rooms_message(rooms, {}, 7);
  EXPECT_EQ(message.revision, 7U);
  ASSERT_EQ(message.rooms.size(), 2U);
  EXPECT_EQ(message.rooms[1].name, "B");
  ASSERT_EQ(message.rooms[0].outlines.size(), 1U);
  EXPECT_EQ(message.rooms[0].outlines[0].holes.size(), 1U);
  ASSERT_EQ(message.passages.size(), 1U);
  EXPECT_EQ(message.passages[0].rooms[1], 1U);
  EXPECT_TRUE(std::isnan(message.passages[0].head)) << "no lintel was seen";
  const MarkerArray array = room_markers(rooms, {});
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  EXPECT_EQ(only(array, "names", 0).text, "room A\n3.9 m2");
  double area_m2 = 0.0;
  const auto& corners = only(array, "rooms", 0).points;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const auto &a = corners[i], &b = corners[i + 1], &c = corners[i + 2];
    area_m2 += 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
  }
  EXPECT_NEAR(area_m2, 3.875, 1e-9);
}

TEST(RoomMessages, OfNoRoomsDeleteThoseBefore) {
  const MarkerArray array = room_markers({}, {});
  ASSERT_EQ(array.markers.size(), 1U);
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
}

}  // namespace
}  // namespace ribbon_mapper
