// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "modeler/scan/laser_beams.hpp"
#include "modeler/scan/scan_front_end.hpp"
#include "modeler/scan/scan_line.hpp"
#include "python/bindings/bindings.hpp"

namespace ribbon_mapper::python {
namespace {

namespace py = pybind11;

constexpr const char* kLaser =
    R"(What a 2D laser's driver says of each line: `sensor_msgs/LaserScan` without stamp and ranges.

Beam i points at `angle_min_rad + i * angle_increment_rad` about the z axis of the laser's frame,
with 0 along x. It is fired `i * time_increment_s` after the first one. A range is a return only
if it is finite and within `range_min_m` .. `range_max_m`.)";

constexpr const char* kNewLaser =
    R"(Describes a laser. Raises ValueError if angles, times or ranges cannot be.)";

constexpr const char* kLineResult =
    R"(What became of a scan line.

A line completes the neighbourhood of earlier ones: the first three results tell what came of
these.)";

LaserBeams new_laser(double angle_min_rad, double angle_increment_rad, double time_increment_s,
                     double range_min_m, double range_max_m) {
  LaserBeams laser{
      Time(0), angle_min_rad, angle_increment_rad, time_increment_s, range_min_m, range_max_m, {}};
  if (const auto defect = find_defect(laser, LinePoses{})) throw std::invalid_argument(*defect);
  return laser;
}

py::str text_of(const LaserBeams& laser) {
  return py::str(
             "Laser(angle_min_rad={}, angle_increment_rad={}, time_increment_s={}, "
             "range_min_m={}, range_max_m={})")
      .format(laser.angle_min_rad, laser.angle_increment_rad, laser.time_increment_s,
              laser.range_min_m, laser.range_max_m);
}

void bind_laser(py::module_& module) {
  py::class_<LaserBeams>(module, "Laser", kLaser)
      .def(py::init(&new_laser), py::kw_only(), py::arg("angle_min_rad"),
           py::arg("angle_increment_rad"), py::arg("time_increment_s"), py::arg("range_min_m"),
           py::arg("range_max_m"), kNewLaser)
      .def_readonly("angle_min_rad", &LaserBeams::angle_min_rad, "Angle of the first beam.")
      .def_readonly("angle_increment_rad", &LaserBeams::angle_increment_rad,
                    "Angle from each beam to the next; not 0.")
      .def_readonly("time_increment_s", &LaserBeams::time_increment_s,
                    "Time from each beam to the next.")
      .def_readonly("range_min_m", &LaserBeams::range_min_m, "Smallest valid range.")
      .def_readonly("range_max_m", &LaserBeams::range_max_m, "Largest valid range.")
      .def("__repr__", &text_of);
}

}  // namespace

void bind_lines(py::module_& module) {
  bind_laser(module);
  py::enum_<LineResult>(module, "LineResult", kLineResult)
      .value("modelled", LineResult::modelled, "Ribbons of an earlier line are now in the model.")
      .value("waiting", LineResult::waiting, "No line has neighbours far enough away yet.")
      .value("no_ribbons", LineResult::no_ribbons, "The earlier line that it completed has none.")
      .value("too_close", LineResult::too_close, "It has hardly moved since the line before it.")
      .value("no_returns", LineResult::no_returns, "Not a single range is valid.")
      .value("out_of_order", LineResult::out_of_order,
             "Its stamp is not later than that of the line before it.");
}

}  // namespace ribbon_mapper::python
