// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/odometry_faults.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "modeler/text/number_text.hpp"
#include "sim/robot/pr2.hpp"

namespace ribbon_mapper::sim {
namespace {

constexpr double kLatest_s = 4.0 * 3600.0;  // the longest route
constexpr double kDegree_rad = 3.14159265358979323846 / 180.0;

[[noreturn]] void refuse(const std::string& part) {
  throw std::invalid_argument("odometry faults: '" + part.substr(0, 60) +
                              "' is none; use slip=T:DEGREES, shift=T:METRES, push=T:SECONDS, "
                              "scale=X and yaw_scale=X, separated by commas (T in seconds)");
}

/// Returns the number that is all of `text`. `part` is quoted if it is none.
double number(const std::string& text, const std::string& part) {
  const auto value = number_from(text);
  if (!value || !std::isfinite(*value)) refuse(part);
  return *value;
}

void add_event(const std::string& name, const std::string& value, const std::string& part,
               OdometryFaults& faults) {
  const std::size_t colon = value.find(':');
  if (colon == std::string::npos) refuse(part);
  const double start_s = number(value.substr(0, colon), part);
  const double size = number(value.substr(colon + 1), part);
  if (name == "slip") {
    faults.slips.push_back({start_s, 0.0, size * kDegree_rad});
  } else if (name == "shift") {
    faults.slips.push_back({start_s, size, 0.0});
  } else if (name == "push") {
    faults.pushes.push_back({start_s, size});
  } else {
    refuse(part);
  }
}

/// Returns the share of begin..end that lies in the `duration_s` from `start_s` on.
double share_within(double begin_s, double end_s, double start_s, double duration_s) {
  const double both_s = std::min(end_s, start_s + duration_s) - std::max(begin_s, start_s);
  return std::clamp(both_s / (end_s - begin_s), 0.0, 1.0);
}

Pose scaled(Pose step, double scale, double yaw_scale) {
  if (scale != 1.0) step.translation() *= scale;
  if (yaw_scale != 1.0)
    step.rotate(Eigen::AngleAxisd((yaw_scale - 1.0) * yaw_of(step), Eigen::Vector3d::UnitZ()));
  return step;
}

}  // namespace

double OdometryFaults::Slip::duration_s() const {
  return std::max(std::abs(forward_m) / pr2::kBaseSpeed_m_s,
                  std::abs(turn_rad) / pr2::kBaseTurnRate_rad_s);
}

OdometryFaults OdometryFaults::from(const std::string& text) {
  OdometryFaults faults;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) refuse(part);
    const std::string name = part.substr(0, equals), value = part.substr(equals + 1);
    if (name == "scale") {
      faults.scale = number(value, part);
    } else if (name == "yaw_scale") {
      faults.yaw_scale = number(value, part);
    } else {
      add_event(name, value, part, faults);
    }
  }
  faults.validate();
  return faults;
}

void OdometryFaults::validate() const {
  const auto require = [](bool condition, const char* message) {
    if (!condition) throw std::invalid_argument(std::string("odometry faults: ") + message);
  };
  require(scale >= 0.5 && scale <= 1.5, "scale must be in 0.5..1.5");
  require(yaw_scale >= 0.5 && yaw_scale <= 1.5, "yaw_scale must be in 0.5..1.5");
  for (const Slip& slip : slips) {
    require(slip.start_s >= 0.0 && slip.start_s <= kLatest_s, "a slip must start in 0..14400 s");
    require(std::abs(slip.turn_rad) <= 360.0 * kDegree_rad, "a slip must be in -360..360 degrees");
    require(std::abs(slip.forward_m) <= 10.0, "a shift must be in -10..10 m");
    require(slip.duration_s() > 0.0, "a slip or a shift must not be 0");
  }
  for (const Push& push : pushes) {
    require(push.start_s >= 0.0 && push.start_s <= kLatest_s, "a push must start in 0..14400 s");
    require(push.duration_s > 0.0 && push.duration_s <= 1000.0, "a push must last 0..1000 s");
  }
}

Pose OdometryFaults::reported(const Pose& step, double begin_s, double end_s) const {
  double seen_share = 1.0;
  for (const Push& push : pushes)
    seen_share =
        std::min(seen_share, 1.0 - share_within(begin_s, end_s, push.start_s, push.duration_s));
  Pose seen = scaled(seen_share == 1.0 ? step : interpolate(Pose::Identity(), step, seen_share),
                     scale, yaw_scale);
  for (const Slip& slip : slips) {
    const double within = share_within(begin_s, end_s, slip.start_s, slip.duration_s());
    const double part = within * (end_s - begin_s) / slip.duration_s();
    if (part > 0.0) seen = seen * planar_pose(part * slip.forward_m, 0.0, part * slip.turn_rad);
  }
  return seen;
}

}  // namespace ribbon_mapper::sim
