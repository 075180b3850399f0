// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "bench/recording/recording.hpp"

namespace ribbon_mapper::bench {

/// A cache, in the byte order of the machine that wrote it: not for exchange.
void write_recording(const Recording& recording, const std::filesystem::path& file);

/// Nothing if there is no such file, or if it is of another version or cut off.
std::optional<Recording> read_recording(const std::filesystem::path& file);

}  // namespace ribbon_mapper::bench
