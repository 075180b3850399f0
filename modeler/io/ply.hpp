// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/io/model_label.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

// Binary little-endian PLY, metres, colours from plane_colour(). Positions are relative to the
// label's origin; the header's comments state frame, run and origin.

/// Converts planes to a triangle mesh that faces the observed side. Vertices have a normal and a
/// colour, faces the id of their plane. Stripes between scan lines of up to `stripe_gap_m` are
/// closed.
std::string planes_to_ply_mesh(const std::vector<Plane>& planes, double stripe_gap_m,
                               const ModelLabel& label = {});

/// Converts planes to a cloud of the centres of their cells, each with the normal, colour and id of
/// its plane.
std::string planes_to_ply_cloud(const std::vector<Plane>& planes, const ModelLabel& label = {});

}  // namespace ribbon_mapper
