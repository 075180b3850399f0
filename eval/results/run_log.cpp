// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/run_log.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>

#include "eval/results/summary.hpp"
#include "modeler/program/version.hpp"
#include "modeler/storage/atomic_file.hpp"

namespace ribbon_mapper::eval {
namespace {

using Json = nlohmann::json;

template <typename Value>
std::optional<Value> optional_of(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<Value>();
}

RunOptions run_of(const Json& json) {
  RunOptions run;
  run.world = json.at("world").get<std::string>();
  run.route = json.at("route").get<std::string>();
  run.config = json.at("config").get<std::string>();
  run.noise = json.at("noise").get<std::string>();
  run.tilt = json.at("tilt").get<std::string>();
  run.closure = json.value("closure", run.closure);
  run.base_laser = json.value("base_laser", run.base_laser);
  run.caster = json.value("caster", run.caster);
  run.visuals = json.value("visuals", run.visuals);
  run.odometry_faults = json.value("odometry_faults", run.odometry_faults);
  run.beams = optional_of<int>(json.at("beams"));
  run.rate_hz = optional_of<double>(json.at("rate_hz"));
  run.speed_m_s = optional_of<double>(json.at("speed_m_s"));
  run.deskew = optional_of<bool>(json.at("deskew"));
  run.drift = json.at("drift").get<double>();
  run.seed = json.at("seed").get<std::uint64_t>();
  return run;
}

/// Removes the numbers that are conditions of a run, not figures.
void remove_conditions(Json& json) {
  for (const char* key : {"beams", "rate_hz", "speed_m_s", "drift", "seed"}) json.erase(key);
}

void collect(const Json& json, const std::string& prefix, std::map<std::string, double>& figures) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object()) collect(value, prefix + key + ".", figures);
    if (value.is_number()) figures[prefix + key] = value.get<double>();
  }
}

/// Returns the first key, joined by dots, that `expected` has and `json` lacks; else nothing.
std::optional<std::string> first_lacking(const Json& expected, const Json& json) {
  for (const auto& [key, value] : expected.items()) {
    const auto found = json.find(key);
    if (found == json.end()) return key;
    if (!value.is_object() || !found->is_object()) continue;
    if (const auto inner = first_lacking(value, *found)) return key + "." + *inner;
  }
  return std::nullopt;
}

/// Throws std::invalid_argument if a run lacks a key that each run of this program has: it was made
/// by a program of the same commit, before a change that is not committed.
void require_all_keys(const std::string& line) {
  static const Json kEmptyRun = Json::parse(run_line(Summary{}, ""));
  const auto key = first_lacking(kEmptyRun, Json::parse(line));
  if (!key) return;
  throw std::invalid_argument("the run has no '" + *key + "', which this program writes");
}

}  // namespace

LoggedRun parse_run_line(const std::string& line) {
  try {
    Json json = Json::parse(line);
    LoggedRun logged{run_of(json), json.at("inputs"), json.at("version"), line, {}};
    remove_conditions(json);
    collect(json, "", logged.figures);
    return logged;
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("this is no run of the experiment: ") + error.what());
  }
}

RunLog::RunLog(std::filesystem::path path) : path_(std::move(path)) {
  std::ifstream file(path_, std::ios::binary);
  std::string line;
  bool is_cut_off = false;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    is_cut_off = file.eof();  // the last line has no line end
    if (!is_cut_off) enter(line + "\n", number);
  }
  file.close();
  if (is_cut_off) sort();
}

void RunLog::enter(const std::string& line, std::size_t number) {
  const std::string place = path_.string() + ", line " + std::to_string(number) + ": ";
  const std::string advice = "; choose another --output, or move the file away";
  try {
    LoggedRun logged = parse_run_line(line);
    if (logged.version != version()) {
      throw std::invalid_argument("the run is of version " + logged.version +
                                  ", this program of version " + version());
    }
    require_all_keys(line);
    runs_.emplace(logged.run, std::move(logged));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(place + error.what() + advice);
  }
}

bool RunLog::has(const RunOptions& run, const std::string& inputs) const {
  const auto found = runs_.find(with_portable_names(run));
  if (found == runs_.end()) return false;
  if (found->second.inputs == inputs) return true;
  throw std::runtime_error(path_.string() + ": the world, the route or the preset of '" +
                           command_of(run) +
                           "' has changed since it was run; choose another --output, or move the "
                           "file away");
}

void RunLog::append(const std::string& line) {
  LoggedRun logged = parse_run_line(line);
  std::ofstream file(path_, std::ios::binary | std::ios::app);
  file << line << std::flush;
  if (!file) throw std::runtime_error(path_.string() + ": cannot be written; is the disk full?");
  runs_.emplace(logged.run, std::move(logged));
}

void RunLog::sort() const {
  std::string text;
  for (const auto& [run, logged] : runs_) text += logged.line;
  write_file_atomically(path_, text);
}

std::vector<LoggedRun> RunLog::logged_runs(const std::vector<RunOptions>& runs) const {
  std::set<RunOptions, Before> wanted;
  for (const RunOptions& run : runs) wanted.insert(with_portable_names(run));
  std::vector<LoggedRun> result;
  for (const RunOptions& run : wanted) {
    const auto found = runs_.find(run);
    if (found != runs_.end()) result.push_back(found->second);
  }
  return result;
}

}  // namespace ribbon_mapper::eval
