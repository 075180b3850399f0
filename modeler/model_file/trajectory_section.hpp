// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/model_file/byte_reader.hpp"
#include "modeler/model_file/byte_writer.hpp"
#include "modeler/trajectory/trajectory.hpp"

namespace ribbon_mapper {

/// Writes the poses of all lines, as recorded and as they are now, and the last correction, bit by
/// bit: a later correction is measured from the recorded ones.
void write_trajectory(const Trajectory& trajectory, ByteWriter& to);

/// Reads what write_trajectory() has written. Throws as ByteReader, and if a number is none that a
/// trajectory can have.
Trajectory::Parts read_trajectory(ByteReader& from);

}  // namespace ribbon_mapper
