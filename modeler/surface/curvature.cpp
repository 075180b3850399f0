// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/curvature.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ribbon_mapper {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t kMinCells = 12;    // of a surface whose shape is estimated
constexpr std::uint32_t kMinPoints = 4;  // of a well-seen cell

/// Sums for the least-squares fit of the heights
/// h(u, v) = c0 + c1 u + c2 v + (c3 u^2 + 2 c4 u v + c5 v^2) / 2.
///
/// The normal equations contain few different products of powers, each several times.
struct QuadricSums {
  double powers[5][5] = {};   // of u^i v^j, for i + j <= 4
  double heights[3][3] = {};  // of h u^i v^j, for i + j <= 2
  double square = 0.0;        // of h^2

  /// Adds the cells of one row.
  void add_row(const Plane& plane, const PlaneCell* begin, const PlaneCell* end, double u0_m,
               double v_m) {
    double row_powers[5] = {}, row_heights[3] = {};
    for (const PlaneCell* cell = begin; cell != end; ++cell) {
      const double u = u0_m + (cell->u + 0.5) * plane.cell_size_m, height = cell->mean_m;
      const double w = cell->count;  // the mean of few points, often at an edge, is poor
      const double wu = w * u, wuu = wu * u;
      row_powers[0] += w, row_powers[1] += wu, row_powers[2] += wuu;
      row_powers[3] += wuu * u, row_powers[4] += wuu * u * u;
      row_heights[0] += w * height, row_heights[1] += wu * height, row_heights[2] += wuu * height;
      square += w * height * height;
    }
    double v_power = 1.0;
    for (int j = 0; j <= 4; ++j, v_power *= v_m) {
      for (int i = 0; i + j <= 4; ++i) powers[i][j] += row_powers[i] * v_power;
      for (int i = 0; i + j <= 2; ++i) heights[i][j] += row_heights[i] * v_power;
    }
  }

  /// Returns the matrix of the normal equations.
  Matrix6d normal_matrix() const {
    Matrix6d matrix;
    for (int a = 0; a < 6; ++a) {
      for (int b = 0; b < 6; ++b) {
        matrix(a, b) = kFactor[a] * kFactor[b] *
                       powers[kPowerOfU[a] + kPowerOfU[b]][kPowerOfV[a] + kPowerOfV[b]];
      }
    }
    return matrix;
  }
  /// Returns the right side of the normal equations.
  Vector6d right_side() const {
    Vector6d right;
    for (int a = 0; a < 6; ++a) right[a] = kFactor[a] * heights[kPowerOfU[a]][kPowerOfV[a]];
    return right;
  }

 private:
  static constexpr int kPowerOfU[6] = {0, 1, 0, 2, 1, 0}, kPowerOfV[6] = {0, 0, 1, 0, 1, 2};
  static constexpr double kFactor[6] = {1.0, 1.0, 1.0, 0.5, 1.0, 0.5};
};

}  // namespace

Curvature curvature_of(const Plane& plane) {
  if (plane.cells.size() < kMinCells) return {0.0, std::numeric_limits<double>::infinity(), 0.0};
  QuadricSums sums;
  const Eigen::Vector3d from_centroid = plane.origin - plane.centroid;
  const double u0 = from_centroid.dot(plane.axis_u), v0 = from_centroid.dot(plane.axis_v);
  const PlaneCell* const end = plane.cells.data() + plane.cells.size();
  for (const PlaneCell *row = plane.cells.data(), *next = row; row != end; row = next) {
    while (next != end && next->v == row->v) ++next;
    sums.add_row(plane, row, next, u0, v0 + (row->v + 0.5) * plane.cell_size_m);
  }
  const Matrix6d normal_matrix = sums.normal_matrix();
  const Vector6d right_side = sums.right_side();
  const Eigen::LDLT<Matrix6d> solver(normal_matrix);
  const Vector6d c = solver.solve(right_side);
  const double variance = std::max(0.0, sums.square - c.dot(right_side)) /
                          (static_cast<double>(plane.cells.size()) - 6.0);

  // The larger eigenvalue of [c3 c4; c4 c5] and its derivative with respect to (c3, c4, c5).
  const double mean = 0.5 * (c[3] + c[5]), half = 0.5 * (c[3] - c[5]);
  const double radius = std::hypot(half, c[4]);
  const double sign = mean < 0.0 ? -1.0 : 1.0;
  const double direction = 0.5 * std::atan2(c[4], half) + (sign < 0.0 ? M_PI_2 : 0.0);
  const double x = std::cos(direction), y = std::sin(direction);
  Vector6d derivative = Vector6d::Zero();
  derivative.tail<3>() << x * x, 2.0 * x * y, y * y;
  // The second moments are among the sums; a strip of length L has the variance L^2 / 12.
  const double along = 2.0 * (x * x * normal_matrix(0, 3) + y * y * normal_matrix(0, 5)) +
                       2.0 * x * y * normal_matrix(0, 4);
  const double length_square = 12.0 * along / normal_matrix(0, 0);
  const double bend = std::abs(mean + sign * radius);
  return {bend, std::sqrt(variance * derivative.dot(solver.solve(derivative))),
          bend * length_square / 8.0};
}

std::optional<double> cell_scatter_m(const Plane& plane) {
  std::vector<double> distances;
  for (const PlaneCell& cell : plane.cells) {
    if (cell.count >= kMinPoints) distances.push_back(std::abs(cell.mean_m));
  }
  if (distances.size() < kMinCells) return std::nullopt;
  const auto quantile = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 4 / 5);
  std::nth_element(distances.begin(), quantile, distances.end());
  return *quantile;
}

}  // namespace ribbon_mapper
