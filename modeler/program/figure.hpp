// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace ribbon_mapper {

/// Figures that the programs can draw.
enum class Figure {
  before_after,   ///< planes of a run before and after its correction, from write_results()
  dose_response,  ///< counts and F1 over drift, from the summary.json of a series
  model_views,    ///< top and side view of a model, from the files of offline_modeler
  level_map,      ///< points and trajectory from above, from the files of offline_slam
  floor_plan,     ///< walls, doors and rooms from above, from floor_plan.geojson
  floor_plan_dxf  ///< the same for CAD: floor_plan.dxf by ezdxf, which needs python3-ezdxf
};

/// Draws <name>.svg and <name>.png, or the DXF, from the files in `directory`, with matplotlib or
/// ezdxf in a separate process. Returns false after a warning on stderr if that fails. The warning
/// has a command that draws them from the files in `later`, where they will be moved to; empty:
/// `directory`.
bool draw_figure(Figure figure, const std::filesystem::path& directory,
                 const std::filesystem::path& later = {});

/// Draws both figures of a floor plan, as draw_figure(). Returns false if one of them fails.
bool draw_floor_plan(const std::filesystem::path& directory,
                     const std::filesystem::path& later = {});

}  // namespace ribbon_mapper
