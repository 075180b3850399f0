// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

namespace ribbon_mapper {

/// Returns the coefficients of a vector, to loop over. Eigen itself offers that since 3.4.
template <typename Vector>
std::array<double, Vector::SizeAtCompileTime> coefficients_of(const Vector& vector) {
  std::array<double, Vector::SizeAtCompileTime> coefficients;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    coefficients[i] = vector[static_cast<Eigen::Index>(i)];
  }
  return coefficients;
}

}  // namespace ribbon_mapper
