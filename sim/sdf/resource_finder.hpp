// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ribbon_mapper::sim {

/// Returns the existing file or folder that `uri` refers to, empty if there is none. `model://`,
/// `model:///` and `file://` are removed; a relative path is looked up in `base_folder`, then in
/// `folders`.
std::string find_resource(const std::string& uri, const std::string& base_folder,
                          const std::vector<std::string>& folders);

/// Returns the non-empty parts of a colon-separated list such as GAZEBO_MODEL_PATH.
std::vector<std::string> split_path_list(const std::string& list);

/// Appends the folders of the environment's GAZEBO_MODEL_PATH.
void add_gazebo_paths(std::vector<std::string>& model_paths);

}  // namespace ribbon_mapper::sim
