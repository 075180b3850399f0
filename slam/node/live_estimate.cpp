// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/node/live_estimate.hpp"

#include <algorithm>
#include <stdexcept>

#include "modeler/observations/observations.hpp"
#include "modeler/program/stopwatch.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper::slam {
namespace {

EstimateSettings settings_of(const ModelerConfig& config, const EstimateConfig& estimate) {
  EstimateSettings settings = estimate_settings(config);
  settings.estimate = estimate;
  return settings;
}

}  // namespace

LiveEstimate::LiveEstimate(const ModelerConfig& config, const EstimateConfig& estimate,
                           bool with_base_laser)
    : modeler_(config),
      estimate_(modeler_.observations(), settings_of(config, estimate),
                with_base_laser ? &base_laser_ : nullptr) {}

std::string LiveEstimate::add_base_scan(const ReadyLine& scan) {
  try {
    base_laser_.add_scan(scan.beams, scan.poses);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

LineOutcome LiveEstimate::add(const ReadyLine& line) {
  LineOutcome outcome;
  const double line_s =
      wall_seconds_of([&] { outcome.result = modeler_.add_scan_line(line.beams, line.poses); });
  if (outcome.result == LineResult::malformed || outcome.result == LineResult::out_of_order) {
    outcome.defect = find_defect(line.beams, line.poses).value_or("");
    return outcome;
  }
  bool is_window = false;
  const double update_s = wall_seconds_of([&] { is_window = estimate_.update(); });
  outcome.seconds = line_s + update_s;
  if (!R_map_start_ && recorded().size() > 0) R_map_start_ = recorded().T_odom_base()[0].linear();
  if (!is_window) return outcome;
  is_revised_ = true;
  ++windows_;
  window_s_ = update_s;
  longest_window_s_ = std::max(longest_window_s_, update_s);
  return outcome;
}

void LiveEstimate::finish() {
  adjustment_s_ = wall_seconds_of([&] { estimate_.finish(); });
  is_revised_ = true;
}

PoseOfNow LiveEstimate::now() const {
  const StampedPose newest = estimate_.newest_pose();
  Matrix6 to_map = Matrix6::Zero();
  to_map.topLeftCorner<3, 3>() = to_map.bottomRightCorner<3, 3>() = *R_map_start_;
  const Pose T_odom_base = recorded().T_odom_base()[recorded().size() - 1];
  return {newest.stamp, newest.T_map_base, T_odom_base,
          to_map * estimate_.covariance() * to_map.transpose()};
}

Time LiveEstimate::newest() const {
  return recorded().size() > 0 ? recorded().stamps().back() : Time(0);
}

EstimateStatus LiveEstimate::status() const {
  EstimateStatus status;
  status.lines = recorded().size();
  status.is_lost = estimate_.is_lost();
  status.decisions = decisions().size();
  if (!decisions().empty()) status.latest_decision = decisions().back();
  status.noise_scale = estimate_.noise_scale();
  status.windows = windows_;
  status.window_s = window_s_;
  status.longest_window_s = longest_window_s_;
  status.adjustment_s = adjustment_s_;
  status.base_scans = base_laser_.matched();
  return status;
}

}  // namespace ribbon_mapper::slam
