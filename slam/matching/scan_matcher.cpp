// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/matching/scan_matcher.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper::slam {
namespace {

struct Residual {
  double r_m = 0.0;
  double dx = 0.0, dy = 0.0, dyaw = 0.0;  // derivatives
  double dyaw_across = 0.0;               // of a surface at a right angle; the others are -dy, dx
};

constexpr int kCoarseSteps = 4;  // then steps are fine

double scatter_of(const std::vector<Residual>& residuals, double least_m,
                  const MatchConfig& config) {
  if (residuals.empty()) return config.most_scatter_m;
  std::vector<double> sizes;
  sizes.reserve(residuals.size());
  for (const Residual& residual : residuals) sizes.push_back(std::abs(residual.r_m));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return std::clamp(2.0 * 1.4826 * *middle, least_m, config.most_scatter_m);
}

/// Returns the share of a prior that holds, given how far a pose is from it.
double prior_share(double chi2) { return 1.0 / square(1.0 + chi2 / 9.0); }

}  // namespace

MatchStage stage_of(int step, const MatchConfig& config) {
  const double late = std::min(1.0, static_cast<double>(step) / kCoarseSteps);
  const auto between = [&](double first, double last) { return first + late * (last - first); };
  return {between(config.first_width_m, config.last_width_m),
          between(config.first_gate_m, config.last_gate_m),
          between(config.most_scatter_m, config.least_scatter_m), between(config.first_prior, 1.0)};
}

Misfit misfit_at(const LevelPoints& points, const SurfaceMap& map, const PlanarPose& T_map_base,
                 const MatchStage& stage, const MatchConfig& config) {
  const double c = std::cos(T_map_base.yaw_rad), s = std::sin(T_map_base.yaw_rad);
  std::vector<Residual> residuals;
  residuals.reserve(points.size());
  Misfit misfit;
  for (const LevelPoint& point : points) {
    if (point.normal_x == 0.0F && point.normal_y == 0.0F) continue;
    ++misfit.points;
    const LevelPoint p = moved(point, T_map_base, c, s);
    const auto t = map.near(p, stage.width_m, stage.gate_m);
    if (!t) continue;
    const double x = p.x_m - T_map_base.x_m, y = p.y_m - T_map_base.y_m;
    residuals.push_back({t->distance_m, t->normal_x, t->normal_y, t->normal_y * x - t->normal_x * y,
                         t->normal_x * x + t->normal_y * y});
  }
  misfit.scatter_m = scatter_of(residuals, stage.least_scatter_m, config);
  double cost = static_cast<double>(misfit.points) - static_cast<double>(residuals.size());
  for (const Residual& r : residuals) {
    const double ratio = square(r.r_m / misfit.scatter_m);
    const double weight = 1.0 / square(1.0 + ratio);
    const Eigen::Vector3d J(r.dx, r.dy, r.dyaw);
    const Eigen::Vector3d across(-r.dy, r.dx, r.dyaw_across);
    misfit.hessian += weight * J * J.transpose();
    misfit.across += weight * across * across.transpose();
    misfit.gradient += weight * r.r_m * J;
    const double fixed = square(r.r_m / config.agreeing_m);
    cost += fixed / (1.0 + fixed);
    if (std::abs(r.r_m) < config.agreeing_m) misfit.agreeing += 1.0;
  }
  const double all = std::max(1, misfit.points);
  misfit.agreeing /= all, misfit.cost = misfit.points == 0 ? 1.0 : cost / all;
  return misfit;
}

Match match(const LevelPoints& points, const SurfaceMap& map, const PlanarPose& guess,
            const std::optional<PosePrior>& prior, const MatchConfig& config) {
  Match result;
  PlanarPose pose = guess;
  for (int step = 0; step < config.max_steps; ++step) {
    const MatchStage stage = stage_of(step, config);
    const Misfit misfit = misfit_at(points, map, pose, stage, config);
    // variance of one residual: points within the scatter, which is twice their deviation
    const double scale = 1.0 / (config.correlated * square(0.5 * misfit.scatter_m));
    result = {pose,        misfit.hessian * scale, Eigen::Matrix3d::Zero(), misfit.agreeing,
              misfit.cost, misfit.points,          misfit.across * scale};
    Eigen::Matrix3d H = result.information;
    Eigen::Vector3d g = misfit.gradient * scale;
    if (prior) {
      Eigen::Vector3d off = pose.vector() - prior->T_map_base.vector();
      off.z() = wrapped(off.z());
      const double share = stage.prior_share * prior_share(off.dot(prior->information * off));
      result.prior_information = share * prior->information;
      H += result.prior_information, g += result.prior_information * off;
    }
    H.diagonal() += Eigen::Vector3d(1e-3, 1e-3, 1e-3);
    const Eigen::Vector3d delta = H.ldlt().solve(-g);
    const double limit = std::min(1.0, 0.3 / std::max(1e-9, delta.head<2>().norm()));
    pose = planar(pose.vector() + limit * delta);
    const bool is_still = delta.head<2>().norm() < 2e-4 && std::abs(delta.z()) < 1e-4;
    if (step >= kCoarseSteps && is_still) break;
  }
  result.T_map_base = pose;
  return result;
}

Eigen::Matrix3d information_beyond_normals(const Match& match, const MatchConfig& config) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      match.information - 2.0 * square(config.normal_sigma_rad) * match.information_across);
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace ribbon_mapper::slam
