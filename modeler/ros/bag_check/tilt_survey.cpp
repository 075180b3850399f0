// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/tilt_survey.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "modeler/ros/bag_check/number_text.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kStill_rad = 0.01, kStill_m = 0.05;
constexpr double kMinStep_rad = 1e-5;  // smaller turns are standstill
constexpr double kTurnedRound_rad = 1.9 * M_PI;

/// Returns the indices where the angle reverses by more than a tenth of its whole range.
std::vector<std::size_t> reversals(const std::vector<double>& angles, double range_rad) {
  std::vector<std::size_t> found;
  std::size_t extreme = 0;
  int heading = 0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double from_extreme = angles[i] - angles[extreme];
    if (heading == 0 ? from_extreme == 0.0 : heading * from_extreme >= 0.0) {
      extreme = i;
      continue;
    }
    if (std::abs(from_extreme) < 0.1 * range_rad) continue;
    if (heading != 0) found.push_back(extreme);
    heading = from_extreme > 0.0 ? 1 : -1;
    extreme = i;
  }
  return found;
}

}  // namespace

void TiltSurvey::add(const LaserBeams& beams, const LinePoses& poses) {
  if (stamps_.empty()) {
    first_T_odom_base_ = poses.T_odom_base_first;
  } else {
    const Eigen::AngleAxisd turn(poses.T_base_laser_first.linear() *
                                 last_T_base_laser_.linear().transpose());
    turns_rad_.push_back(turn.angle() * turn.axis());
    sum_of_squares_ += turns_rad_.back() * turns_rad_.back().transpose();
  }
  stamps_.push_back(beams.stamp);
  last_T_base_laser_ = poses.T_base_laser_first;
  const Pose moved = first_T_odom_base_.inverse(Eigen::Isometry) * poses.T_odom_base_first;
  base_travel_m_ = std::max(base_travel_m_, moved.translation().norm());
  base_turn_rad_ = std::max(base_turn_rad_, angle_of(moved));
}

std::vector<double> TiltSurvey::angles_rad() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum_of_squares_);
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  std::vector<double> angles{0.0};
  for (const Eigen::Vector3d& turn : turns_rad_) angles.push_back(angles.back() + axis.dot(turn));
  return angles;
}

void TiltSurvey::report(const ScanSurvey& scans, const ModelerConfig& preset,
                        BagReport& report) const {
  if (stamps_.size() < 2) return;
  report_tilt(report);
  report_spacing(spacing(scans), preset, report);
}

void TiltSurvey::report_tilt(BagReport& report) const {
  const std::vector<double> angles = angles_rad();
  const auto [lowest, highest] = std::minmax_element(angles.begin(), angles.end());
  const double range_rad = *highest - *lowest;
  const double duration_s = to_seconds(stamps_.back() - stamps_.front());
  if (range_rad < kStill_rad) {
    if (base_travel_m_ < kStill_m && base_turn_rad_ < kStill_rad) {
      report.fault(
          "the tilt does not move, nor does the robot: only a single line is seen. Is the "
          "tilt's joint in tf, and was it commanded?");
    } else {
      report.warning(
          "the tilt does not move: surfaces are seen only where the robot's own motion "
          "carries the line over them");
    }
    return;
  }
  if (range_rad > kTurnedRound_rad) {
    report.fact("the laser turns, " + degrees(range_rad) + " degrees in " + number(duration_s, 1) +
                " s");
    return;
  }
  const std::vector<std::size_t> turns = reversals(angles, range_rad);
  std::string text = "the tilt moves by +-" + degrees(0.5 * range_rad) + " degrees";
  if (turns.size() >= 3) {
    std::vector<double> periods_s;
    for (std::size_t i = 2; i < turns.size(); ++i)
      periods_s.push_back(to_seconds(stamps_[turns[i]] - stamps_[turns[i - 2]]));
    text += ", period " + number(median_of(periods_s), 2) + " s";
  } else {
    text += ", without a full period";
  }
  report.fact(text);
}

LineSpacing TiltSurvey::spacing(const ScanSurvey& scans) const {
  std::vector<double> steps_rad;
  for (const Eigen::Vector3d& turn : turns_rad_) {
    if (turn.norm() > kMinStep_rad) steps_rad.push_back(turn.norm());
  }
  const std::vector<double> angles = angles_rad();
  const auto [lowest, highest] = std::minmax_element(angles.begin(), angles.end());
  const double range_rad = *highest - *lowest;
  LineSpacing spacing;
  spacing.line_step_rad = median_of(steps_rad);
  spacing.beam_step_rad = scans.beam_step_rad();
  spacing.sweeps =
      std::max(range_rad / M_PI, 1.0 + static_cast<double>(reversals(angles, range_rad).size()));
  spacing.noise_m = scans.noise_m();
  spacing.median_range_m = scans.range_m(0.5);
  spacing.far_range_m = scans.range_m(0.9);
  spacing.base_stands = base_travel_m_ < kStill_m && base_turn_rad_ < kStill_rad;
  return spacing;
}

}  // namespace ribbon_mapper
