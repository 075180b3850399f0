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

/// One line of the table: a piece of work by one of the peers, or by us.
struct Row {
  std::string section;
  std::string name;
  std::optional<double> seconds;      ///< CPU time of the whole work; nothing if it did not finish
  std::optional<double> ns_per_item;  ///< per point, beam or ray
  /// Time of this row over ours in the same run: above 1, ours is faster.
  std::optional<double> over_ours;
  std::optional<double> peak_mb;  ///< memory at its peak beyond that of the input [MB]
  std::string accuracy;           ///< for the table; in full in `details`
  nlohmann::json details = nlohmann::json::object();
};

/// All rows of a run, and its ratios by name.
class Report {
 public:
  void add(Row row);
  void set(const std::string& ratio, double value) { summary_[ratio_prefix_ + ratio] = value; }

  /// From now on the names of sections and ratios begin with these: rows of another recording.
  void begin_with(const std::string& section_prefix, const std::string& ratio_prefix);

  /// bench.json and summary.json, each whole or not at all; sections of an earlier run that this
  /// one did not measure stay only if `keep_others`. A section is always of one run.
  void write(const std::filesystem::path& directory, bool keep_others) const;

  std::string summary_text() const;

 private:
  std::string section_prefix_, ratio_prefix_;
  std::vector<Row> rows_;
  std::map<std::string, double> summary_;
};

/// The processor, the compiler and the versions of the peers.
nlohmann::json machine();

}  // namespace ribbon_mapper::bench
