// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/registration/odometry_noise.hpp"
#include "slam/lines/posed_lines.hpp"

namespace ribbon_mapper::slam {

/// Learns the scales of the odometry's noise from adjusted poses: in the plane, and out of it.
///
/// Over spans of two seconds, the odometry's motion is compared with the adjusted one. The mean
/// squared error, in standard deviations, is that of the noise itself, but for what the adjustment
/// cannot tell from it.
class NoiseScale {
 public:
  /// Starts with assumed scales, see OdometryNoise. They count as much as 20 s of driving.
  NoiseScale(double planar, double spatial) : planar_(planar), spatial_(spatial) {}

  /// Takes lines [first, end) into account, whose poses are adjusted.
  void learn(const PosedLines& lines, std::uint32_t first, std::uint32_t end);

  /// Returns the odometry's noise as it was learnt.
  OdometryNoise noise() const;

 private:
  /// A scale by what was assumed and measured.
  class Mean {
   public:
    explicit Mean(double assumed) : assumed_(assumed) {}
    double value() const;
    void add(double measured);

   private:
    double assumed_;
    double square_sum_ = 0.0;
    double spans_ = 0.0;
  };
  Mean planar_, spatial_;
};

}  // namespace ribbon_mapper::slam
