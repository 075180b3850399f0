// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/plane_fit.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace ribbon_mapper {
namespace {

/// The upper half of a covariance matrix.
struct Covariance {
  explicit Covariance(const std::array<double, 6>& c)
      : xx(c[0]), xy(c[1]), xz(c[2]), yy(c[3]), yz(c[4]), zz(c[5]) {}

  Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }

  double xx, xy, xz, yy, yz, zz;
};

/// The coefficients of the characteristic polynomial x^3 - trace x^2 + minors x - determinant.
struct Characteristic {
  explicit Characteristic(const Covariance& c) : trace(c.xx + c.yy + c.zz) {
    const double x = c.yy * c.zz - c.yz * c.yz, y = c.xx * c.zz - c.xz * c.xz,
                 z = c.xx * c.yy - c.xy * c.xy;
    minors = x + y + z;
    determinant =
        c.xx * x + c.xy * (c.xz * c.yz - c.xy * c.zz) + c.xz * (c.xy * c.yz - c.xz * c.yy);
  }

  double trace, minors, determinant;
};

/// Returns the smallest root to a relative error of 1e-5 or better, or nothing if it is nearly a
/// double root. Starts without the cubic term, which is small for flat points, and refines by
/// Newton's method.
std::optional<double> smallest_root(const Characteristic& p) {
  const double discriminant = p.minors * p.minors - 4.0 * p.trace * p.determinant;
  double x = 2.0 * p.determinant / (p.minors + std::sqrt(std::max(0.0, discriminant)));
  for (int step = 0; step < 4; ++step) {
    const double slope = (3.0 * x - 2.0 * p.trace) * x + p.minors;
    if (!(slope > 0.1 * p.minors)) return std::nullopt;
    const double change = (((x - p.trace) * x + p.minors) * x - p.determinant) / slope;
    x -= change;
    if (std::abs(change) <= 1e-3 * std::abs(x)) return std::max(0.0, x);  // converges quadratically
  }
  return std::nullopt;
}

/// Returns the smallest variance if it is well separated from the others. Returns nothing where
/// points lie on one line, on one spot, or are as thick as wide.
std::optional<double> min_variance(const Characteristic& p) {
  if (!(p.minors > 1e-7 * p.trace * p.trace)) return std::nullopt;
  return smallest_root(p);
}

/// Returns the unit eigenvector of the eigenvalue: the longest column of the adjugate of
/// c - eigenvalue.
Eigen::Vector3d eigenvector(const Covariance& c, double eigenvalue) {
  const double x = c.xx - eigenvalue, y = c.yy - eigenvalue, z = c.zz - eigenvalue;
  const Eigen::Vector3d diagonal(y * z - c.yz * c.yz, x * z - c.xz * c.xz, x * y - c.xy * c.xy);
  const double xy = c.xz * c.yz - c.xy * z, xz = c.xy * c.yz - c.xz * y,
               yz = c.xy * c.xz - c.yz * x;
  Eigen::Vector3d column(diagonal.x(), xy, xz);
  if (diagonal.y() > diagonal.x() && diagonal.y() >= diagonal.z()) {
    column = {xy, diagonal.y(), yz};
  } else if (diagonal.z() > diagonal.x()) {
    column = {xz, yz, diagonal.z()};
  }
  return (1.0 / std::sqrt(column.squaredNorm())) * column;
}

/// Returns the fit with this smallest variance. The other two axes follow from the covariance
/// within the plane, in closed form.
PlaneFit complete_fit(const Moments& moments, const Covariance& c, double min_m2) {
  const Eigen::Vector3d normal = eigenvector(c, min_m2);
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  const Eigen::Vector3d c_u = c * u, c_v = c * v;
  const double uu = u.dot(c_u), vv = v.dot(c_v), uv = u.dot(c_v);
  const double half = 0.5 * (uu - vv), length = std::sqrt(half * half + uv * uv);
  Eigen::Vector2d larger =
      half >= 0.0 ? Eigen::Vector2d(half + length, uv) : Eigen::Vector2d(uv, length - half);
  if (length == 0.0) larger = Eigen::Vector2d::UnitX();
  larger.normalize();
  PlaneFit fit{moments.mean(), {}, {}};
  fit.axes << normal, larger.x() * v - larger.y() * u, larger.x() * u + larger.y() * v;
  const double mean = 0.5 * (uu + vv);
  fit.variances = {min_m2, std::max(min_m2, mean - length), mean + length};
  return fit;
}

/// Returns the fit by Eigen's solver, which also handles degenerate points.
PlaneFit fit_by_eigen(const Moments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance());
  return {moments.mean(), solver.eigenvalues().cwiseMax(0.0), solver.eigenvectors()};
}

}  // namespace

PlaneFit fit_plane(const Moments& moments) {
  const Covariance c(moments.upper_covariance());
  if (const auto min_m2 = min_variance(Characteristic(c))) {
    return complete_fit(moments, c, *min_m2);
  }
  return fit_by_eigen(moments);
}

std::optional<Eigen::Vector3d> flat_normal(const Moments& moments, const Flatness& flatness) {
  const Covariance c(moments.upper_covariance());
  const Characteristic p(c);
  const std::optional<double> min_m2 = min_variance(p);
  if (!min_m2) {
    const PlaneFit fit = fit_by_eigen(moments);
    const bool is_flat = fit.variances[0] <= flatness.max_variance_m2 &&
                         fit.variances[1] >= flatness.min_width_ratio * fit.variances[0];
    return is_flat ? std::optional(fit.normal()) : std::nullopt;
  }
  // The other two variances are the roots of x^2 - sum x + product; neither may be below width_m2.
  const double width_m2 = flatness.min_width_ratio * *min_m2;
  const double sum = p.trace - *min_m2, product = p.minors - *min_m2 * sum;
  const bool is_wide = 2.0 * width_m2 <= sum && (width_m2 - sum) * width_m2 + product >= 0.0;
  if (*min_m2 > flatness.max_variance_m2 || !is_wide) return std::nullopt;
  return eigenvector(c, *min_m2);
}

}  // namespace ribbon_mapper
