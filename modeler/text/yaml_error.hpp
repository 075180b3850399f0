// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/exceptions.h>

#include <string>

namespace ribbon_mapper {

/// Describes why a file cannot be read as YAML, with line and column where they are known.
inline std::string defect_of(const YAML::Exception& error) {
  if (dynamic_cast<const YAML::BadFile*>(&error) != nullptr)
    return "cannot be read: does the file exist?";
  const std::string place = error.mark.is_null()
                                ? ""
                                : "line " + std::to_string(error.mark.line + 1) + ", column " +
                                      std::to_string(error.mark.column + 1) + ": ";
  return place + "no YAML: " + error.msg;
}

}  // namespace ribbon_mapper
