// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "eval/experiment/run_options.hpp"

namespace ribbon_mapper::eval {

/// A finished run, read from its line in runs.jsonl.
struct LoggedRun {
  RunOptions run;       ///< the conditions
  std::string inputs;   ///< fingerprint of the input files, see inputs_of()
  std::string version;  ///< version of the program that made it
  std::string line;     ///< the line itself, with its line end
  /// All numeric results by key; keys of nested objects are joined by dots. Nulls are left out.
  std::map<std::string, double> figures;
};

/// Parses a line of runs.jsonl. Throws std::invalid_argument if it is none.
LoggedRun parse_run_line(const std::string& line);

/// The file runs.jsonl with one line per finished run of a series. Lines are appended in the order
/// in which runs finish, and sorted at the end of the series.
class RunLog {
 public:
  /// Reads an existing file and drops an incomplete last line. Throws std::runtime_error with file
  /// and line if a line is no run, of another version of the program, or lacks a key of its
  /// results.
  explicit RunLog(std::filesystem::path path);

  /// Returns true if the run is in the log. Throws std::runtime_error if its world, route or preset
  /// has changed since.
  bool has(const RunOptions& run, const std::string& inputs) const;

  /// Appends a line and flushes the file. Throws std::runtime_error if it cannot be written.
  void append(const std::string& line);

  /// Rewrites the file atomically, sorted by comes_before().
  void sort() const;

  /// Returns those of `runs` that are in the log, sorted by comes_before().
  std::vector<LoggedRun> logged_runs(const std::vector<RunOptions>& runs) const;

 private:
  struct Before {
    bool operator()(const RunOptions& a, const RunOptions& b) const { return comes_before(a, b); }
  };
  void enter(const std::string& line, std::size_t number);

  std::filesystem::path path_;
  std::map<RunOptions, LoggedRun, Before> runs_;  // by options with portable names
};

}  // namespace ribbon_mapper::eval
