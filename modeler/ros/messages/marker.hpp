// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "modeler/io/colour.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Returns an empty marker of a type such as Marker::LINE_LIST. Its pose is the identity.
visualization_msgs::Marker new_marker(std::int32_t type, const std_msgs::Header& header,
                                      const std::string& ns, std::int64_t id);

/// Returns a colour with each channel multiplied by `shade`.
std_msgs::ColorRGBA colour_message(const Colour& colour, double shade = 1.0, double alpha = 1.0);

/// Returns a colour as it looks on a plane with this normal: brighter the more it faces up or one
/// diagonal, both sides alike. rviz applies no light of its own to triangles with colours.
std_msgs::ColorRGBA shaded(const Colour& colour, const Eigen::Vector3d& normal);

/// Appends a line to a LINE_LIST.
void add_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
              visualization_msgs::Marker& marker);

/// Appends the sides of outlines to a LINE_LIST, moved by `shift`.
void add_sides(const std::vector<Outline>& outlines, const Eigen::Vector3d& shift,
               visualization_msgs::Marker& marker);

}  // namespace ribbon_mapper
