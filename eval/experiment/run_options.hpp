// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ribbon_mapper::eval {

/// One run of the experiment: all that its result depends on.
struct RunOptions {
  std::string world = "worlds/apartment.sdf";
  std::string route;  ///< empty: beside the world, <name>.route.yaml
  std::string config = "config/pr2.yaml";
  std::vector<std::string> model_paths;
  std::uint64_t seed = 1;  ///< of all noise
  double drift = 3.0;      ///< where the paper's 110 planes come from
  std::string noise = "datasheet";
  std::string tilt = "manip";
  std::string caster = "bullet";  ///< library that casts the rays, see sim::RayCasterKind
  // Nothing: as the PR2, the route and the preset have it.
  std::optional<int> beams;         ///< a quarter of a degree apart
  std::optional<double> speed_m_s;  ///< the route's turn rate is scaled alike
  std::optional<bool> deskew;
};

/// Where the route of these options is.
std::filesystem::path route_path(const RunOptions& run);

/// The command that makes the run again.
std::string command_of(const RunOptions& run);

/// As it is written down: files by names that other machines can follow.
RunOptions recorded(const RunOptions& run);

/// The order of runs in a sweep's files: by world and the other options, the seed last.
bool comes_before(const RunOptions& a, const RunOptions& b);

/// What differs between runs of a sweep, and their seed, such as "drift 0.5, seed 3".
std::string label_of(const RunOptions& run, const std::vector<RunOptions>& among);

/// True if the two differ in nothing but their seeds.
bool is_repetition(const RunOptions& a, const RunOptions& b);

/// A fingerprint of the contents of the world's file, the route and the preset, which may change
/// under their names. Throws std::runtime_error naming a file that cannot be read.
std::string inputs_of(const RunOptions& run);

}  // namespace ribbon_mapper::eval
