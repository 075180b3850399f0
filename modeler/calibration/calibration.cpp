// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/calibration/calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "modeler/config_keys.hpp"
#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/square.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

// The resolution of odometry: a robot that is slower stands still.
constexpr double kStandingSpeed_m_s = 0.001;
constexpr double kStandingTurn_rad_s = 0.1 * kDegree;
// Travel and rotation are counted in steps, so that the noise of odometry does not add up.
constexpr double kStep_m = 0.1;
constexpr double kStep_rad = 5.0 * kDegree;

// Half a period of the slowest tilt profile in use: 5 s at 40 lines a second.
constexpr std::size_t kMinLines = 200;
constexpr std::size_t kMinRibbons = 100;
constexpr double kMinTravel_m = 1.0;

// The plane ahead is faced within 45 degrees (cosine).
constexpr double kMinFacing = 0.7;

// A ribbon belongs to the plane if it can belong to nothing else: it lies off the plane's edges,
// where normals are biased, and no further away than a drift within a few metres explains.
constexpr double kEdge_m = 0.2;
constexpr double kMaxDistance_m = 0.5;
constexpr double kMaxAngle_rad = 20.0 * kDegree;
constexpr double kBound_sigmas = 3.0;

/// The bounding rectangle of a plane's cells without its edges.
struct Interior {
  explicit Interior(const Plane& plane_) : plane(plane_) {
    for (const PlaneCell& cell : plane.cells) {
      const Eigen::Vector3d centre = cell_centre(plane, cell) - plane.origin;
      lower = lower.cwiseMin(in_plane(centre));
      upper = upper.cwiseMax(in_plane(centre));
    }
  }

  bool contains(const Eigen::Vector3d& point) const {
    const Eigen::Array2d at = in_plane(point - plane.origin);
    return (at > lower + kEdge_m).all() && (at < upper - kEdge_m).all();
  }

  Eigen::Array2d in_plane(const Eigen::Vector3d& offset) const {
    return {offset.dot(plane.axis_u), offset.dot(plane.axis_v)};
  }

  const Plane& plane;
  Eigen::Array2d lower = Eigen::Array2d::Constant(1e9), upper = Eigen::Array2d::Constant(-1e9);
};

/// The largest plane that the robot faces.
Plane plane_ahead(const std::vector<Plane>& planes, const Pose& T_map_base) {
  const Plane* best = nullptr;
  for (const Plane& plane : planes) {
    if (-plane.normal.dot(T_map_base.linear().col(0)) < kMinFacing) continue;
    if (!best || plane.area_m2 > best->area_m2) best = &plane;
  }
  if (best) return *best;
  throw std::runtime_error("calibration: no plane ahead of the robot; let it face a bare wall");
}

/// The variance of a ribbon's points about it.
double point_variance_m2(const Ribbon& ribbon) {
  double squares = 0.0, points = 0.0;
  ribbon.samples.for_each([&](float, float height_m, std::uint32_t count) {
    squares += count * (static_cast<double>(height_m) * height_m + ribbon.samples.variance_m2);
    points += count;
  });
  return points > 0.0 ? squares / points : 0.0;
}

void set_tolerance(RibbonDeviation& result) {
  result.tolerance.angle_deg = kBound_sigmas * std::sqrt(result.angle_variance_rad2) / kDegree;
  result.tolerance.distance_m = kBound_sigmas * std::sqrt(result.distance_variance_m2);
}

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("calibration: " + what);
}

/// Limits every number to the range that its key allows.
struct LimitToRange {
  template <typename Number>
  void operator()(const char*, Number& value, double min, double max) const {
    value = static_cast<Number>(std::clamp(static_cast<double>(value), min, max));
  }
  void operator()(const char*, bool&) const {}
};

std::string table_row(const char* name, const RibbonDeviation& s, const char* paper) {
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(), "%-8s %8zu %14.3g %14.3g %14.3g %11.2f %10.1f   %s\n",
                name, s.ribbons, s.distance_variance_m2, s.angle_variance_rad2,
                s.scalar_product_variance, s.tolerance.angle_deg, 100.0 * s.tolerance.distance_m,
                paper);
  return text.data();
}

}  // namespace

void Calibrator::follow(const LinePoses& poses, double line_s) {
  const Pose& T_odom_first = poses.T_odom_base_first;
  const Pose within = T_odom_first.inverse(Eigen::Isometry) * poses.T_odom_base_last;
  if (!T_odom_base_) T_odom_base_ = T_odom_first;
  const Pose since = T_odom_base_->inverse(Eigen::Isometry) * poses.T_odom_base_last;
  if (since.translation().norm() > kStep_m || angle_of(since) > kStep_rad) {
    T_odom_base_ = poses.T_odom_base_last;
    travel_m_ += since.translation().norm();
    turn_rad_ += angle_of(since);
  }
  const bool moves = within.translation().norm() > kStandingSpeed_m_s * line_s ||
                     angle_of(within) > kStandingTurn_rad_s * line_s;
  if (!moves || has_moved_) return;
  has_moved_ = true;
  ribbons_stopped_ = modeler_.ribbons().size();
  planes_stopped_ = modeler_.planes();
}

void Calibrator::add(const LaserBeams& beams, const LinePoses& poses) {
  if (find_defect(beams, poses)) return;
  follow(poses, to_seconds(end_of(beams) - beams.stamp));
  if (!T_map_standing_) T_map_standing_ = poses.T_map_base;
  LinePoses placed = poses;
  if (!has_moved_) {
    placed.T_map_base = *T_map_standing_;
    ++lines_stopped_;
  }
  modeler_.add_scan_line(beams, placed);
}

bool Calibrator::has_rested() const { return lines_stopped_ >= kMinLines; }

RibbonDeviation Calibrator::deviation(const Plane& plane, std::size_t first_ribbon,
                                      std::size_t end_ribbon) const {
  const Interior interior(plane);
  const std::vector<StampedPose> trajectory = modeler_.trajectory();
  RibbonDeviation result;
  double cosines = 0.0, square_cosines = 0.0;
  for (std::size_t i = first_ribbon; i < end_ribbon; ++i) {
    const Ribbon& ribbon = modeler_.ribbons()[i];
    const Pose& T_map_base = trajectory[ribbon.pose].T_map_base;
    const Eigen::Vector3d centroid = T_map_base * ribbon.moments.mean();
    const Eigen::Vector3d normal = T_map_base.linear() * ribbon.normal.cast<double>();
    const double distance_m = std::abs(plane.normal.dot(centroid) + plane.d_m);
    const double cosine = normal.dot(plane.normal);
    const double angle_rad = std::atan2(normal.cross(plane.normal).norm(), cosine);
    if (distance_m > kMaxDistance_m || angle_rad > kMaxAngle_rad || !interior.contains(centroid))
      continue;
    ++result.ribbons;
    result.distance_variance_m2 += square(distance_m) + point_variance_m2(ribbon);
    result.angle_variance_rad2 += square(angle_rad);
    cosines += cosine;
    square_cosines += square(cosine);
  }
  if (result.ribbons == 0) return result;
  const auto count = static_cast<double>(result.ribbons);
  result.distance_variance_m2 /= count;
  result.angle_variance_rad2 /= count;
  result.scalar_product_variance = std::max(0.0, square_cosines / count - square(cosines / count));
  set_tolerance(result);
  return result;
}

Calibration Calibrator::result() const {
  require(has_moved_, "the robot has not moved yet; drive it 3 to 5 m before the plane");
  require(has_rested(), "the robot stood for " + std::to_string(lines_stopped_) +
                            " lines only; let it stand for " + std::to_string(kMinLines) +
                            " before it moves");
  require(travel_m_ >= kMinTravel_m, "the robot has hardly moved; drive it 3 to 5 m");
  Calibration calibration;
  calibration.plane = plane_ahead(planes_stopped_, modeler_.trajectory().front().T_map_base);
  calibration.stopped = deviation(calibration.plane, 0, ribbons_stopped_);
  calibration.moving = deviation(calibration.plane, ribbons_stopped_, modeler_.ribbons().size());
  calibration.travel_m = travel_m_;
  calibration.turn_deg = turn_rad_ / kDegree;
  for (const RibbonDeviation* s : {&calibration.stopped, &calibration.moving}) {
    require(s->ribbons >= kMinRibbons, "only " + std::to_string(s->ribbons) +
                                           " ribbons on the plane; stay where the laser sees it");
  }
  return calibration;
}

ModelerConfig with_tolerances(ModelerConfig config, const Calibration& calibration) {
  config.association.slam = calibration.moving.tolerance;
  const AssociationGates& sensor = calibration.stopped.tolerance;
  AssociationGates& corrected = config.association.corrected;
  corrected.angle_deg = std::max(corrected.angle_deg, sensor.angle_deg);
  corrected.distance_m = std::max(corrected.distance_m, sensor.distance_m);
  const LimitToRange limit;
  visit_keys(config, limit);
  return config;
}

std::string calibration_table(const Calibration& calibration) {
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(),
                "Plane of %.1f m2, %.2f m from the origin of map; then %.1f m and %.0f degrees of "
                "motion\n\n",
                calibration.plane.area_m2, std::abs(calibration.plane.d_m), calibration.travel_m,
                calibration.turn_deg);
  std::array<char, 200> head;
  std::snprintf(head.data(), head.size(), "%-8s %8s %14s %14s %14s %11s %10s   %s\n", "robot",
                "ribbons", "V distance m2", "V angle rad2", "V scalar prod.", "angle deg",
                "dist. cm", "paper");
  return std::string(text.data()) + head.data() +
         table_row("stopped", calibration.stopped, "0.25 deg, 10 cm") +
         table_row("moving", calibration.moving, "3.2 deg, 25 cm");
}

}  // namespace ribbon_mapper
