// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/slam_adapter/rtabmap_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "modeler/ros/slam_adapter/wire_reader.hpp"

namespace ribbon_mapper {
namespace {

/// The numbers of some fields by their paths, in the order of the message.
using Columns = std::map<std::string, std::vector<double>>;

const std::vector<std::string> kPose{"position.x",    "position.y",    "position.z",
                                     "orientation.w", "orientation.x", "orientation.y",
                                     "orientation.z"};

Columns read(const std::string& definition, const std::uint8_t* data, std::size_t size) {
  Columns columns;
  for (const std::string& prefix : {std::string(), std::string("graph.")}) {
    columns[prefix + "posesId"];
    for (const std::string& part : kPose) columns[prefix + "poses." + part];
  }
  columns["nodes.id"], columns["nodes.stamp"];
  WireReader(definition).read(data, size, [&](const std::string& path, double value) {
    const auto column = columns.find(path);
    if (column != columns.end()) column->second.push_back(value);
  });
  return columns;
}

int id_of(double number) {
  if (std::abs(number) <= std::numeric_limits<int>::max()) return static_cast<int>(number);
  throw std::invalid_argument("an id is no number of 32 bits");
}

std::map<int, Pose> poses_in(Columns& columns, const std::string& prefix) {
  const std::vector<double>& ids = columns[prefix + "posesId"];
  std::map<int, Pose> poses;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    std::vector<double> v;
    for (const std::string& part : kPose) {
      const std::vector<double>& column = columns[prefix + "poses." + part];
      if (i >= column.size()) throw std::invalid_argument("the graph has ids without poses");
      v.push_back(column[i]);
    }
    const Eigen::Quaterniond rotation(v[3], v[4], v[5], v[6]);
    if (!(std::abs(rotation.norm() - 1.0) < 0.01)) continue;
    const Pose pose(Eigen::Translation3d(v[0], v[1], v[2]) * rotation.normalized());
    if (is_valid(pose)) poses[id_of(ids[i])] = pose;
  }
  return poses;
}

}  // namespace

void RtabmapGraph::take(const std::string& definition, const std::uint8_t* data, std::size_t size) {
  Columns columns = read(definition, data, size);
  const std::vector<double>&ids = columns["nodes.id"], &stamps = columns["nodes.stamp"];
  for (std::size_t i = 0; i < std::min(ids.size(), stamps.size()); ++i) {
    if (stamps[i] > 0.0 && stamps[i] < 4e9) stamps_[id_of(ids[i])] = from_seconds(stamps[i]);
  }
  const bool has_nodes = !columns["graph.posesId"].empty();
  std::map<int, Pose> poses = poses_in(columns, has_nodes ? "graph." : "");
  if (poses.empty() && ids.empty()) {
    throw std::invalid_argument("neither a MapGraph nor a MapData of RTAB-Map, or an empty one");
  }
  if (!poses.empty()) poses_ = std::move(poses);
}

std::vector<StampedPose> RtabmapGraph::trajectory() const {
  std::map<Time, Pose> ordered;
  for (const auto& [id, pose] : poses_) {
    const auto stamp = stamps_.find(id);
    if (stamp != stamps_.end()) ordered[stamp->second] = pose;
  }
  std::vector<StampedPose> trajectory;
  for (const auto& [stamp, pose] : ordered) trajectory.push_back({stamp, pose});
  return trajectory;
}

}  // namespace ribbon_mapper
