// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/beam_match.hpp"

#include <algorithm>

namespace ribbon_mapper {

Moments BeamMatch::matched_moments(std::size_t begin, std::size_t end) const {
  const auto within = [this](std::int64_t at) {
    return static_cast<std::size_t>(std::clamp<std::int64_t>(at, 0, size()));
  };
  return to_->moments(within(nearest(begin)), within(nearest(end)));
}

Eigen::Vector3d BeamMatch::direction(std::size_t beam) const {
  if (same_) return to_->directions[beam];
  if (size() < 2) return to_->directions.front();
  const double at = position(beam);
  const auto left = static_cast<std::size_t>(
      std::clamp(std::floor(at), 0.0, static_cast<double>(to_->size() - 2)));
  const double share = at - static_cast<double>(left);
  return (1.0 - share) * to_->directions[left] + share * to_->directions[left + 1];
}

}  // namespace ribbon_mapper
