// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/moments.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>

namespace ribbon_mapper {
namespace {

using Symmetric = Eigen::Matrix3d;

Symmetric second_moments(const std::array<double, 10>& s) {
  Symmetric m;
  m << s[4], s[5], s[6], s[5], s[7], s[8], s[6], s[8], s[9];
  return m;
}

/// The upper half of a covariance.
struct Covariance {
  explicit Covariance(const std::array<double, 6>& c)
      : xx(c[0]), xy(c[1]), xz(c[2]), yy(c[3]), yz(c[4]), zz(c[5]) {}

  Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }

  double xx, xy, xz, yy, yz, zz;
};

/// Coefficients of the characteristic polynomial x^3 - trace x^2 + minors x - determinant.
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

/// The smallest root to 1e-5 or better: the cube is left out at first, which is little of it for
/// anything flat, then Newton's method puts it back. None if the root is nearly a double one.
std::optional<double> smallest_root(const Characteristic& p) {
  const double discriminant = p.minors * p.minors - 4.0 * p.trace * p.determinant;
  double x = 2.0 * p.determinant / (p.minors + std::sqrt(std::max(0.0, discriminant)));
  for (int step = 0; step < 4; ++step) {
    const double slope = (3.0 * x - 2.0 * p.trace) * x + p.minors;
    if (!(slope > 0.1 * p.minors)) return std::nullopt;
    const double change = (((x - p.trace) * x + p.minors) * x - p.determinant) / slope;
    x -= change;
    if (std::abs(change) <= 1e-3 * std::abs(x)) return std::max(0.0, x);  // squared by this step
  }
  return std::nullopt;
}

/// The smallest root where it is well apart from the others and these are no double one at 0: not
/// where points lie on one line, on one spot, or are as thick as wide.
std::optional<double> min_variance(const Characteristic& p) {
  if (!(p.minors > 1e-7 * p.trace * p.trace)) return std::nullopt;
  return smallest_root(p);
}

/// Eigenvector of the eigenvalue: a column of the adjugate of c - eigenvalue, the longest.
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

/// From the smallest variance; the axes of the other two are turned within the plane.
PlaneFit completed(const Moments& moments, const Covariance& c, double min_m2) {
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

PlaneFit fit_by_eigen(const Moments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance());
  return {moments.mean(), solver.eigenvalues().cwiseMax(0.0), solver.eigenvectors()};
}

}  // namespace

Moments Moments::of(double weight, const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d m = weight * (covariance + mean * mean.transpose());
  Moments result;
  result.sums_ = {weight,  weight * mean.x(), weight * mean.y(), weight * mean.z(), m(0, 0),
                  m(0, 1), m(0, 2),           m(1, 1),           m(1, 2),           m(2, 2)};
  return result;
}

Eigen::Matrix3d Moments::covariance() const {
  const std::array<double, 6> c = upper_covariance();
  Symmetric m;
  m << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  return m;
}

double Moments::mean_square_distance(const Eigen::Vector3d& normal, double d_m) const {
  const double x = normal.x(), y = normal.y(), z = normal.z();
  const auto& s = sums_;
  const double squares =
      x * (x * s[4] + 2.0 * (y * s[5] + z * s[6])) + y * (y * s[7] + 2.0 * z * s[8]) + z * z * s[9];
  const double square = squares + 2.0 * d_m * (x * s[1] + y * s[2] + z * s[3]) + d_m * d_m * s[0];
  return std::max(0.0, square / s[0]);
}

void Moments::spread(const Eigen::Vector3d& offset) {
  const double x = offset.x(), y = offset.y(), z = offset.z();
  const std::array<double, 6> squares{x * x, x * y, x * z, y * y, y * z, z * z};
  for (std::size_t i = 0; i < 6; ++i) sums_[4 + i] += weight() * squares[i];
}

Moments Moments::transformed(const Pose& T) const {
  const Eigen::Vector3d sum(sums_[1], sums_[2], sums_[3]);
  const Eigen::Matrix3d R = T.linear();
  const Eigen::Vector3d t = T.translation();
  const Eigen::Vector3d rotated = R * sum;
  const Eigen::Matrix3d m = R * second_moments(sums_) * R.transpose() + rotated * t.transpose() +
                            t * (rotated + weight() * t).transpose();
  Moments result;
  const Eigen::Vector3d moved = rotated + weight() * t;
  result.sums_ = {weight(), moved.x(), moved.y(), moved.z(), m(0, 0),
                  m(0, 1),  m(0, 2),   m(1, 1),   m(1, 2),   m(2, 2)};
  return result;
}

PlaneFit fit_plane(const Moments& moments) {
  const Covariance c(moments.upper_covariance());
  if (const auto min_m2 = min_variance(Characteristic(c))) {
    return completed(moments, c, *min_m2);
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
  // The other two variances, the roots of x^2 - sum x + product, are not less than `width_m2`.
  const double width_m2 = flatness.min_width_ratio * *min_m2;
  const double sum = p.trace - *min_m2, product = p.minors - *min_m2 * sum;
  const bool is_wide = 2.0 * width_m2 <= sum && (width_m2 - sum) * width_m2 + product >= 0.0;
  if (*min_m2 > flatness.max_variance_m2 || !is_wide) return std::nullopt;
  return eigenvector(c, *min_m2);
}

}  // namespace ribbon_mapper
