// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// The seen cells of a plane in few bytes.
struct PackedCells {
  std::int32_t u_begin = 0;  ///< first column
  std::int32_t v_begin = 0;  ///< first row
  std::int64_t columns = 0;  ///< number of columns
  std::int64_t rows = 0;     ///< number of rows
  /// Cells are numbered row by row. First comes the number of runs of seen cells; then, for each
  /// run, the number of cells since the last one, and of its own. These are in LEB128 (DWARF 5,
  /// section 7.6). Then, for each seen cell, a byte: its mean distance from the plane [mm] plus
  /// 128, from 1 to 255.
  std::string bytes;
};

/// Packs the cells of a plane, which are sorted by (v, u).
PackedCells packed_cells(const Plane& plane);

/// Encodes bytes in base64 (RFC 4648).
std::string base64(const std::string& bytes);

}  // namespace ribbon_mapper
