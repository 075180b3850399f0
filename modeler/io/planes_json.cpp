// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/planes_json.hpp"

#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper {
namespace {

constexpr auto kReplace = Json::error_handler_t::replace;  // of bytes that are no UTF-8

Json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json to_json(const std::vector<Eigen::Vector3d>& points) {
  Json json = Json::array();
  for (const Eigen::Vector3d& point : points) json.push_back(to_json(point));
  return json;
}

/// Returns the rings of each outline, the outer one first, as in a GeoJSON MultiPolygon.
Json to_json(const std::vector<Outline>& outlines) {
  Json json = Json::array();
  for (const Outline& outline : outlines) {
    Json& rings = json.emplace_back(Json::array({to_json(outline.outer)}));
    for (const auto& hole : outline.holes) rings.push_back(to_json(hole));
  }
  return json;
}

Json to_json(const Eigen::AlignedBox3d& box) {
  return box.isEmpty() ? Json::array() : Json{to_json(box.min()), to_json(box.max())};
}

Json to_json(const Plane& plane) {
  return {{"id", plane.id},
          {"normal", to_json(plane.normal)},
          {"d", plane.d_m},
          {"area", plane.area_m2},
          {"centroid", to_json(plane.centroid)},
          {"bbox", to_json(bounding_box(plane))},
          {"outlines", to_json(plane.outlines)}};
}

Json to_json(const PlaneLabel& label) {
  Json json{{"label", label.text}, {"label_confidence", label.confidence}};
  if (!label.note.empty()) json["note"] = label.note;
  return json;
}

void extend_by_cell(Eigen::AlignedBox3d& box, const Plane& plane, const PlaneCell& cell) {
  for (const int u : {cell.u, cell.u + 1}) {
    for (const int v : {cell.v, cell.v + 1}) box.extend(grid_corner(plane, u, v));
  }
}

Json to_json(const Ring& ring) {
  Json json = Json::array();
  for (const Eigen::Vector2d& point : ring) json.push_back({point.x(), point.y()});
  return json;
}

Json to_json(const Room& room, const std::string& name) {
  Json outlines = Json::array();
  for (const Polygon& polygon : room.outlines) {
    Json& rings = outlines.emplace_back(Json::array({to_json(polygon.outer)}));
    for (const Ring& hole : polygon.holes) rings.push_back(to_json(hole));
  }
  return {{"name", name},
          {"area", room.area_m2},
          {"centre", to_json(room.centre)},
          {"outlines", outlines}};
}

Json to_json(const Passage& passage) {
  const DoorOpening& opening = passage.opening;
  return {{"rooms", passage.rooms},
          {"plane", opening.plane},
          {"jambs", {to_json(opening.jambs[0]), to_json(opening.jambs[1])}},
          {"sill", opening.sill_m},
          {"head", opening.head_m ? Json(*opening.head_m) : Json(nullptr)},
          {"confidence", opening.confidence}};
}

}  // namespace

Eigen::AlignedBox3d bounding_box(const Plane& plane) {
  Eigen::AlignedBox3d box;
  for (const Outline& outline : plane.outlines) {
    for (const Eigen::Vector3d& point : outline.outer) box.extend(point);
  }
  if (!box.isEmpty()) return box;
  for (const PlaneCell& cell : plane.cells) extend_by_cell(box, plane, cell);
  return box;
}

std::string planes_to_json(const std::vector<Plane>& planes, const ModelLabel& label,
                           const std::vector<PlaneLabel>& labels) {
  std::string text =
      "{\n\"frame\": " + Json(label.frame).dump(-1, ' ', false, kReplace) + ",\n\"unit\": \"m\",\n";
  if (!label.run.empty()) text += "\"run\": \"" + label.run + "\",\n";
  if (!label.origin.isZero(0.0)) text += "\"origin\": " + to_json(label.origin).dump() + ",\n";
  text += "\"planes\": [";
  const char* separator = "\n";
  for (std::size_t i = 0; i < planes.size(); ++i) {
    Json json = to_json(planes[i]);
    if (i < labels.size()) json.update(to_json(labels[i]));
    text += separator + json.dump(-1, ' ', false, kReplace);
    separator = ",\n";
  }
  return text + "\n]\n}\n";
}

std::string rooms_to_json(const Rooms& rooms, const ModelLabel& label) {
  Json json{{"frame", label.frame}, {"unit", "m"}};
  if (!label.run.empty()) json["run"] = label.run;
  json["rooms"] = Json::array();
  for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
    json["rooms"].push_back(to_json(rooms.rooms[i], room_name(i)));
  }
  json["passages"] = Json::array();
  for (const Passage& passage : rooms.passages) json["passages"].push_back(to_json(passage));
  return json.dump(-1, ' ', false, kReplace) + "\n";
}

}  // namespace ribbon_mapper
