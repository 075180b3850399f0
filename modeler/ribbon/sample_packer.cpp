// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/sample_packer.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {

void SamplePacker::add(double along_m, double height_m, double square_m2, std::size_t count) {
  constexpr std::size_t max = RibbonSamples::kMaxCount;
  for (; count > max; count -= max) samples_.push_back({along_m, height_m, square_m2, max});
  samples_.push_back({along_m, height_m, square_m2, count});
}

RibbonSamples SamplePacker::pack() {
  RibbonSamples result;
  packed_.clear();
  double max_height_m = 0.0, squares = 0.0, points = 0.0;
  for (const Sample& sample : samples_) {
    max_height_m = std::max(max_height_m, std::abs(sample.height_m));
    const auto count = static_cast<double>(sample.count);
    squares += count * (sample.square_m2 - sample.height_m * sample.height_m);
    points += count;
  }
  if (samples_.empty()) return result;
  result.start_m = static_cast<float>(samples_.front().along_m);
  result.height_step_m = static_cast<float>(max_height_m / RibbonSamples::kMaxHeight);
  result.variance_m2 = static_cast<float>(std::max(0.0, squares / points));
  long steps = 0;  // from the first sample, so that rounding errors do not accumulate
  for (const Sample& sample : samples_) {
    const long place =
        std::lround((sample.along_m - samples_.front().along_m) / RibbonSamples::kAlongStep_m);
    long advance = std::max(0L, place - steps);
    steps += advance;
    for (; advance > RibbonSamples::kMaxAdvance; advance -= RibbonSamples::kMaxAdvance) {
      packed_.push_back({RibbonSamples::kMaxAdvance, 0, 0});
    }
    const double height = max_height_m > 0.0 ? sample.height_m / result.height_step_m : 0.0;
    packed_.push_back(
        {static_cast<std::uint8_t>(advance), static_cast<std::uint8_t>(sample.count),
         static_cast<std::int8_t>(std::lround(std::clamp(height, -1.0 * RibbonSamples::kMaxHeight,
                                                         1.0 * RibbonSamples::kMaxHeight)))});
  }
  samples_.clear();
  result.first = packed_.data();
  result.size = static_cast<std::uint32_t>(packed_.size());
  return result;
}

}  // namespace ribbon_mapper
