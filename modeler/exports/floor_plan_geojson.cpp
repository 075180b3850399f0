// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/exports/floor_plan_geojson.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/semantics/rooms.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper {
namespace {

constexpr auto kReplace = Json::error_handler_t::replace;  // of bytes that are no UTF-8

/// Rounds to 0.1 mm.
double rounded(double value) {
  const double result = std::round(value * 1e4) / 1e4;
  return result == 0.0 ? 0.0 : result;  // never -0
}

Json to_json(const std::optional<double>& value) {
  return value ? Json(rounded(*value)) : Json(nullptr);
}

Json to_json(const Eigen::Vector2d& point) { return {rounded(point.x()), rounded(point.y())}; }

Json line(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return {{"type", "LineString"}, {"coordinates", Json::array({to_json(a), to_json(b)})}};
}

/// Returns a ring with its first point at the end, as GeoJSON wants it.
Json to_json(const Ring& ring) {
  Json json = Json::array();
  for (const Eigen::Vector2d& point : ring) json.push_back(to_json(point));
  json.push_back(to_json(ring.front()));
  return json;
}

Json to_json(const Polygons& polygons) {
  Json parts = Json::array();
  for (const Polygon& polygon : polygons) {
    Json& rings = parts.emplace_back(Json::array({to_json(polygon.outer)}));
    for (const Ring& hole : polygon.holes) rings.push_back(to_json(hole));
  }
  if (parts.size() == 1) return {{"type", "Polygon"}, {"coordinates", parts[0]}};
  return {{"type", "MultiPolygon"}, {"coordinates", parts}};
}

Json feature(const Json& properties, const Json& geometry) {
  return {{"type", "Feature"}, {"properties", properties}, {"geometry", geometry}};
}

Json wall_feature(const PlanWall& wall) {
  Json properties{{"kind", "wall"},
                  {"faces", wall.planes.size()},
                  {"thickness_m", to_json(wall.thickness_m)},
                  {"length_m", rounded((wall.face[1] - wall.face[0]).norm())}};
  if (wall.thickness_m) properties["area_m2"] = rounded(area(wall.footprint));
  properties["planes"] = wall.planes;
  return feature(properties,
                 wall.thickness_m ? to_json(wall.footprint) : line(wall.face[0], wall.face[1]));
}

Json room_names(const std::vector<std::size_t>& rooms) {
  Json names = Json::array();
  for (const std::size_t room : rooms) names.push_back(room_name(room));
  return names;
}

Json opening_feature(const PlanOpening& opening, std::size_t number) {
  return feature({{"kind", opening.is_door() ? "door" : "opening"},
                  {"number", number},
                  {"width_m", rounded((opening.jambs[1] - opening.jambs[0]).norm())},
                  {"thickness_m", to_json(opening.depth_m)},
                  {"sill_m", rounded(opening.sill_m)},
                  {"head_m", to_json(opening.head_m)},
                  {"rooms", room_names(opening.rooms)},
                  {"planes", opening.planes}},
                 line(opening.jambs[0], opening.jambs[1]));
}

Json leaf_feature(const PlanLeaf& leaf, std::size_t door) {
  return feature({{"kind", "leaf"},
                  {"door", door},
                  {"width_m", rounded((leaf.tip - leaf.hinge).norm())},
                  {"planes", {leaf.plane}}},
                 line(leaf.hinge, leaf.tip));
}

Json room_feature(const PlanRoom& room, const std::string& name) {
  return feature({{"kind", "room"},
                  {"name", name},
                  {"area_m2", rounded(room.area_m2)},
                  {"free_floor_m2", rounded(room.free_floor_m2)},
                  {"is_enclosed", room.is_enclosed},
                  {"label_at", to_json(room.middle)}},
                 to_json(room.outline));
}

std::vector<Json> features_of(const FloorPlan& plan) {
  std::vector<Json> features;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    features.push_back(room_feature(plan.rooms[i], room_name(i)));
  }
  for (const PlanWall& wall : plan.walls) features.push_back(wall_feature(wall));
  if (!plan.solid.empty()) {
    features.push_back(
        feature({{"kind", "solid"}, {"area_m2", rounded(area(plan.solid))}}, to_json(plan.solid)));
  }
  if (!plan.hidden.empty()) {
    features.push_back(feature({{"kind", "hidden"}}, to_json(plan.hidden)));
  }
  for (std::size_t i = 0; i < plan.openings.size(); ++i) {
    features.push_back(opening_feature(plan.openings[i], i + 1));
    for (const PlanLeaf& leaf : plan.openings[i].leaves) {
      features.push_back(leaf_feature(leaf, i + 1));
    }
  }
  return features;
}

/// Returns a local coordinate system in metres as WKT (ISO 19162).
std::string engineering_crs(std::string frame) {
  std::replace(frame.begin(), frame.end(), '"', '_');
  return "ENGCRS[\"" + frame + "\",EDATUM[\"" + frame + "\"],CS[Cartesian,2]," +
         R"(AXIS["x",east],AXIS["y",north],LENGTHUNIT["metre",1]])";
}

}  // namespace

std::string floor_plan_to_geojson(const FloorPlan& plan, const ModelLabel& label) {
  Json head{{"type", "FeatureCollection"},
            {"name", "floor_plan"},
            {"crs", {{"type", "name"}, {"properties", {{"name", engineering_crs(label.frame)}}}}},
            {"coordinate_system", "x and y in metres in the frame " + label.frame +
                                      ", not longitude and latitude (RFC 7946, section 4)"},
            {"frame", label.frame},
            {"unit", "m"}};
  if (!label.run.empty()) head["run"] = label.run;
  std::string text = head.dump(-1, ' ', false, kReplace);
  text.back() = ',';
  text += "\n\"features\": [";
  const char* separator = "\n";
  for (const Json& json : features_of(plan)) {
    text += separator + json.dump();
    separator = ",\n";
  }
  return text + "\n]}\n";
}

}  // namespace ribbon_mapper
