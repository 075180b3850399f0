// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ribbon_mapper::sim {

/// Existing file or folder that `uri` means: an absolute path, or one below `base_folder` or one of
/// `folders`, with `model://` and `file://` taken off; empty if there is none.
std::string find_resource(const std::string& uri, const std::string& base_folder,
                          const std::vector<std::string>& folders);

/// The parts of a colon-separated list such as GAZEBO_MODEL_PATH, empty parts left out.
std::vector<std::string> split_path_list(const std::string& list);

}  // namespace ribbon_mapper::sim
