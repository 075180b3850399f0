// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/segmentation/overlaps.hpp"

namespace ribbon_mapper::eval {
namespace {

double ratio(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

Overlaps::Overlaps(std::size_t truth, std::size_t estimates)
    : shared_(truth * estimates), truth_points_(truth), estimated_points_(estimates) {}

void Overlaps::add(int truth, int estimate, std::size_t points) {
  const auto t = static_cast<std::size_t>(truth), e = static_cast<std::size_t>(estimate);
  if (truth != kNoRegion) truth_points_[t] += points;
  if (estimate != kNoRegion) estimated_points_[e] += points;
  if (truth != kNoRegion && estimate != kNoRegion) shared_[t * estimates() + e] += points;
}

double Overlaps::share_of_truth(std::size_t truth, std::size_t estimate) const {
  return ratio(shared(truth, estimate), truth_points_[truth]);
}

double Overlaps::share_of_estimate(std::size_t truth, std::size_t estimate) const {
  return ratio(shared(truth, estimate), estimated_points_[estimate]);
}

double Overlaps::iou(std::size_t truth, std::size_t estimate) const {
  const std::size_t both = shared(truth, estimate);
  return ratio(both, truth_points_[truth] + estimated_points_[estimate] - both);
}

}  // namespace ribbon_mapper::eval
