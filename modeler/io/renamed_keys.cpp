// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/renamed_keys.hpp"

#include <map>

namespace ribbon_mapper {
namespace {

/// Keys of version 0.1.0 with their present names.
const std::map<std::string, std::string>& renamed_keys() {
  static const std::map<std::string, std::string> kKeys{
      {"scan.least_range_m", "scan.min_range_m"},
      {"scan.most_range_m", "scan.max_range_m"},
      {"scan.veil_angle_deg", "scan.mixed_pixel_angle_deg"},
      {"ribbon.least_cluster_area_m2", "ribbon.min_cluster_area_m2"},
      {"ribbon.bevel_sigmas", "ribbon.edge_sigmas"},
      {"ribbon.bevel_slack_m", "ribbon.edge_slack_m"},
      {"ribbon.least_incidence_deg", "ribbon.min_grazing_angle_deg"},
      {"ribbon.least_length_m", "ribbon.min_length_m"},
      {"ribbon.least_points", "ribbon.min_points"},
      {"map.slam.angle_deg", "association.slam.angle_deg"},
      {"map.slam.distance_m", "association.slam.distance_m"},
      {"map.corrected.angle_deg", "association.corrected.angle_deg"},
      {"map.corrected.distance_m", "association.corrected.distance_m"},
      {"map.bridged_gap_m", "surface.bridged_gap_m"},
      {"map.stripe_gap_m", "surface.stripe_gap_m"},
      {"map.cell_size_m", "surface.cell_size_m"},
      {"map.most_ribbons", "observations.max_ribbons"},
      {"map.confirmed_ribbons", "assembly.min_ribbons"},
      {"map.confirmed_area_m2", "assembly.min_area_as_built_m2"},
      {"map.least_area_m2", "assembly.min_area_m2"},
      {"map.least_radius_m", "assembly.min_radius_m"},
      {"map.flat_within_m", "assembly.flat_within_m"},
      {"map.curvature_sigmas", "assembly.curvature_sigmas"},
      {"map.on_plane_m", "assembly.on_plane_m"},
      {"map.beside_plane_m", "assembly.beside_plane_m"},
      {"correction.poses_follow", "trajectory.poses_follow"},
  };
  return kKeys;
}

}  // namespace

std::optional<std::string> present_name_of(const std::string& former_key) {
  const auto found = renamed_keys().find(former_key);
  if (found == renamed_keys().end()) return std::nullopt;
  return found->second;
}

}  // namespace ribbon_mapper
