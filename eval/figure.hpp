// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace ribbon_mapper::eval {

/// Draws before_after.svg and before_after.png from the files that write_results() has left in
/// `directory`, with matplotlib in a process of its own. False, and a warning on stderr, if that
/// cannot be done.
bool draw_figure(const std::filesystem::path& directory);

}  // namespace ribbon_mapper::eval
