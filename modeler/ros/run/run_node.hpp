// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace ribbon_mapper {

/// What a node says of itself.
struct NodeInfo {
  const char* name;         ///< its name in ROS, unless __name:= gives another
  const char* purpose;      ///< one sentence
  const char* launch_file;  ///< that starts it; its arguments describe the parameters. May be null
};

/// Runs a node and returns its exit code: that of `work`, or 1 after an exception, which is logged.
/// -h, --help and --version are answered without a master, and `work` is not called.
int run_node(int argc, char** argv, const NodeInfo& node, const std::function<int()>& work);

}  // namespace ribbon_mapper
