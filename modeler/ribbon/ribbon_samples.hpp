// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ribbon_mapper {

/// A few neighbouring points of a ribbon in three bytes: where on the ribbon, how many, and their
/// mean distance from its plane.
struct PackedSample {
  std::uint8_t advance = 0;  ///< along the ribbon since the sample before [along_step_m]
  std::uint8_t count = 0;    ///< points; 0: a stretch without any that is too long for one advance
  std::int8_t height = 0;    ///< [RibbonSamples::height_step_m]
};

/// The points of a ribbon for the cells of planes, as means over short stretches of it: all on one
/// straight line through its centroid, up to their distances from its plane. (A laser that tilts
/// and turns bends the line that it draws on a far floor by a few centimetres: less than a cell.)
struct RibbonSamples {
  static constexpr float along_step_m = 0.005F;
  static constexpr int max_advance = 255, max_count = 255, max_height = 127;

  const PackedSample* first = nullptr;
  std::uint32_t size = 0;
  float start_m = 0.0F;        ///< of the first sample along the ribbon from its centroid
  float height_step_m = 0.0F;  ///< of this ribbon
  float variance_m2 = 0.0F;    ///< of the points about their sample's mean, across the plane

  /// From the first sample to the last.
  float length_m() const { return size > 0 ? way_m(size - 1) : 0.0F; }

  /// Of the sample in the middle of their row, along the ribbon from its centroid.
  float middle_m() const { return start_m + (size > 0 ? way_m(size / 2) : 0.0F); }

  /// Calls function(along_m, height_m, count) for each sample, in order.
  template <typename Function>
  void for_each(const Function& function) const {
    for_each_packed([&](int steps, const PackedSample& sample) {
      function(start_m + static_cast<float>(steps) * along_step_m,
               static_cast<float>(sample.height) * height_step_m,
               static_cast<std::uint32_t>(sample.count));
    });
  }

  /// Calls function(steps, sample): so many steps from the first one.
  template <typename Function>
  void for_each_packed(const Function& function) const {
    int steps = 0;
    for (const PackedSample *sample = first, *const end = first + size; sample != end; ++sample) {
      steps += sample->advance;
      if (sample->count > 0) function(steps, *sample);
    }
  }

 private:
  /// From the first sample to this one.
  float way_m(std::uint32_t index) const {
    int steps = 0;
    for (std::uint32_t i = 1; i <= index; ++i) steps += first[i].advance;
    return static_cast<float>(steps) * along_step_m;
  }
};

}  // namespace ribbon_mapper
