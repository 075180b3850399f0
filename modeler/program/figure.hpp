// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace ribbon_mapper {

enum class Figure {
  before_after,   ///< the planes of a run, from the files of write_results()
  dose_response,  ///< counts and F1 against drift, from the summary.json of a sweep
  model_views,    ///< a model from above and from the side, from the files of offline_modeler
};

/// Draws <name>.svg and <name>.png from the files in `directory`, with matplotlib in a process of
/// its own. False, and a warning on stderr, if that cannot be done.
bool draw_figure(Figure figure, const std::filesystem::path& directory);

}  // namespace ribbon_mapper
