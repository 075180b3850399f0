// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ribbon_mapper {

/// What a run over a recording says of itself and of its model.
struct OfflineSummary {
  std::vector<std::string> bags;  ///< file names
  std::string config, scan_topic;
  std::string trajectory;  ///< where the poses of the final model are from

  std::size_t lines = 0;                             ///< scans in the bags
  std::map<std::string, std::size_t> dropped_lines;  ///< by reason
  std::map<std::string, std::size_t> handled_lines;  ///< by what the modeler did with them
  std::size_t ribbons = 0;
  std::size_t planes_before = 0, planes = 0;  ///< as built with recorded poses; the final model
  std::size_t duplicates = 0;                 ///< of the final model, see DuplicateRule
  std::size_t points = 0;                     ///< that the planes have taken
  std::optional<double> residual_m_median;    ///< of these points, see median_residual_m()

  double recording_s = 0.0;  ///< from the first line to the last
  double wall_s = 0.0, cpu_s = 0.0;
  double peak_memory_mib = 0.0;
};

std::size_t dropped_total(const OfflineSummary& summary);

/// Seconds of recording per second on the wall, reading and writing included.
double real_time_factor(const OfflineSummary& summary);

std::string summary_to_json(const OfflineSummary& summary);

/// A few lines for a terminal.
std::string summary_text(const OfflineSummary& summary);

}  // namespace ribbon_mapper
