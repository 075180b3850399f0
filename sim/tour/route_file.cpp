// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include <set>
#include <stdexcept>

#include "modeler/text/yaml_error.hpp"
#include "sim/tour/route.hpp"

namespace ribbon_mapper::sim {
namespace {

void check_keys(const YAML::Node& root) {
  if (!root.IsMap()) throw std::runtime_error("needs the keys speed, turn_rate and waypoints");
  static const std::set<std::string> kKeys{"speed", "turn_rate", "waypoints", "rest"};
  std::set<std::string> left = kKeys;
  for (const auto& entry : root) {
    const std::string key = entry.first.as<std::string>();
    if (!kKeys.count(key))
      throw std::runtime_error("unknown key '" + key.substr(0, 60) +
                               "'; use speed, turn_rate, waypoints, rest");
    if (!left.erase(key)) throw std::runtime_error("key '" + key + "' is given twice");
  }
  left.erase("rest");
  if (!left.empty()) throw std::runtime_error("key '" + *left.begin() + "' is missing");
}

double number(const YAML::Node& node, const std::string& key) {
  try {
    return node.as<double>();
  } catch (const YAML::Exception&) {
    throw std::runtime_error("'" + key + "' must be a number");
  }
}

/// Waypoints, and the ground's height at each of them or nothing.
struct Waypoints {
  std::vector<Eigen::Vector2d> points_m;
  std::vector<double> heights_m;
};

Waypoints waypoints_of(const YAML::Node& list) {
  if (!list.IsSequence()) throw std::runtime_error("'waypoints' must be a list of [x, y]");
  Waypoints waypoints;
  bool has_heights = false;
  for (const YAML::Node& point : list) {
    if (!point.IsSequence() || point.size() < 2 || point.size() > 3)
      throw std::runtime_error("waypoint " + std::to_string(waypoints.points_m.size() + 1) +
                               " is not [x, y] or [x, y, z]");
    has_heights = has_heights || point.size() == 3;
    waypoints.points_m.emplace_back(number(point[0], "waypoints"), number(point[1], "waypoints"));
    waypoints.heights_m.push_back(point.size() == 3 ? number(point[2], "waypoints") : 0.0);
  }
  if (!has_heights) waypoints.heights_m.clear();
  return waypoints;
}

}  // namespace

Route Route::load(const std::string& path) {
  try {
    const YAML::Node root = YAML::LoadFile(path);
    check_keys(root);
    const Waypoints waypoints = waypoints_of(root["waypoints"]);
    return {number(root["speed"], "speed"), number(root["turn_rate"], "turn_rate"),
            waypoints.points_m, root["rest"] ? number(root["rest"], "rest") : 0.0,
            waypoints.heights_m};
  } catch (const YAML::Exception& error) {
    throw std::runtime_error("route " + path + ": " + defect_of(error) +
                             "; compare with worlds/apartment.route.yaml");
  } catch (const std::exception& error) {
    throw std::runtime_error("route " + path + ": " + error.what());
  }
}

}  // namespace ribbon_mapper::sim
