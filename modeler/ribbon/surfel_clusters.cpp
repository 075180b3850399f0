// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/surfel_clusters.hpp"

#include <cmath>

#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kNoArea_m2 = 1e-9;  // rounding errors of a sum whose terms are all withdrawn

}  // namespace

SurfelClusters::SurfelClusters(const RibbonConfig& config)
    : min_cosine_(std::cos(config.cluster_angle_deg * kDegree)),
      min_area_m2_(config.min_cluster_area_m2),
      grid_(config.grid_cell_deg),
      intervals_(config.distance_gap_m) {}

void SurfelClusters::classify(const std::vector<Surfel>& surfels,
                              const Eigen::Vector3d& sensor_origin) {
  cluster_.assign(surfels.size(), kNone);
  clusters_ = 0;
  vote(surfels);
  double left_m2 = 0.0;
  for (const Vote& vote : votes_) left_m2 += vote.area_m2;
  while (left_m2 > min_area_m2_ - kNoArea_m2) {
    const OrientationGrid::Peak peak = grid_.peak();
    if (peak.area_m2 <= kNoArea_m2) return;
    // The mean of all normals around the peak is better than the mean of its cell.
    const Eigen::Vector3d sum = sum_around(peak.normal);
    if (sum.isZero(0.0)) return;
    const Orientation found = take_around(sum.normalized());
    if (members_.empty()) return;
    left_m2 -= found.area_m2;
    if (found.area_m2 >= min_area_m2_) split_by_distance(surfels, found.normal, sensor_origin);
  }
}

void SurfelClusters::vote(const std::vector<Surfel>& surfels) {
  grid_.clear();
  votes_.clear();
  for (std::uint32_t i = 0; i < surfels.size(); ++i) {
    const auto cell = static_cast<std::uint32_t>(grid_.vote(surfels[i].normal, surfels[i].area_m2));
    votes_.push_back({surfels[i].normal, surfels[i].area_m2, i, cell});
  }
}

/// Returns the area-weighted sum of the normals within the cluster angle.
Eigen::Vector3d SurfelClusters::sum_around(const Eigen::Vector3d& normal) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Vote& vote : votes_) {
    if (vote.normal.dot(normal) >= min_cosine_) sum += vote.area_m2 * vote.normal;
  }
  return sum;
}

/// Moves the votes within the cluster angle to the members; both keep the order of the surfels.
SurfelClusters::Orientation SurfelClusters::take_around(const Eigen::Vector3d& normal) {
  members_.clear();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area_m2 = 0.0;
  std::size_t left = 0;
  for (const Vote& vote : votes_) {
    if (vote.normal.dot(normal) < min_cosine_) {
      votes_[left++] = vote;
      continue;
    }
    members_.push_back(vote);
    grid_.withdraw(vote.cell, vote.normal, vote.area_m2);
    area_m2 += vote.area_m2;
    sum += vote.area_m2 * vote.normal;
  }
  votes_.resize(left);
  return {sum.normalized(), area_m2};
}

/// Makes one cluster for each distance from the sensor, the second step of section 4.2.
void SurfelClusters::split_by_distance(const std::vector<Surfel>& surfels,
                                       const Eigen::Vector3d& normal,
                                       const Eigen::Vector3d& sensor_origin) {
  distances_m_.clear();
  intervals_.clear();
  const double offset_m = normal.dot(sensor_origin);
  for (const Vote& member : members_) {
    distances_m_.push_back(normal.dot(surfels[member.surfel].point) - offset_m);
    intervals_.add(distances_m_.back());
  }
  for (std::size_t i = 0; i < members_.size(); ++i) {
    cluster_[members_[i].surfel] = clusters_ + static_cast<int>(intervals_.of(distances_m_[i]));
  }
  clusters_ += static_cast<int>(intervals_.size());
}

}  // namespace ribbon_mapper
