// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/model_file/byte_reader.hpp"
#include "modeler/model_file/byte_writer.hpp"
#include "modeler/modeler_config.hpp"

namespace ribbon_mapper {

/// Writes all keys of a configuration with their values.
void write_config(const ModelerConfig& config, ByteWriter& to);

/// Reads what write_config() has written. Keys that are not in the file keep their defaults; those
/// that this program does not know are left out. Throws as ByteReader, and if a value is out of
/// range.
ModelerConfig read_config(ByteReader& from);

/// Returns a line for each key whose value differs: "KEY was VALUE, is VALUE".
std::vector<std::string> changed_keys(const ModelerConfig& before, const ModelerConfig& now);

}  // namespace ribbon_mapper
