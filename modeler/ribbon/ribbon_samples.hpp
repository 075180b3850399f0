// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ribbon_mapper {

/// A few neighbouring points of a ribbon in three bytes: their place on the ribbon, their number
/// and their mean distance from its plane.
struct PackedSample {
  std::uint8_t advance = 0;  ///< along the ribbon since the previous sample [kAlongStep_m]
  std::uint8_t count = 0;    ///< number of points; 0 continues an advance that is too long for one
  std::int8_t height = 0;    ///< mean distance from the plane [RibbonSamples::height_step_m]
};

/// The points of a ribbon, as means over short stretches of it, for the cells of planes.
///
/// All samples lie on one straight line through the ribbon's centroid, up to their distances from
/// its plane. (A laser that tilts and turns bends its line on a distant floor by a few centimetres,
/// which is less than a cell.)
struct RibbonSamples {
  static constexpr float kAlongStep_m = 0.005F;  ///< unit of PackedSample::advance
  static constexpr int kMaxAdvance = 255;        ///< largest PackedSample::advance
  static constexpr int kMaxCount = 255;          ///< largest PackedSample::count
  static constexpr int kMaxHeight = 127;         ///< largest PackedSample::height

  const PackedSample* first = nullptr;  ///< the samples, in order along the ribbon
  std::uint32_t size = 0;               ///< number of samples
  float start_m = 0.0F;        ///< place of the first sample, along the ribbon from its centroid
  float height_step_m = 0.0F;  ///< unit of PackedSample::height
  float variance_m2 = 0.0F;  ///< variance of the points about their sample's mean, across the plane

  /// Returns the distance from the first sample to the last [m].
  float length_m() const { return size > 0 ? distance_m(size - 1) : 0.0F; }

  /// Returns the place of the median sample, along the ribbon from its centroid [m].
  float middle_m() const { return start_m + (size > 0 ? distance_m(size / 2) : 0.0F); }

  /// Calls function(along_m, height_m, count) for each sample, in order.
  template <typename Function>
  void for_each(const Function& function) const {
    for_each_packed([&](int steps, const PackedSample& sample) {
      function(start_m + static_cast<float>(steps) * kAlongStep_m,
               static_cast<float>(sample.height) * height_step_m,
               static_cast<std::uint32_t>(sample.count));
    });
  }

  /// Calls function(steps, sample) for each sample, in order, with its steps from the first sample.
  template <typename Function>
  void for_each_packed(const Function& function) const {
    int steps = 0;
    for (const PackedSample *sample = first, *const end = first + size; sample != end; ++sample) {
      steps += sample->advance;
      if (sample->count > 0) function(steps, *sample);
    }
  }

 private:
  /// Returns the distance from the first sample to the one at `index` [m].
  float distance_m(std::uint32_t index) const {
    int steps = 0;
    for (std::uint32_t i = 1; i <= index; ++i) steps += first[i].advance;
    return static_cast<float>(steps) * kAlongStep_m;
  }
};

}  // namespace ribbon_mapper
