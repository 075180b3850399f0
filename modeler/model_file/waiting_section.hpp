// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/model_file/byte_reader.hpp"
#include "modeler/model_file/byte_writer.hpp"
#include "modeler/scan/scan_front_end.hpp"

namespace ribbon_mapper {

/// Writes the lines that wait for their neighbours, and what earlier ones have shown.
void write_waiting(const ScanFrontEnd::Parts& parts, ByteWriter& to);

/// Reads what write_waiting() has written. Throws as ByteReader, and if a line is one that the
/// modeler would refuse.
ScanFrontEnd::Parts read_waiting(ByteReader& from);

}  // namespace ribbon_mapper
