// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

// Binary little-endian PLY, metres, map frame, colours from plane_colour().

/// Converts planes to a triangle mesh that faces the observed side. Vertices have a normal and a
/// colour, faces the id of their plane. Stripes between scan lines of up to `stripe_gap_m` are
/// closed.
std::string planes_to_ply_mesh(const std::vector<Plane>& planes, double stripe_gap_m);

/// Converts planes to a cloud of the centres of their cells, each with the normal, colour and id of
/// its plane.
std::string planes_to_ply_cloud(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
