// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

// Binary little-endian PLY in the map frame, metres; colours by plane_colour(id).

/// The surfaces of the planes as triangles, their front towards the seen side. Vertices have a
/// normal and a colour, faces the id of their plane.
/// Stripes between scan lines of up to `stripe_gap_m` are closed.
std::string planes_to_ply_mesh(const std::vector<Plane>& planes, double stripe_gap_m);

/// The centres of the seen cells, each with the normal, the colour and the id of its plane.
std::string planes_to_ply_cloud(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
