// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/modeler_config.hpp"

namespace ribbon_mapper {

/// Visits every key of the configuration: `visit(name, value, min, max)` for numbers with their
/// allowed range, `visit(name, value)` for switches. The config structs explain each value.
template <typename Config, typename Visitor>
void visit_keys(Config& config, Visitor& visit) {
  auto& scan = config.scan;
  visit("scan.range_sigma_m", scan.range_sigma_m, 1e-4, 1.0);
  visit("scan.direction_sigma_deg", scan.direction_sigma_deg, 0.0, 5.0);
  visit("scan.min_range_m", scan.min_range_m, 0.0, 100.0);
  visit("scan.max_range_m", scan.max_range_m, 0.1, 1000.0);
  visit("scan.body_half_size_m", scan.body_half_size_m, 0.0, 10.0);
  visit("scan.body_height_m", scan.body_height_m, 0.0, 10.0);
  visit("scan.mixed_pixel_angle_deg", scan.mixed_pixel_angle_deg, 0.0, 45.0);
  visit("scan.line_step_sigmas", scan.line_step_sigmas, 0.0, 100.0);
  visit("scan.base_line_sigmas", scan.base_line_sigmas, 0.0, 100.0);
  visit("scan.deskew", scan.deskew);

  auto& ribbon = config.ribbon;
  visit("ribbon.neighbourhood_m", ribbon.neighbourhood_m, 0.01, 5.0);
  visit("ribbon.grid_cell_deg", ribbon.grid_cell_deg, 0.5, 45.0);
  visit("ribbon.cluster_angle_deg", ribbon.cluster_angle_deg, 1.0, 60.0);
  visit("ribbon.area_cap_m2", ribbon.area_cap_m2, 1e-6, 10.0);
  visit("ribbon.min_cluster_area_m2", ribbon.min_cluster_area_m2, 0.0, 10.0);
  visit("ribbon.distance_gap_m", ribbon.distance_gap_m, 1e-3, 10.0);
  visit("ribbon.outlier_sigmas", ribbon.outlier_sigmas, 1.0, 10.0);
  visit("ribbon.edge_sigmas", ribbon.edge_sigmas, 1.0, 100.0);
  visit("ribbon.edge_slack_m", ribbon.edge_slack_m, 0.0, 1.0);
  visit("ribbon.min_grazing_angle_deg", ribbon.min_grazing_angle_deg, 0.0, 90.0);
  visit("ribbon.min_length_m", ribbon.min_length_m, 0.01, 10.0);
  visit("ribbon.min_points", ribbon.min_points, 3, 1000);
  visit("ribbon.sample_length_m", ribbon.sample_length_m, 1e-3, 1.0);

  visit("trajectory.poses_follow", config.trajectory.poses_follow);
  visit("observations.max_ribbons", config.observations.max_ribbons, 0, 100'000'000);

  auto& association = config.association;
  visit("association.slam.angle_deg", association.slam.angle_deg, 0.1, 45.0);
  visit("association.slam.distance_m", association.slam.distance_m, 1e-3, 10.0);
  visit("association.corrected.angle_deg", association.corrected.angle_deg, 0.1, 45.0);
  visit("association.corrected.distance_m", association.corrected.distance_m, 1e-3, 10.0);

  auto& surface = config.surface;
  visit("surface.cell_size_m", surface.cell_size_m, 0.01, 1.0);
  visit("surface.stripe_gap_m", surface.stripe_gap_m, 0.01, 10.0);
  visit("surface.bridged_gap_m", surface.bridged_gap_m, 0.05, 10.0);

  auto& assembly = config.assembly;
  visit("assembly.min_ribbons", assembly.min_ribbons, 1, 100000);
  visit("assembly.min_area_as_built_m2", assembly.min_area_as_built_m2, 0.0, 1000.0);
  visit("assembly.min_area_m2", assembly.min_area_m2, 0.0, 1000.0);
  visit("assembly.min_radius_m", assembly.min_radius_m, 0.0, 1000.0);
  visit("assembly.flat_within_m", assembly.flat_within_m, 0.0, 10.0);
  visit("assembly.curvature_sigmas", assembly.curvature_sigmas, 0.0, 100.0);
  visit("assembly.on_plane_m", assembly.on_plane_m, 0.0, 1.0);
  visit("assembly.beside_plane_m", assembly.beside_plane_m, 0.01, 10.0);

  auto& registration = config.registration;
  visit("registration.enabled", registration.enabled);
  visit("registration.rounds", registration.rounds, 1, 100);
  visit("registration.passes_per_round", registration.passes_per_round, 1, 100);
  visit("registration.adjustments_per_round", registration.adjustments_per_round, 0, 100);
  visit("registration.min_ribbons", registration.min_ribbons, 1, 100000);
  visit("registration.shared_sigma_ratio", registration.shared_sigma_ratio, 0.0, 10.0);
  visit("registration.max_tilt_across_deg", registration.max_tilt_across_deg, 0.1, 60.0);
  visit("registration.max_chi_square", registration.max_chi_square, 0.1, 1000.0);
  visit("registration.min_chi_square_lead", registration.min_chi_square_lead, 0.0, 1000.0);
  visit("registration.robust_sigmas", registration.robust_sigmas, 0.1, 100.0);
  visit("registration.start_gate_ratio", registration.start_gate_ratio, 0.0, 10.0);
  visit("registration.final_gate_ratio", registration.final_gate_ratio, 0.0, 10.0);
}

}  // namespace ribbon_mapper
