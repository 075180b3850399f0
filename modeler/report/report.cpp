// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/report/report.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/report/page.hpp"
#include "modeler/report/plane_json.hpp"
#include "modeler/text/coefficients.hpp"

namespace ribbon_mapper {
namespace {

std::string array_of(const std::vector<std::string>& items) {
  std::string text = "[";
  for (const std::string& item : items) text += (text.size() > 1 ? ",\n" : "") + item;
  return text + "]";
}

/// Returns the largest planes whose cells fit into the limit, by index.
std::vector<bool> planes_with_cells(const std::vector<Plane>& planes, std::size_t limit) {
  std::vector<std::size_t> order(planes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return planes[a].cells.size() > planes[b].cells.size();
  });
  std::vector<bool> chosen(planes.size(), false);
  std::size_t used = 0;
  for (const std::size_t i : order) {
    used += planes[i].cells.size();
    if (used > limit) break;
    chosen[i] = true;
  }
  return chosen;
}

std::string planes_json(const ReportModel& model, std::size_t limit) {
  const std::vector<Plane>& planes = *model.planes;
  const std::vector<bool> with_cells = planes_with_cells(planes, limit);
  std::vector<std::string> texts;
  texts.reserve(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneRemarks remarks = i < model.remarks.size() ? model.remarks[i] : PlaneRemarks();
    texts.push_back(plane_json(planes[i], remarks, with_cells[i]));
  }
  return array_of(texts);
}

}  // namespace

Report::Report(ReportHead head, const ReportLimits& limits)
    : head_(std::move(head)), limits_(limits) {}

std::string Report::trajectory_json(const std::string& name,
                                    const std::vector<StampedPose>& poses) {
  if (!start_ && !poses.empty()) start_ = poses.front().stamp;
  const std::size_t most = std::max<std::size_t>(limits_.poses, 2);
  const std::size_t step = poses.size() <= most ? 1 : (poses.size() + most - 2) / (most - 1);
  Json times = Json::array(), points = Json::array(), headings = Json::array();
  for (std::size_t i = 0; i < poses.size(); i += step) {
    const std::size_t index = i + step < poses.size() ? i : poses.size() - 1;  // the last one stays
    const StampedPose& pose = poses[index];
    times.push_back(std::llround(1e3 * to_seconds(pose.stamp - *start_)));
    for (const double value : coefficients_of(pose.T_map_base.translation())) {
      points.push_back(in_millimetres(value));
    }
    headings.push_back(in_millimetres(yaw_of(pose.T_map_base)));
  }
  return text_of(
      {{"name", name}, {"time_ms", times}, {"points_mm", points}, {"heading_mrad", headings}});
}

void Report::add_trajectory(const std::string& name, const std::vector<StampedPose>& poses) {
  trajectories_.push_back(trajectory_json(name, poses));
}

void Report::add_model(const ReportModel& model) {
  const std::string head = text_of({{"name", model.name}, {"trajectory", model.trajectory}});
  models_.push_back(head.substr(0, head.size() - 1) +
                    ",\"planes\":" + planes_json(model, limits_.cells_of_a_model) + "}");
}

void Report::set_truth(const std::vector<Plane>& planes, const std::vector<StampedPose>& poses) {
  truth_ = "{\"trajectory\":" + trajectory_json("truth", poses) +
           ",\"planes\":" + planes_json({"truth", &planes}, 0) + "}";
}

void Report::add_room(const ReportRoom& room) {
  Json json{{"name", room.name},
            {"area_m2", rounded(room.area_m2, 1e3)},
            {"outlines_mm", outlines_in_map(room.outlines)}};
  if (room.centre) {
    json["centre_mm"] = Json::array();
    for (const double value : coefficients_of(*room.centre))
      json["centre_mm"].push_back(in_millimetres(value));
  }
  rooms_.push_back(text_of(json));
}

void Report::add_table(const ReportTable& table) {
  tables_.push_back(text_of({{"title", table.title}, {"head", table.head}, {"rows", table.rows}}));
}

void Report::add_fact(const std::string& name, const std::string& value) {
  facts_.push_back(text_of(Json::array({name, value})));
}

std::string Report::json() const {
  Json parameters = head_.parameters ? Json::array() : Json(nullptr);
  for (const ChangedKey& key : head_.parameters.value_or(std::vector<ChangedKey>())) {
    parameters.push_back(Json::array({key.name, key.value, key.default_value}));
  }
  const std::string head = text_of({{"format", 1},
                                    {"title", head_.title},
                                    {"frame", head_.frame},
                                    {"run", head_.run},
                                    {"version", head_.version},
                                    {"command", head_.command},
                                    {"parameters", parameters}});
  return head.substr(0, head.size() - 1) + ",\n\"facts\":" + array_of(facts_) +
         ",\n\"tables\":" + array_of(tables_) + ",\n\"rooms\":" + array_of(rooms_) +
         ",\n\"trajectories\":" + array_of(trajectories_) + ",\n\"truth\":" + truth_ +
         ",\n\"models\":" + array_of(models_) + "}";
}

std::string Report::html() const {
  return std::string(page_before_data()) + json() + std::string(page_after_data());
}

}  // namespace ribbon_mapper
