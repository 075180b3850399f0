// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/modeler_config.hpp"

namespace ribbon_mapper {
namespace config_keys {

// One function per section; see visit_keys().

/// Visits the keys of section `scan`.
template <typename Section, typename Visitor>
void visit_scan(Section& section, Visitor& visit) {
  visit("scan.range_sigma_m", section.range_sigma_m, 1e-4, 1.0);
  visit("scan.direction_sigma_deg", section.direction_sigma_deg, 0.0, 5.0);
  visit("scan.min_range_m", section.min_range_m, 0.0, 100.0);
  visit("scan.max_range_m", section.max_range_m, 0.1, 1000.0);
  visit("scan.body_half_size_m", section.body_half_size_m, 0.0, 10.0);
  visit("scan.body_height_m", section.body_height_m, 0.0, 10.0);
  visit("scan.mixed_pixel_angle_deg", section.mixed_pixel_angle_deg, 0.0, 45.0);
  visit("scan.line_step_sigmas", section.line_step_sigmas, 0.0, 100.0);
  visit("scan.base_line_sigmas", section.base_line_sigmas, 0.0, 100.0);
  visit("scan.deskew", section.deskew);
}

/// Visits the keys of section `ribbon`.
template <typename Section, typename Visitor>
void visit_ribbon(Section& section, Visitor& visit) {
  visit("ribbon.neighbourhood_m", section.neighbourhood_m, 0.01, 5.0);
  visit("ribbon.grid_cell_deg", section.grid_cell_deg, 0.5, 45.0);
  visit("ribbon.cluster_angle_deg", section.cluster_angle_deg, 1.0, 60.0);
  visit("ribbon.area_cap_m2", section.area_cap_m2, 1e-6, 10.0);
  visit("ribbon.min_cluster_area_m2", section.min_cluster_area_m2, 0.0, 10.0);
  visit("ribbon.distance_gap_m", section.distance_gap_m, 1e-3, 10.0);
  visit("ribbon.outlier_sigmas", section.outlier_sigmas, 1.0, 10.0);
  visit("ribbon.min_bend_deg", section.min_bend_deg, 0.5, 90.0);
  visit("ribbon.edge_sigmas", section.edge_sigmas, 1.0, 100.0);
  visit("ribbon.edge_slack_m", section.edge_slack_m, 0.0, 1.0);
  visit("ribbon.min_grazing_angle_deg", section.min_grazing_angle_deg, 0.0, 90.0);
  visit("ribbon.min_length_m", section.min_length_m, 0.01, 10.0);
  visit("ribbon.min_points", section.min_points, 3, 1000);
  visit("ribbon.sample_length_m", section.sample_length_m, 1e-3, 1.0);
}

/// Visits the keys of section `trajectory`.
template <typename Section, typename Visitor>
void visit_trajectory(Section& section, Visitor& visit) {
  visit("trajectory.poses_follow", section.poses_follow);
}

/// Visits the keys of section `observations`.
template <typename Section, typename Visitor>
void visit_observations(Section& section, Visitor& visit) {
  visit("observations.max_ribbons", section.max_ribbons, 0, 100'000'000);
}

/// Visits the keys of section `association`.
template <typename Section, typename Visitor>
void visit_association(Section& section, Visitor& visit) {
  visit("association.slam.angle_deg", section.slam.angle_deg, 0.1, 45.0);
  visit("association.slam.distance_m", section.slam.distance_m, 1e-3, 10.0);
  visit("association.corrected.angle_deg", section.corrected.angle_deg, 0.1, 45.0);
  visit("association.corrected.distance_m", section.corrected.distance_m, 1e-3, 10.0);
  visit("association.checkpoint_ribbons", section.checkpoint_ribbons, 0, 1000000);
}

/// Visits the keys of section `surface`.
template <typename Section, typename Visitor>
void visit_surface(Section& section, Visitor& visit) {
  visit("surface.cell_size_m", section.cell_size_m, 0.01, 1.0);
  visit("surface.stripe_gap_m", section.stripe_gap_m, 0.01, 10.0);
  visit("surface.outline_tolerance_m", section.outline_tolerance_m, 0.001, 1.0);
  visit("surface.bridged_gap_m", section.bridged_gap_m, 0.05, 10.0);
}

/// Visits the keys of section `assembly`.
template <typename Section, typename Visitor>
void visit_assembly(Section& section, Visitor& visit) {
  visit("assembly.min_ribbons", section.min_ribbons, 1, 100000);
  visit("assembly.min_area_as_built_m2", section.min_area_as_built_m2, 0.0, 1000.0);
  visit("assembly.min_area_m2", section.min_area_m2, 0.0, 1000.0);
  visit("assembly.min_radius_m", section.min_radius_m, 0.0, 1000.0);
  visit("assembly.flat_within_m", section.flat_within_m, 0.0, 10.0);
  visit("assembly.curvature_sigmas", section.curvature_sigmas, 0.0, 100.0);
  visit("assembly.on_plane_m", section.on_plane_m, 0.0, 1.0);
  visit("assembly.beside_plane_m", section.beside_plane_m, 0.01, 10.0);
  visit("assembly.passed_lines", section.passed_lines, 0, 1000);
  visit("assembly.passed_beyond_m", section.passed_beyond_m, 0.01, 10.0);
}

/// Visits the keys of section `registration`.
template <typename Section, typename Visitor>
void visit_registration(Section& section, Visitor& visit) {
  visit("registration.enabled", section.enabled);
  visit("registration.rounds", section.rounds, 1, 100);
  visit("registration.passes_per_round", section.passes_per_round, 1, 100);
  visit("registration.adjustments_per_round", section.adjustments_per_round, 0, 100);
  visit("registration.min_ribbons", section.min_ribbons, 1, 100000);
  visit("registration.shared_sigma_ratio", section.shared_sigma_ratio, 0.0, 10.0);
  visit("registration.max_tilt_across_deg", section.max_tilt_across_deg, 0.1, 60.0);
  visit("registration.max_chi_square", section.max_chi_square, 0.1, 1000.0);
  visit("registration.min_chi_square_lead", section.min_chi_square_lead, 0.0, 1000.0);
  visit("registration.robust_sigmas", section.robust_sigmas, 0.1, 100.0);
  visit("registration.start_gate_ratio", section.start_gate_ratio, 0.0, 10.0);
  visit("registration.final_gate_ratio", section.final_gate_ratio, 0.0, 10.0);
}

/// Visits the keys of section `maps`.
template <typename Section, typename Visitor>
void visit_maps(Section& section, Visitor& visit) {
  visit("maps.voxel_m", section.voxel_m, 0.01, 1.0);
  visit("maps.surface_margin_m", section.surface_margin_m, 0.0, 1.0);
  visit("maps.obstacle_min_m", section.obstacle_min_m, 0.0, 10.0);
  visit("maps.obstacle_max_m", section.obstacle_max_m, 0.0, 100.0);
  visit("maps.min_free_share", section.min_free_share, 0.0, 1.0);
}

}  // namespace config_keys

/// Visits every key of the configuration: `visit(name, value, min, max)` for numbers with their
/// allowed range, `visit(name, value)` for switches. The config structs explain each value.
template <typename Config, typename Visitor>
void visit_keys(Config& config, Visitor& visit) {
  config_keys::visit_scan(config.scan, visit);
  config_keys::visit_ribbon(config.ribbon, visit);
  config_keys::visit_trajectory(config.trajectory, visit);
  config_keys::visit_observations(config.observations, visit);
  config_keys::visit_association(config.association, visit);
  config_keys::visit_surface(config.surface, visit);
  config_keys::visit_assembly(config.assembly, visit);
  config_keys::visit_registration(config.registration, visit);
  config_keys::visit_maps(config.maps, visit);
}

}  // namespace ribbon_mapper
