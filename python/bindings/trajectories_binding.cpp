// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "modeler/io/tum.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"

namespace ribbon_mapper::python {
namespace {

constexpr const char* kReadTum =
    R"(Reads a trajectory in the TUM format, lines of 'stamp tx ty tz qx qy qz qw'.

Returns (stamps_ns, poses) of shapes (n,) and (n, 4, 4), as Modeler.correct() takes them. Raises
ValueError with the line that is wrong, or if the file cannot be read.)";

constexpr const char* kToTum =
    R"(Returns a trajectory as text in the TUM format, with stamps exact to the nanosecond.

Takes stamps and poses as Modeler.correct() does.)";

py::tuple read(const py::object& path) {
  try {
    return to_python(read_tum(path_of(path)));
  } catch (const std::runtime_error& error) {
    throw py::value_error(error.what());
  }
}

}  // namespace

void bind_trajectories(py::module_& module) {
  module.def("read_tum", &read, py::arg("path"), kReadTum);
  module.def(
      "to_tum",
      [](const py::object& stamps_ns, const py::object& poses) {
        return to_tum(trajectory_of(stamps_ns, poses));
      },
      py::arg("stamps_ns"), py::arg("poses"), kToTum);
}

}  // namespace ribbon_mapper::python
