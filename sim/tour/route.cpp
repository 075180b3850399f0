// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/route.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "sim/robot/pr2.hpp"
#include "sim/world/world.hpp"

namespace ribbon_mapper::sim {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTurnStep_rad = kPi / 90.0;
constexpr double kDriveStep_m = 0.02;
constexpr double kSteepest = 0.1;  // a PR2 takes the ramps of buildings, up to 1:12 (ADA, 405.2)
constexpr double kOffGround_m =
    0.05;  // where the ground bends, the base is off by some millimetres
constexpr double kSlowest_m_s = 0.001;
constexpr double kSlowest_rad_s = 0.001;
// Far beyond any tour of a PR2, whose batteries last two hours. Within these, a tour needs some
// 300 MB for its noise and for the check against collisions.
constexpr double kLongest_m = 10'000.0;
constexpr double kLongest_s = 4.0 * 3600.0;
constexpr double kFarthest_m = 1e6;
constexpr std::size_t kMostWaypoints = 10'000;

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument("route: " + message);
}

double heading(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

/// Returns the same angle within (-pi, pi].
double wrapped(double angle_rad) { return -std::remainder(-angle_rad, 2.0 * kPi); }

std::string place_text(const Pose& T_map_base) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "at x " << T_map_base.translation().x() << ", y "
       << T_map_base.translation().y() << " m (map)";
  return text.str();
}

/// Throws if there is no ground under the base, or if it is at another height.
void require_ground(const World& world, const Pose& T_map_base) {
  const Eigen::Vector3d above = T_map_base.translation() + Eigen::Vector3d::UnitZ();
  const auto hit = world.cast(above, -Eigen::Vector3d::UnitZ(), 1.0 + kOffGround_m);
  if (hit && hit->range_m >= 1.0 - kOffGround_m) return;
  throw std::runtime_error("the route's height does not fit the ground " + place_text(T_map_base) +
                           "; z of a waypoint is the height of the ground there");
}

std::string collision_text(const Pose& T_map_base, const std::string& shape) {
  return "the route collides with '" + shape + "' " + place_text(T_map_base) +
         "; move a waypoint so that the robot's 0.65 x 0.65 m stay clear";
}

}  // namespace

Ramp::Ramp(double way_, double max_speed, double acceleration_)
    : way(way_),
      speed(std::min(max_speed, std::sqrt(way_ * acceleration_))),
      acceleration(acceleration_),
      ramp_s(speed / acceleration_),
      duration_s(way_ == 0.0 ? 0.0 : way_ / speed + ramp_s) {}

double Ramp::way_at(double time_s) const {
  const double left_s = duration_s - time_s;
  if (left_s <= 0.0) return way;
  if (time_s < ramp_s) return acceleration * time_s * time_s / 2.0;
  if (left_s < ramp_s) return way - acceleration * left_s * left_s / 2.0;
  return speed * (time_s - ramp_s / 2.0);
}

double Ramp::speed_at(double time_s) const {
  const double nearest_rest_s = std::max(0.0, std::min(time_s, duration_s - time_s));
  return std::min(speed, acceleration * nearest_rest_s);
}

Route::Route(double speed_m_s, double turn_rate_rad_s, std::vector<Eigen::Vector2d> waypoints,
             double rest_s, std::vector<double> heights_m)
    : speed_m_s_(speed_m_s),
      turn_rate_rad_s_(turn_rate_rad_s),
      rest_s_(rest_s),
      waypoints_(std::move(waypoints)),
      heights_m_(std::move(heights_m)),
      end_s_(rest_s) {
  require_within_limits();
  lay_ground();
  end_place_ = waypoints_[0];
  end_yaw_rad_ = heading(waypoints_[0], waypoints_[1]);
  const double first_yaw_rad = end_yaw_rad_;
  for (std::size_t i = 1; i < waypoints_.size(); ++i) {
    require(waypoints_[i] != waypoints_[i - 1],
            "waypoints " + std::to_string(i) + " and " + std::to_string(i + 1) + " are the same");
    turn_to(heading(waypoints_[i - 1], waypoints_[i]));
    drive_to(waypoints_[i]);
  }
  if (closed()) turn_to(first_yaw_rad);
  require(length_m_ <= kLongest_m,
          "it is longer than 10 km; shorten it (waypoints are in metres, not millimetres)");
  require(end_s_ <= kLongest_s, "it takes longer than 4 hours; shorten it, or raise its speeds");
}

void Route::require_within_limits() const {
  require(rest_s_ >= 0.0 && rest_s_ <= 1000.0, "rest must be in 0..1000 s");
  require(speed_m_s_ >= kSlowest_m_s && speed_m_s_ <= pr2::kBaseSpeed_m_s,
          "speed must be in 0.001..1 m/s");
  require(turn_rate_rad_s_ >= kSlowest_rad_s && turn_rate_rad_s_ <= pr2::kBaseTurnRate_rad_s,
          "turn_rate must be in 0.001..2 rad/s");
  require(waypoints_.size() >= 2 && waypoints_.size() <= kMostWaypoints,
          "waypoints must be two or more, up to 10000");
  for (const Eigen::Vector2d& waypoint : waypoints_)
    require(waypoint.allFinite() && waypoint.cwiseAbs().maxCoeff() <= kFarthest_m,
            "waypoints must be finite, and within 1000 km of the origin");
  require(heights_m_.empty() || heights_m_.size() == waypoints_.size(),
          "each waypoint needs a height, or none");
  for (const double height_m : heights_m_)
    require(std::abs(height_m) <= kFarthest_m, "heights must be finite, and within 1000 km");
}

void Route::lay_ground() {
  if (heights_m_.empty()) return;
  std::vector<double> ways_m{0.0};
  for (std::size_t i = 1; i < waypoints_.size(); ++i) {
    const double way_m = (waypoints_[i] - waypoints_[i - 1]).norm();
    require(std::abs(heights_m_[i] - heights_m_[i - 1]) <= kSteepest * way_m,
            "the slope to waypoint " + std::to_string(i + 1) + " is above 0.1");
    ways_m.push_back(ways_m.back() + way_m);
  }
  require(!closed() || heights_m_.front() == heights_m_.back(),
          "the first and the last waypoint are the same, but not their heights");
  ground_ = GroundProfile(std::move(ways_m), heights_m_);
}

Route Route::at_speed(double speed_m_s) const {
  const double turn_rate_rad_s = turn_rate_rad_s_ * speed_m_s / speed_m_s_;
  return {speed_m_s, std::min(turn_rate_rad_s, pr2::kBaseTurnRate_rad_s), waypoints_, rest_s_,
          heights_m_};
}

Pose Route::end_pose() const { return planar_pose(end_place_.x(), end_place_.y(), end_yaw_rad_); }

void Route::turn_to(double yaw_rad) {
  const double turn_rad = wrapped(yaw_rad - end_yaw_rad_);
  if (std::abs(turn_rad) < 1e-9) return;
  require(ground_.is_level_at(length_m_),
          "it turns on a slope; turn where the ground is level for 0.23 m ahead and behind");
  legs_.push_back({end_s_, end_pose(), end_yaw_rad_, turn_rad < 0.0 ? -1.0 : 1.0, length_m_,
                   Ramp(std::abs(turn_rad), turn_rate_rad_s_, pr2::kBaseTurnAcceleration_rad_s2)});
  end_s_ += legs_.back().ramp.duration_s;
  end_yaw_rad_ = yaw_rad;
}

void Route::drive_to(const Eigen::Vector2d& target) {
  const double way_m = (target - end_place_).norm();
  legs_.push_back({end_s_, end_pose(), end_yaw_rad_, 0.0, length_m_,
                   Ramp(way_m, speed_m_s_, pr2::kBaseAcceleration_m_s2)});
  end_s_ += legs_.back().ramp.duration_s;
  end_place_ = target;
  length_m_ += way_m;
}

Pose Route::Leg::pose_at(double way) const {
  Pose T_map_base = T_map_start;
  if (turn_sign == 0.0) {
    T_map_base.translation() += way * T_map_start.linear().col(0);
    return T_map_base;
  }
  const double yaw = yaw_rad + turn_sign * way, c = std::cos(yaw), s = std::sin(yaw);
  T_map_base.linear().topLeftCorner<2, 2>() << c, -s, s, c;
  return T_map_base;
}

Pose Route::pose_on_ground(const Leg& leg, double way) const {
  Pose T_map_base = leg.pose_at(way);
  if (is_level()) return T_map_base;
  const double way_m = leg.start_way_m + (leg.turn_sign == 0.0 ? way : 0.0);
  T_map_base = T_map_base * ground_.T_level_base(way_m);
  return T_map_base;
}

Time Route::duration() const { return from_seconds(end_s_); }

const Route::Leg& Route::leg_at(double time_s) const {
  const auto after =
      std::upper_bound(legs_.begin() + 1, legs_.end(), time_s,
                       [](double time, const Leg& leg) { return time < leg.start_s; });
  return *(after - 1);
}

Pose Route::T_map_base(Time time) const {
  const double time_s = std::max(rest_s_, to_seconds(time));
  const Leg& leg = leg_at(time_s);
  return pose_on_ground(leg, leg.ramp.way_at(time_s - leg.start_s));
}

Velocity Route::velocity(Time time) const {
  const double time_s = std::max(rest_s_, to_seconds(time));
  const Leg& leg = leg_at(time_s);
  const double speed = leg.ramp.speed_at(time_s - leg.start_s);
  return leg.turn_sign == 0.0 ? Velocity{speed, 0.0} : Velocity{0.0, leg.turn_sign * speed};
}

std::vector<Pose> Route::poses_to_check() const {
  std::vector<Pose> poses;
  for (const Leg& leg : legs_) {
    const double step = leg.turn_sign == 0.0 ? kDriveStep_m : kTurnStep_rad;
    const int count = static_cast<int>(std::ceil(leg.ramp.way / step));
    for (int i = 0; i <= count; ++i) poses.push_back(pose_on_ground(leg, leg.ramp.way * i / count));
  }
  return poses;
}

void require_free(const World& world, const Route& route) {
  for (const Pose& T_map_base : route.poses_to_check()) {
    if (const auto shape = world.contact(pr2::T_map_body(T_map_base), pr2::kBodySize_m))
      throw std::runtime_error(collision_text(T_map_base, *shape));
    if (!route.is_level()) require_ground(world, T_map_base);
  }
}

}  // namespace ribbon_mapper::sim
