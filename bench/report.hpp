// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ribbon_mapper::bench {

/// A row of the table: work done by a peer or by us.
struct Row {
  std::string section;                ///< heading
  std::string name;                   ///< name of the peer or variant
  std::optional<double> seconds;      ///< CPU time; empty if the work was stopped
  std::optional<double> ns_per_item;  ///< CPU time per point, beam or ray
  /// Ratio to our time in the same run; above 1, we are faster.
  std::optional<double> over_ours;
  std::optional<double> peak_mb;  ///< peak of memory beyond that of the input
  std::string accuracy;           ///< text for the table; `details` has the numbers
  nlohmann::json details = nlohmann::json::object();  ///< numbers for bench.json
};

/// Rows and named ratios of a benchmark run.
class Report {
 public:
  /// Prints a row and keeps it.
  void add(Row row);

  /// Sets a ratio.
  void set(const std::string& ratio, double value) { summary_[ratio_prefix_ + ratio] = value; }

  /// Sets prefixes for the names of subsequent sections and ratios, for example of a bag.
  void begin_with(const std::string& section_prefix, const std::string& ratio_prefix);

  /// Writes bench.json and summary.json atomically. Sections of an earlier run that were not
  /// measured now are kept if `keep_others` is true, otherwise removed.
  void write(const std::filesystem::path& directory, bool keep_others) const;

  /// Formats the ratios for the terminal.
  std::string summary_text() const;

 private:
  std::string section_prefix_, ratio_prefix_;
  std::vector<Row> rows_;
  std::map<std::string, double> summary_;
};

/// Describes the processor, the compiler and the versions of the peers.
nlohmann::json machine();

}  // namespace ribbon_mapper::bench
