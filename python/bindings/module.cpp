// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The compiled part of the Python package ribbon_mapper. The docstrings are those of the stub,
// python/ribbon_mapper/_core.pyi; a test compares names and parameters.
#include "python/bindings/bindings.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() =
      "Planes from the lines of a tilting laser, kept right when SLAM corrects the "
      "trajectory.";
  module.attr("__version__") = RIBBON_MAPPER_VERSION;
  ribbon_mapper::python::bind_lines(module);
  ribbon_mapper::python::bind_planes(module);
  ribbon_mapper::python::bind_modeler(module);
  ribbon_mapper::python::bind_trajectories(module);
}
