// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/ribbon/ribbon_samples.hpp"

namespace ribbon_mapper {

/// Packs the samples of one ribbon after another, and keeps its memory from one to the next.
class SamplePacker {
 public:
  /// Adds a sample that lies further along the ribbon than the one before it. `along_m` and
  /// `height_m` are the means of its points; `square_m2` is their mean square distance from the
  /// ribbon's plane.
  void add(double along_m, double height_m, double square_m2, std::size_t count);

  /// Returns all samples that were added since the last call. Valid until the next call.
  RibbonSamples pack();

 private:
  struct Sample {
    double along_m, height_m, square_m2;
    std::size_t count;
  };
  std::vector<Sample> samples_;
  std::vector<PackedSample> packed_;
};

}  // namespace ribbon_mapper
