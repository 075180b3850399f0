// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <stdexcept>
#include <utility>

#include "modeler/io/config_file.hpp"
#include "modeler/scan/scan_line.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/session.hpp"

namespace ribbon_mapper::python {
namespace {

constexpr const char* kModeler =
    R"(Builds planes from the lines of a tilting laser, and keeps them right when the trajectory is
corrected.

The same lines and corrections give the same bytes as in the C++ programs. Methods release the
global lock (GIL); calls of several threads for one modeler wait for each other. A call that
raises leaves the model as it was.)";

constexpr const char* kNewModeler =
    R"(Begins with an empty model.

`preset` is a YAML file such as config/pr2.yaml; keys that it lacks, and all without a preset,
have their defaults. Raises ValueError with the file and the key if it is wrong.)";

constexpr const char* kLoad =
    R"(Goes on from a model file, by the configuration in the file or by another preset.

Takes as long as a correction. Raises ValueError with the file and the reason.)";

constexpr const char* kSave =
    R"(Writes a model file, which load() and the programs go on from (docs/model_file.md).

An existing file is replaced as a whole. Raises OSError with the file and the reason.)";

constexpr const char* kAddScanLine =
    R"(Adds a scan line. Returns what became of it.

stamp_ns: time of the first beam, an int of nanoseconds.
ranges_m: range of each beam, (n,); nan and inf are no returns.
T_odom_base: pose of the robot's base in odom, the frame in which it moves without jumps.
T_base_laser: pose of the laser in base.
T_map_base: pose of the base in map, half way between the first and the last beam. Without it,
    map is odom.

A pose is a 4 x 4 matrix, or the seven numbers x, y, z, qx, qy, qz, qw. T_odom_base and
T_base_laser may be two poses each, at the first and at the last beam. Raises ValueError if an
argument cannot be; the line is then not counted.)";

constexpr const char* kCorrect =
    R"(Replaces the trajectory by a corrected one and evaluates the model again.

stamps_ns: strictly ascending times in nanoseconds, (n,).
poses: poses of the base in map at these times, (n, 4, 4) or (n, 7).

A pose per metre is enough, because lines in between are registered to planes. Each correction
replaces the one before. Raises ValueError if the trajectory is empty, unordered or of another
time than the lines, or a pose is wrong.)";

constexpr const char* kPlanes =
    R"(Computes the planes, merged and filtered, with outlines and labels, ordered by id.)";

constexpr const char* kPlanesAsBuilt =
    R"(Computes the planes as ribbons were associated one after the other, without outlines.)";

constexpr const char* kTrajectory =
    R"(Returns (stamps_ns, poses): the poses of the base in map as they are now, one for each line in the
model, of shapes (n,) and (n, 4, 4).)";

ModelerConfig config_of(const py::object& preset) {
  return preset.is_none() ? ModelerConfig{} : load_config(path_of(preset));
}

std::unique_ptr<Session> new_session(const py::object& preset) {
  return std::make_unique<Session>(config_of(preset));
}

std::unique_ptr<Session> load(const py::object& path, const py::object& preset) {
  const std::string file_path = path_of(path);
  const ModelerConfig other = config_of(preset);
  const bool has_other = !preset.is_none();
  const py::gil_scoped_release without_gil;
  try {
    ModelFile file = load_model_file(file_path);
    const ModelerConfig config = has_other ? other : file.config;
    return std::make_unique<Session>(config, std::move(file));
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

void save(Session& session, const py::object& path) {
  const std::string file = path_of(path);
  try {
    session.save(file);
  } catch (const std::runtime_error& error) {
    PyErr_SetString(PyExc_OSError, error.what());
    throw py::error_already_set();
  }
}

LineResult add_scan_line(Session& session, const py::object& stamp_ns, const py::object& ranges_m,
                         const LaserBeams& laser, const py::object& T_odom_base,
                         const py::object& T_base_laser, const py::object& T_map_base) {
  LaserBeams beams = laser;
  beams.stamp = stamp_of(stamp_ns, "stamp_ns");
  beams.ranges_m = ranges_of(ranges_m, "ranges_m");
  LinePoses poses;
  std::tie(poses.T_odom_base_first, poses.T_odom_base_last) =
      first_and_last_pose_of(T_odom_base, "T_odom_base");
  std::tie(poses.T_base_laser_first, poses.T_base_laser_last) =
      first_and_last_pose_of(T_base_laser, "T_base_laser");
  poses.T_map_base = T_map_base.is_none()
                         ? interpolate(poses.T_odom_base_first, poses.T_odom_base_last, 0.5)
                         : pose_of(T_map_base, "T_map_base");
  if (const auto defect = find_defect(beams, poses)) throw std::invalid_argument(*defect);
  return session.run([&](Modeler& modeler) { return modeler.add_scan_line(beams, poses); });
}

void correct(Session& session, const py::object& stamps_ns, const py::object& poses) {
  const std::vector<StampedPose> trajectory = trajectory_of(stamps_ns, poses);
  session.run([&](Modeler& modeler) { modeler.correct(trajectory); });
}

LabelledPlanes planes(Session& session) {
  return session.run(
      [](Modeler& modeler) { return labelled(modeler.planes(), modeler.trajectory()); });
}

LabelledPlanes planes_as_built(Session& session) {
  return session.run(
      [](Modeler& modeler) { return labelled(modeler.planes_as_built(), modeler.trajectory()); });
}

py::tuple trajectory(Session& session) {
  return to_python(session.run([](Modeler& modeler) { return modeler.trajectory(); }));
}

ModelStatistics statistics(Session& session) {
  return session.run([](Modeler& modeler) { return modeler.statistics(); });
}

std::string preset_of(Session& session) {
  return session.run([](Modeler& modeler) { return config_to_yaml(modeler.config()); });
}

void bind_statistics(py::module_& module) {
  py::class_<ModelStatistics>(module, "Statistics", "Counts of what a modeler has done.")
      .def_readonly("lines", &ModelStatistics::lines, "Lines given to add_scan_line().")
      .def_readonly("ribbons", &ModelStatistics::ribbons, "Ribbons in the model.")
      .def_readonly("thinned", &ModelStatistics::thinned,
                    "Ribbons removed because of observations.max_ribbons.")
      .def_readonly("revision", &ModelStatistics::revision, "Corrections applied.");
}

}  // namespace

void bind_modeler(py::module_& module) {
  bind_statistics(module);
  const auto none = py::none();
  py::class_<Session>(module, "Modeler", kModeler)
      .def(py::init(&new_session), py::arg("preset") = none, kNewModeler)
      .def_static("load", &load, py::arg("path"), py::arg("preset") = none, kLoad)
      .def("save", &save, py::arg("path"), kSave)
      .def("add_scan_line", &add_scan_line, py::arg("stamp_ns"), py::arg("ranges_m"),
           py::arg("laser"), py::arg("T_odom_base"), py::arg("T_base_laser"),
           py::arg("T_map_base") = none, kAddScanLine)
      .def("correct", &correct, py::arg("stamps_ns"), py::arg("poses"), kCorrect)
      .def("planes", &planes, kPlanes)
      .def("planes_as_built", &planes_as_built, kPlanesAsBuilt)
      .def("trajectory", &trajectory, kTrajectory)
      .def("statistics", &statistics, "Returns counts of what has been done.")
      .def(
          "reset", [](Session& session) { session.run([](Modeler& modeler) { modeler.reset(); }); },
          "Removes all observations: the model is empty again.")
      .def_property_readonly("preset", &preset_of, "The configuration with all its keys, as YAML.");
}

}  // namespace ribbon_mapper::python
