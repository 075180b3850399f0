// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/ply.hpp"

#include <array>
#include <cstdint>
#include <cstring>

#include "modeler/io/colour.hpp"

namespace ribbon_mapper {
namespace {

/// Appends the bytes of a number in little-endian order on any machine.
template <typename Number>
void append(std::string& bytes, Number number) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &number, sizeof(Number));
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  bytes.append(raw.rbegin(), raw.rend());
#else
  bytes.append(raw.begin(), raw.end());
#endif
}

void append(std::string& bytes, const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(v[i]));
}

void append(std::string& bytes, const Colour& colour) {
  for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) append(bytes, channel);
}

void append_vertex(std::string& bytes, const Plane& plane, const Eigen::Vector3d& point) {
  append(bytes, point);
  append(bytes, plane.normal);
  append(bytes, plane_colour(plane.id));
}

std::string header(const ModelLabel& label, std::size_t vertices, const std::string& more) {
  return "ply\nformat binary_little_endian 1.0\ncomment ribbon_mapper, " +
         in_one_line(label.frame) + " frame, metres\n" + label_lines(label, "comment ") +
         "element vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\n"
         "property float nx\nproperty float ny\nproperty float nz\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\n" +
         more + "end_header\n";
}

/// Appends the two triangles of a rectangle with four counter-clockwise corners.
void append_faces(std::string& bytes, std::int32_t first_corner, std::int64_t plane_id) {
  for (const auto& triangle : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    append(bytes, std::uint8_t{3});
    for (const int corner : triangle)
      append(bytes, static_cast<std::int32_t>(first_corner + corner));
    append(bytes, static_cast<std::int32_t>(plane_id));
  }
}

void append_corners(std::string& bytes, const Plane& plane, const CellRectangle& r,
                    const Eigen::Vector3d& origin) {
  append_vertex(bytes, plane, grid_corner(plane, r.u_begin, r.v_begin) - origin);
  append_vertex(bytes, plane, grid_corner(plane, r.u_end, r.v_begin) - origin);
  append_vertex(bytes, plane, grid_corner(plane, r.u_end, r.v_end) - origin);
  append_vertex(bytes, plane, grid_corner(plane, r.u_begin, r.v_end) - origin);
}

}  // namespace

std::string planes_to_ply_mesh(const std::vector<Plane>& planes, double stripe_gap_m,
                               const ModelLabel& label) {
  std::string vertices, faces;
  std::int32_t corners = 0;
  for (const Plane& plane : planes) {
    for (const CellRectangle& rectangle : surface_rectangles(plane, stripe_gap_m)) {
      append_corners(vertices, plane, rectangle, label.origin);
      append_faces(faces, corners, plane.id);
      corners += 4;
    }
  }
  const std::string face_header = "element face " + std::to_string(corners / 2) +
                                  "\nproperty list uchar int vertex_indices\n"
                                  "property int plane_id\n";
  return header(label, static_cast<std::size_t>(corners), face_header) + vertices + faces;
}

std::string planes_to_ply_cloud(const std::vector<Plane>& planes, const ModelLabel& label) {
  std::string points;
  std::size_t count = 0;
  for (const Plane& plane : planes) {
    for (const PlaneCell& cell : plane.cells) {
      append_vertex(points, plane, cell_centre(plane, cell) - label.origin);
      append(points, static_cast<std::int32_t>(plane.id));
    }
    count += plane.cells.size();
  }
  return header(label, count, "property int plane_id\n") + points;
}

}  // namespace ribbon_mapper
