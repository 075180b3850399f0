// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/mesh/plane_mesh.hpp"

#include <GL/glu.h>

#include <deque>
#include <memory>
#include <stdexcept>

namespace ribbon_mapper {
namespace {

using Tessellator = std::unique_ptr<GLUtesselator, void (*)(GLUtesselator*)>;

/// What the callbacks of a tessellator write.
struct Output {
  PlaneMesh& mesh;
  std::vector<std::uint32_t> corners;  // three for each triangle
  std::deque<std::uint32_t> indices;   // of vertices; the tessellator keeps pointers to them
  GLenum error = 0;
};

std::uint32_t* add_vertex(Output& output, const Eigen::Vector3d& vertex) {
  output.indices.push_back(static_cast<std::uint32_t>(output.mesh.vertices.size()));
  output.mesh.vertices.push_back(vertex);
  return &output.indices.back();
}

void GLAPIENTRY take_corner(void* vertex, void* output) {
  static_cast<Output*>(output)->corners.push_back(*static_cast<std::uint32_t*>(vertex));
}

/// Adds a vertex where boundaries touch.
void GLAPIENTRY combine(GLdouble place[3], void* /*vertices*/[4], GLfloat /*weights*/[4],
                        void** vertex, void* output) {
  *vertex = add_vertex(*static_cast<Output*>(output), {place[0], place[1], place[2]});
}

void GLAPIENTRY note_error(GLenum error, void* output) {
  static_cast<Output*>(output)->error = error;
}

/// Makes GLU deliver single triangles rather than fans and strips.
void GLAPIENTRY ignore_edge_flag(GLboolean /*is_edge*/) {}

Tessellator new_tessellator(const Eigen::Vector3d& normal) {
  Tessellator tessellator(gluNewTess(), &gluDeleteTess);
  if (!tessellator) throw std::bad_alloc();
  const auto set = [&](GLenum which, auto callback) {
    gluTessCallback(tessellator.get(), which, reinterpret_cast<_GLUfuncptr>(callback));
  };
  set(GLU_TESS_VERTEX_DATA, &take_corner);
  set(GLU_TESS_COMBINE_DATA, &combine);
  set(GLU_TESS_ERROR_DATA, &note_error);
  set(GLU_TESS_EDGE_FLAG, &ignore_edge_flag);
  gluTessNormal(tessellator.get(), normal.x(), normal.y(), normal.z());
  gluTessProperty(tessellator.get(), GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_POSITIVE);
  return tessellator;
}

void add_contour(GLUtesselator* tessellator, const std::vector<Eigen::Vector3d>& ring,
                 Output& output) {
  gluTessBeginContour(tessellator);
  for (const Eigen::Vector3d& point : ring) {
    GLdouble place[] = {point.x(), point.y(), point.z()};
    gluTessVertex(tessellator, place, add_vertex(output, point));
  }
  gluTessEndContour(tessellator);
}

}  // namespace

PlaneMesh mesh_of(const Plane& plane) {
  PlaneMesh mesh{"plane " + std::to_string(plane.id), plane.id, plane.normal, {}, {}};
  Output output{mesh, {}, {}, 0};
  const Tessellator tessellator = new_tessellator(plane.normal);
  gluTessBeginPolygon(tessellator.get(), &output);
  for (const Outline& outline : plane.outlines) {
    add_contour(tessellator.get(), outline.outer, output);
    for (const auto& hole : outline.holes) add_contour(tessellator.get(), hole, output);
  }
  gluTessEndPolygon(tessellator.get());
  if (output.error != 0) {
    const auto* reason = reinterpret_cast<const char*>(gluErrorString(output.error));
    throw std::runtime_error(mesh.name + " has no triangles: " + reason);
  }
  for (std::size_t i = 0; i + 2 < output.corners.size(); i += 3) {
    mesh.triangles.push_back({output.corners[i], output.corners[i + 1], output.corners[i + 2]});
  }
  return mesh;
}

std::vector<PlaneMesh> meshes_of(const std::vector<Plane>& planes,
                                 const std::vector<std::string>& labels) {
  std::vector<PlaneMesh> meshes;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    meshes.push_back(mesh_of(planes[i]));
    if (i < labels.size()) meshes.back().name += " " + labels[i];
  }
  return meshes;
}

}  // namespace ribbon_mapper
