// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <vector>

#include "modeler/modeler.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/line_log.hpp"

namespace ribbon_mapper {

/// The model with all that the node says about it: how it was before the last correction, what
/// became of the lines, how long things took.
class ModelKeeper {
 public:
  explicit ModelKeeper(const ModelerConfig& config)
      : modeler_(config), stripe_gap_m_(config.surface.stripe_gap_m) {}

  void add(const ReadyLine& line);
  /// Throws as Modeler::correct() does; the model, and how it was before, then stay as they were.
  void correct(const std::vector<StampedPose>& trajectory);
  void reset();

  const Modeler& modeler() const { return modeler_; }
  /// Returns SurfaceConfig::stripe_gap_m, for meshes and markers.
  double stripe_gap_m() const { return stripe_gap_m_; }
  LineLog& log() { return log_; }
  const LineLog& log() const { return log_; }

  /// Counts every change of the model, to know whether there is anything new to say.
  std::size_t version() const { return version_; }
  const std::vector<Plane>& planes();  ///< computed once per version

  struct Before {
    std::vector<Plane> planes, planes;
    std::vector<StampedPose> trajectory;
  };
  const Before& before() const { return before_; }
  double correction_ms() const { return correction_ms_; }  ///< 0: there was none
  /// Seconds that the laser took for the lines per second that the model took.
  double real_time_factor() const;

 private:
  Modeler modeler_;
  double stripe_gap_m_;
  LineLog log_;
  std::size_t version_ = 1, merged_version_ = 0;
  std::vector<Plane> merged_;
  Before before_;
  double correction_ms_ = 0.0;
  Time last_stamp_{0};
  double data_s_ = 0.0;
};

}  // namespace ribbon_mapper
