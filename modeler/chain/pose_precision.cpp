// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/chain/pose_precision.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper {
namespace {

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

PosePrecision precision_of(const std::vector<Matrix6>& covariances) {
  if (covariances.empty()) return {};
  std::vector<double> position_m, heading_deg;
  for (const Matrix6& covariance : covariances) {
    position_m.push_back(std::sqrt(covariance.topLeftCorner<3, 3>().trace()));
    heading_deg.push_back(to_degrees(std::sqrt(covariance(5, 5))));
  }
  PosePrecision precision;
  precision.position_m_median = median_of(position_m);
  precision.position_m_largest = *std::max_element(position_m.begin(), position_m.end());
  precision.heading_deg_median = median_of(heading_deg);
  precision.heading_deg_largest = *std::max_element(heading_deg.begin(), heading_deg.end());
  return precision;
}

std::array<std::pair<const char*, double>, 4> named_sigmas(const PosePrecision& precision) {
  return {{{"position_sigma_m_median", precision.position_m_median},
           {"position_sigma_m_largest", precision.position_m_largest},
           {"heading_sigma_deg_median", precision.heading_deg_median},
           {"heading_sigma_deg_largest", precision.heading_deg_largest}}};
}

}  // namespace ribbon_mapper
