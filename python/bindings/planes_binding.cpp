// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include "modeler/io/planes_json.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"

namespace ribbon_mapper::python {
namespace {

constexpr const char* kPlane =
    R"(A bounded plane of a model, n.p + d = 0, in the map frame.

The corner of cell (u, v) is origin + cell_size_m * (u * axis_u + v * axis_v); `cell_centres` has
their centres. Arrays are copies; `cells` is a view that cannot be written.)";

constexpr const char* kCells =
    R"(Seen cells, sorted by (v, u): a structured array with the fields u and v, count (of points), and
mean_m and variance_m2 of their signed distances from the plane.)";

constexpr const char* kCovariance =
    R"(Covariance, (3, 3), of the rotations about axis_u and axis_v [rad] and of the offset at the
centroid [m].)";

constexpr const char* kLabel =
    R"(What the rules of docs/labels.md say that it is, for example 'wall' or 'floor'.)";

constexpr const char* kPlanesToJson =
    R"(Returns planes as JSON, as the files of the programs have them (docs/exports.md).

The same planes give the same bytes.)";

using PlaneClass = py::class_<LabelledPlane, std::shared_ptr<LabelledPlane>>;

/// Returns a view of the plane's cells that keeps the plane alive.
py::array cells_of(const py::object& self) {
  const Plane& plane = self.cast<const LabelledPlane&>().plane;
  py::array cells(py::dtype::of<PlaneCell>(), {static_cast<py::ssize_t>(plane.cells.size())},
                  {static_cast<py::ssize_t>(sizeof(PlaneCell))}, plane.cells.data(), self);
  cells.attr("setflags")(py::arg("write") = false);
  return cells;
}

py::array_t<double> cell_centres_of(const LabelledPlane& self) {
  std::vector<Eigen::Vector3d> centres;
  centres.reserve(self.plane.cells.size());
  for (const PlaneCell& cell : self.plane.cells) centres.push_back(cell_centre(self.plane, cell));
  return to_python(centres);
}

py::list holes_of(const Outline& outline) {
  py::list holes;
  for (const auto& hole : outline.holes) holes.append(to_python(hole));
  return holes;
}

/// Returns a function that gets a member of a plane as an array.
template <typename Member>
auto array(Member Plane::*member) {
  return [member](const LabelledPlane& self) { return to_python(self.plane.*member); };
}

/// Returns a function that gets a member of a plane as it is.
template <typename Member>
auto value(Member Plane::*member) {
  return [member](const LabelledPlane& self) { return self.plane.*member; };
}

py::str text_of(const LabelledPlane& self) {
  const Plane& plane = self.plane;
  return py::str(
             "<ribbon_mapper.Plane {}, {}: normal ({:.3f}, {:.3f}, {:.3f}), d {:.3f} m, "
             "area {:.2f} m2>")
      .format(plane.id, self.label.text, plane.normal.x(), plane.normal.y(), plane.normal.z(),
              plane.d_m, plane.area_m2);
}

void add_grid(PlaneClass& plane) {
  plane.def_property_readonly("cell_size_m", value(&Plane::cell_size_m), "Side of a cell.")
      .def_property_readonly("origin", array(&Plane::origin),
                             "Corner (0, 0) of the grid of cells, on the plane [m].")
      .def_property_readonly("axis_u", array(&Plane::axis_u),
                             "Direction of the columns; horizontal on walls.")
      .def_property_readonly("axis_v", array(&Plane::axis_v), "Direction of the rows.")
      .def_property_readonly("cells", &cells_of, kCells)
      .def_property_readonly("cell_centres", &cell_centres_of,
                             "Centres of the seen cells, (n, 3), on the plane [m].");
}

void bind_plane(py::module_& module) {
  PlaneClass plane(module, "Plane", kPlane);
  plane
      .def_property_readonly("id", value(&Plane::id),
                             "Identifier, which persists over corrections.")
      .def_property_readonly("normal", array(&Plane::normal),
                             "Unit normal n, (3,), to the side that the plane was seen from.")
      .def_property_readonly("d_m", value(&Plane::d_m), "d of n.p + d = 0.")
      .def_property_readonly("area_m2", value(&Plane::area_m2), "Area of the seen cells.")
      .def_property_readonly("centroid", array(&Plane::centroid),
                             "Mean of the seen cells' centres [m].")
      .def_property_readonly("covariance", array(&Plane::covariance), kCovariance)
      .def_property_readonly(
          "ribbon_count", [](const LabelledPlane& self) { return self.plane.ribbons.size(); },
          "Number of ribbons.")
      .def_property_readonly(
          "outlines", [](const LabelledPlane& self) { return self.plane.outlines; },
          "Boundaries of what was seen. Planes as built have none.")
      .def_property_readonly(
          "label", [](const LabelledPlane& self) { return self.label.text; }, kLabel)
      .def_property_readonly(
          "label_confidence", [](const LabelledPlane& self) { return self.label.confidence; },
          "How sure the label is, from 0 to 1.")
      .def("__repr__", &text_of);
  add_grid(plane);
}

std::string planes_json(const LabelledPlanes& planes, const std::string& frame) {
  std::vector<Plane> bare;
  std::vector<PlaneLabel> labels;
  for (const auto& each : planes) {
    if (!each) throw py::type_error("planes must be planes, not None");
    bare.push_back(each->plane);
    labels.push_back(each->label);
  }
  ModelLabel label;
  label.frame = frame;
  return planes_to_json(bare, label, labels);
}

}  // namespace

LabelledPlanes labelled(std::vector<Plane> planes, const std::vector<StampedPose>& trajectory) {
  const Semantics semantics = semantics_of(planes, positions_of(trajectory));
  const std::vector<const Annotation*> none(planes.size());
  const std::vector<PlaneLabel> labels = plane_labels(planes, semantics, none);
  LabelledPlanes result;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    result.push_back(
        std::make_shared<LabelledPlane>(LabelledPlane{std::move(planes[i]), labels[i]}));
  }
  return result;
}

void bind_planes(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(PlaneCell, u, v, count, mean_m, variance_m2);
  py::class_<Outline>(module, "Outline", "An area with holes on a plane. Points are in map [m].")
      .def_property_readonly(
          "outer", [](const Outline& self) { return to_python(self.outer); },
          "Outer boundary, (n, 3), counter-clockwise about the normal; the first point is not "
          "repeated.")
      .def_property_readonly("holes", &holes_of, "Boundaries of the holes, (n, 3), clockwise.");
  bind_plane(module);
  module.def("planes_to_json", &planes_json, py::arg("planes"), py::arg("frame") = "map",
             kPlanesToJson);
}

}  // namespace ribbon_mapper::python
