// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "bench/recording/recording.hpp"

namespace ribbon_mapper::bench {

/// Writes a recording to a cache file in the machine's byte order, which is not for exchange.
void write_recording(const Recording& recording, const std::filesystem::path& file);

/// Reads a cache file. Returns nothing if it does not exist, is incomplete or of another version.
std::optional<Recording> read_recording(const std::filesystem::path& file);

}  // namespace ribbon_mapper::bench
