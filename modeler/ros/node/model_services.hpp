// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ribbon_mapper/GetModel.h>
#include <ribbon_mapper/Save.h>

#include <filesystem>
#include <string>

#include "modeler/ros/node/model_keeper.hpp"

namespace ribbon_mapper {

/// Answers ~get_model.
GetModel::Response model_response(const GetModel::Request& request, ModelKeeper& keeper,
                                  const std::string& map_frame);

/// Answers ~save: the merged planes as files below `directory`.
Save::Response save_response(const std::string& name, ModelKeeper& keeper,
                             const std::filesystem::path& directory);

}  // namespace ribbon_mapper
