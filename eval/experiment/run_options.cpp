// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/run_options.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "modeler/program/installed_files.hpp"

namespace ribbon_mapper::eval {
namespace {

std::string text_of(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string text_of(const std::optional<bool>& value) {
  return value ? (*value ? "on" : "off") : "";
}

template <typename Value>
std::string text_of(const std::optional<Value>& value) {
  return value ? text_of(static_cast<double>(*value)) : "";
}

std::string quoted(const std::string& text) {
  return text.find_first_of(" \t'\"$&;()*?") == std::string::npos ? text : "'" + text + "'";
}

/// Returns everything but the seed, in the order of comes_before().
auto conditions_of(const RunOptions& r) {
  return std::tie(r.world, r.route, r.config, r.model_paths, r.visuals, r.noise, r.tilt, r.closure,
                  r.base_laser, r.caster, r.beams, r.rate_hz, r.speed_m_s, r.deskew, r.drift,
                  r.odometry_faults);
}

/// Name and value of an option on the command line.
using Option = std::array<std::string, 2>;

/// Returns the options that may differ within a series.
std::vector<Option> varied_options(const RunOptions& r) {
  return {{"world", r.world},
          {"config", r.config},
          {"noise", r.noise},
          {"tilt", r.tilt},
          {"closure", r.closure + (r.base_laser ? " with base laser" : "")},
          {"caster", r.caster},
          {"beams", text_of(r.beams)},
          {"rate", text_of(r.rate_hz)},
          {"speed", text_of(r.speed_m_s)},
          {"deskew", text_of(r.deskew)},
          {"drift", text_of(r.drift)},
          {"odometry-faults", r.odometry_faults}};
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path.string() + ": cannot be read: does the file exist?");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::filesystem::path route_path(const RunOptions& run) {
  if (!run.route.empty()) return find_installed_file(run.route);
  return find_installed_file(run.world).replace_extension(".route.yaml");
}

std::string command_of(const RunOptions& run) {
  const RunOptions defaults;
  std::ostringstream command;
  command << "rosrun ribbon_mapper experiment --world "
          << quoted(portable_name(run.world).string());
  const auto add = [&](const char* name, const std::string& value, const std::string& unless) {
    if (value != unless) command << " " << name << " " << quoted(value);
  };
  add("--route", run.route, defaults.route);
  command << " --seed " << run.seed << " --drift " << run.drift;
  add("--odometry-faults", run.odometry_faults, "");
  add("--config", run.config, defaults.config);
  add("--noise", run.noise, defaults.noise);
  add("--tilt", run.tilt, defaults.tilt);
  add("--closure", run.closure, defaults.closure);
  add("--caster", run.caster, defaults.caster);
  add("--beams", text_of(run.beams), "");
  add("--rate", text_of(run.rate_hz), "");
  add("--speed", text_of(run.speed_m_s), "");
  add("--deskew", text_of(run.deskew), "");
  if (run.base_laser) command << " --base-laser";
  if (run.visuals) command << " --visuals";
  for (const std::string& path : run.model_paths) command << " --model-path " << quoted(path);
  return command.str();
}

RunOptions with_portable_names(const RunOptions& run) {
  RunOptions named = run;
  named.world = portable_name(find_installed_file(run.world)).string();
  named.route = portable_name(route_path(run)).string();
  named.config = portable_name(find_installed_file(run.config)).string();
  named.model_paths.clear();  // differ between machines
  return named;
}

bool comes_before(const RunOptions& a, const RunOptions& b) {
  return std::tuple_cat(conditions_of(a), std::tie(a.seed)) <
         std::tuple_cat(conditions_of(b), std::tie(b.seed));
}

bool is_repetition(const RunOptions& a, const RunOptions& b) {
  return conditions_of(a) == conditions_of(b);
}

std::string label_of(const RunOptions& run, const std::vector<RunOptions>& among) {
  const std::vector<Option> own = varied_options(run);
  std::string label;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool is_common = std::all_of(among.begin(), among.end(), [&](const RunOptions& other) {
      return varied_options(other)[i] == own[i];
    });
    if (!is_common) label += own[i][0] + " " + own[i][1] + ", ";
  }
  return label + "seed " + std::to_string(run.seed);
}

// FNV-1a gives the same hash on all machines.
std::string inputs_of(const RunOptions& run) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const auto& path :
       {find_installed_file(run.world), route_path(run), find_installed_file(run.config)}) {
    for (const char byte : content_of(path) + '\0') {
      hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    }
  }
  std::array<char, 20> text;
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace ribbon_mapper::eval
