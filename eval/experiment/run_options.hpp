// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ribbon_mapper::eval {

/// Conditions of one run of the experiment: everything that its result depends on.
struct RunOptions {
  std::string world = "worlds/apartment.sdf";  ///< SDF file
  std::string route;                           ///< file; if empty, <world>.route.yaml
  std::string config = "config/pr2.yaml";      ///< preset of the modeler
  std::vector<std::string> model_paths;        ///< folders for model:// URIs
  bool visuals = false;    ///< takes models without collision from their visuals
  std::uint64_t seed = 1;  ///< seed of all noise
  /// Scale of the localisation noise, 1 for gmapping's. 3 reproduces the 110 planes of the paper.
  double drift = 3.0;
  std::string odometry_faults;      ///< slips and pushes, see sim::OdometryFaults::from()
  std::string noise = "datasheet";  ///< name of the range noise, see sim::range_noise_from()
  std::string tilt = "manip";       ///< name of a sim::TiltProfileConfig::preset()
  std::string closure = "truth";    ///< what corrects the trajectory: truth, or the slam itself
  bool base_laser = false;          ///< `self` uses the laser on the base, too
  std::string caster = "bullet";    ///< name of a ray caster, see sim::ray_caster_kind_from()
  std::optional<int> beams;         ///< number, 0.25 degrees apart; if empty, the PR2's
  std::optional<double> rate_hz;    ///< scans per second; if empty, the PR2's
  std::optional<double> speed_m_s;  ///< scales the turn rate alike; if empty, the route's
  std::optional<bool> deskew;       ///< if empty, as in the preset
};

/// Returns the path of the route file.
std::filesystem::path route_path(const RunOptions& run);

/// Returns the command that repeats the run.
std::string command_of(const RunOptions& run);

/// Returns the options with files named by portable_name() and without model paths, as they are
/// logged.
RunOptions with_portable_names(const RunOptions& run);

/// Defines the order of runs in the files of a series: by conditions, then by seed.
bool comes_before(const RunOptions& a, const RunOptions& b);

/// Returns the options in which `run` differs from others of its series, and the seed, such as
/// "drift 0.5, seed 3".
std::string label_of(const RunOptions& run, const std::vector<RunOptions>& among);

/// Returns true if the two differ at most in their seeds.
bool is_repetition(const RunOptions& a, const RunOptions& b);

/// Returns a fingerprint of the contents of world, route and preset. Throws std::runtime_error that
/// names a file that cannot be read.
std::string inputs_of(const RunOptions& run);

}  // namespace ribbon_mapper::eval
