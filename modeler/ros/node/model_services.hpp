// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ribbon_mapper/Annotate.h>
#include <ribbon_mapper/GetModel.h>
#include <ribbon_mapper/Load.h>
#include <ribbon_mapper/Save.h>

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/mesh/mesh_file.hpp"
#include "modeler/report/changed_keys.hpp"
#include "modeler/ros/node/model_keeper.hpp"

namespace ribbon_mapper {

/// Returns the answer to ~get_model. A request that cannot be met gets success = false and a
/// reason.
GetModel::Response model_response(const GetModel::Request& request, ModelKeeper& keeper,
                                  const std::string& map_frame);

/// Writes the model and its final planes as files below `directory`, with a page to look at them,
/// and a floor plan, and returns the answer to ~save. `parameters` are for the page. Errors are
/// part of the answer.
Save::Response save_response(const std::string& name, ModelKeeper& keeper,
                             const std::filesystem::path& directory, const std::string& frame,
                             const std::vector<ChangedKey>& parameters,
                             const std::vector<MeshFormat>& mesh_formats);

/// Replaces the model by one that ~save has written below `directory`, and returns the answer to
/// ~load. A model with ribbons is written there first, as kBeforeLoad. Errors are part of the
/// answer; the model then stays as it was.
Load::Response load_response(const std::string& name, ModelKeeper& keeper,
                             const std::filesystem::path& directory, const std::string& frame);

/// Goes on from a model file. Returns a sentence on what was loaded and what differs.
std::string load_into(ModelKeeper& keeper, ModelFile file, const std::filesystem::path& path,
                      const std::string& frame);

/// Annotates a plane and returns the answer to ~annotate. Errors are part of the answer.
Annotate::Response annotate_response(const Annotate::Request& request, ModelKeeper& keeper);

}  // namespace ribbon_mapper
