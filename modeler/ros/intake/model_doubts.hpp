// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "modeler/modeler.hpp"
#include "modeler/ros/intake/line_log.hpp"

namespace ribbon_mapper {

/// Returns a sentence about a range that stands for no return, without a full stop.
std::string no_return_text(const NoReturnRange& no_return);

/// Returns why lines give no ribbons, in words; empty if any line did. Names the most frequent
/// reason for which lines were dropped or gave nothing, and what to do.
std::string why_no_ribbons(const LineLog& log);

/// Returns why a model has no planes, in words: no lines, no poses, no ribbons, or none that is
/// large enough for `config`. Only to be asked about a model without planes.
std::string why_no_planes(const LineLog& log, const ModelStatistics& statistics,
                          const AssemblyConfig& config);

/// Finds out when the modeler takes lines that give nothing.
class BarrenLines {
 public:
  /// Returns why the lines since the last call gave no ribbons, in words. Returns an empty text if
  /// any did, or if there were only a few.
  std::string complaint(const LineLog& log);

 private:
  std::map<std::string, std::size_t> before_;  ///< lines by outcome, at the last call
};

}  // namespace ribbon_mapper
