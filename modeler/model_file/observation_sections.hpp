// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/model_file/byte_reader.hpp"
#include "modeler/model_file/byte_writer.hpp"
#include "modeler/observations/observations.hpp"

namespace ribbon_mapper {

/// Writes ribbons with their samples.
void write_ribbons(const std::vector<Ribbon>& ribbons, ByteWriter& to);

/// Reads what write_ribbons() has written, of a trajectory of so many poses. The samples go to a
/// store. Throws as ByteReader, and if a number is none that a ribbon can have.
std::vector<Ribbon> read_ribbons(ByteReader& from, std::size_t poses,
                                 PackedStore<PackedSample>& samples);

/// Writes the unassigned points of all lines.
void write_unassigned(const std::vector<UnassignedPoints>& lines, ByteWriter& to);

/// Reads what write_unassigned() has written, of so many lines. The points go to a store. Throws as
/// ByteReader, and if a number is none that unassigned points can have.
std::vector<UnassignedPoints> read_unassigned(ByteReader& from, std::size_t lines,
                                              PackedStore<PackedPoint>& points);

}  // namespace ribbon_mapper
