// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace ribbon_mapper::eval {

/// Has a script of eval/figures draw from the files in `directory`, with matplotlib in a process of
/// its own: before_after.py from those of write_results(), model_views.py from those of
/// offline_modeler. False, and a warning on stderr, if that cannot be done.
bool draw_figure(const std::filesystem::path& directory,
                 const std::string& script = "before_after.py");

}  // namespace ribbon_mapper::eval
