// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/report/report.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/semantics/rooms.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// A model before and after the correction of its trajectory.
struct ModelHistory {
  std::string name_before;                            ///< of the model before
  const std::vector<Plane>* planes_before = nullptr;  ///< with outlines; null: no such model
  std::vector<StampedPose> trajectory_before;         ///< acquisition poses of the model before
  std::string name;                                   ///< of the model
  const std::vector<Plane>* planes = nullptr;         ///< with outlines; not null
  std::vector<StampedPose> trajectory;                ///< acquisition poses of the model
  std::vector<PlaneLabel> labels = {};                ///< of `planes`, or none
  Rooms rooms = {};                                   ///< of `planes`
};

/// Returns what labels say of planes, in their order.
std::vector<PlaneRemarks> remarks_of(const std::vector<PlaneLabel>& labels);

/// Adds rooms to a page, with their names.
void add_rooms(const Rooms& rooms, Report& report);

/// Returns a page of a model whose truth is unknown.
Report report_of(const ReportHead& head, const ModelHistory& history);

}  // namespace ribbon_mapper
