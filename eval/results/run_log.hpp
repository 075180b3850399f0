// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "eval/experiment/run_options.hpp"

namespace ribbon_mapper::eval {

/// A finished run as its line in runs.jsonl says it.
struct LoggedRun {
  RunOptions run;
  std::string inputs;   ///< see inputs_of()
  std::string version;  ///< of the program
  std::string line;     ///< with its end
  /// Every number in it by its key, keys of objects joined by dots; absent where it is null.
  std::map<std::string, double> figures;
};

/// Throws std::invalid_argument if that is no such line.
LoggedRun parse_run_line(const std::string& line);

/// runs.jsonl: a line per finished run of a sweep. Runs of a sweep that was interrupted are in it
/// in the order in which they finished; in the end they are sorted.
class RunLog {
 public:
  /// Reads what is there. A last line that was cut off is forgotten. Throws std::runtime_error that
  /// names the file and the line if it holds something else, or runs of another version.
  explicit RunLog(std::filesystem::path path);

  /// True if the run is in the log. Throws std::runtime_error if it was done with other contents of
  /// its world, route or preset.
  bool has(const RunOptions& run, const std::string& inputs) const;

  /// Adds a line, which is on the disk when this returns. Throws std::runtime_error if it cannot be
  /// written.
  void append(const std::string& line);

  /// Writes the file anew, sorted by comes_before(): whole, or not at all.
  void sort() const;

  /// Of these runs, as far as they are in the log, sorted.
  std::vector<LoggedRun> logged_runs(const std::vector<RunOptions>& runs) const;

 private:
  struct Before {
    bool operator()(const RunOptions& a, const RunOptions& b) const { return comes_before(a, b); }
  };
  void enter(const std::string& line, std::size_t number);

  std::filesystem::path path_;
  std::map<RunOptions, LoggedRun, Before> records_;  // by with_portable_names() options
};

}  // namespace ribbon_mapper::eval
