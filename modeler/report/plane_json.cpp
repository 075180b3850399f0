// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/report/plane_json.hpp"

#include <array>

#include "modeler/report/packed_cells.hpp"
#include "modeler/surface/outline.hpp"
#include "modeler/text/coefficients.hpp"

namespace ribbon_mapper {
namespace {

Json rounded_json(const Eigen::Vector3d& v, double parts) {
  return {rounded(v.x(), parts), rounded(v.y(), parts), rounded(v.z(), parts)};
}

Json ring_on(const Plane& plane, const std::vector<Eigen::Vector3d>& ring) {
  Json json = Json::array();
  for (const Eigen::Vector3d& point : ring) {
    const Eigen::Vector2d on = on_axes(plane, point);
    json.push_back(in_millimetres(on.x()));
    json.push_back(in_millimetres(on.y()));
  }
  return json;
}

Json ring_in_map(const std::vector<Eigen::Vector3d>& ring) {
  Json json = Json::array();
  for (const Eigen::Vector3d& point : ring) {
    for (const double value : coefficients_of(point)) json.push_back(in_millimetres(value));
  }
  return json;
}

template <typename Convert>
Json outlines_json(const std::vector<Outline>& outlines, const Convert& convert) {
  Json json = Json::array();
  for (const Outline& outline : outlines) {
    Json& rings = json.emplace_back(Json::array({convert(outline.outer)}));
    for (const auto& hole : outline.holes) rings.push_back(convert(hole));
  }
  return json;
}

Json to_json(const PlaneVerdict& verdict) {
  constexpr std::array<const char*, 3> kNames{"matched", "duplicate", "extra"};
  Json json{{"kind", kNames[static_cast<std::size_t>(verdict.kind)]}};
  if (verdict.truth) json["truth"] = *verdict.truth;
  if (verdict.angle_error_deg) json["angle_deg"] = rounded(*verdict.angle_error_deg, 1e4);
  if (verdict.offset_error_m) json["offset_m"] = rounded(*verdict.offset_error_m, 1e5);
  return json;
}

Json to_json(const PackedCells& cells) {
  return {{"u", cells.u_begin},
          {"v", cells.v_begin},
          {"columns", cells.columns},
          {"rows", cells.rows},
          {"data", base64(cells.bytes)}};
}

std::uint64_t points_of(const Plane& plane) {
  std::uint64_t count = 0;
  for (const PlaneCell& cell : plane.cells) count += cell.count;
  return count;
}

}  // namespace

std::string text_of(const Json& json) {
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

Json outlines_in_map(const std::vector<Outline>& outlines) {
  return outlines_json(outlines, ring_in_map);
}

std::string plane_json(const Plane& plane, const PlaneRemarks& remarks, bool with_cells) {
  const Eigen::Vector3d sigmas = plane.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  Json json{
      {"id", plane.id},
      {"normal", rounded_json(plane.normal, 1e6)},
      {"d", rounded(plane.d_m, 1e5)},
      {"area", rounded(plane.area_m2, 1e4)},
      {"centroid", rounded_json(plane.centroid, 1e4)},
      {"origin", rounded_json(plane.origin, 1e5)},
      {"axis_u", rounded_json(plane.axis_u, 1e6)},
      {"cell", plane.cell_size_m},
      {"ribbons", plane.ribbons.size()},
      {"points", points_of(plane)},
      {"seen", plane.cells.size()},
      {"sigmas", rounded_json(sigmas, 1e7)},
      {"rings", outlines_json(plane.outlines, [&](const auto& r) { return ring_on(plane, r); })}};
  if (!remarks.label.empty()) json["label"] = remarks.label;
  if (remarks.verdict) json["verdict"] = to_json(*remarks.verdict);
  if (with_cells && !plane.cells.empty()) json["cells"] = to_json(packed_cells(plane));
  return text_of(json);
}

}  // namespace ribbon_mapper
