// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::python {

/// A plane as Python sees it.
struct LabelledPlane {
  Plane plane;       ///< with its outlines
  PlaneLabel label;  ///< what the rules say that it is
};

/// Planes as Python holds them.
using LabelledPlanes = std::vector<std::shared_ptr<LabelledPlane>>;

/// Returns the planes with labels, given the poses of the robot.
LabelledPlanes labelled(std::vector<Plane> planes, const std::vector<StampedPose>& trajectory);

/// Adds Laser and LineResult to the module.
void bind_lines(pybind11::module_& module);

/// Adds Outline, Plane and planes_to_json() to the module.
void bind_planes(pybind11::module_& module);

/// Adds Statistics and Modeler to the module. Needs the other classes.
void bind_modeler(pybind11::module_& module);

/// Adds read_tum() and to_tum() to the module.
void bind_trajectories(pybind11::module_& module);

}  // namespace ribbon_mapper::python
