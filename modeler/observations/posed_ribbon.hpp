// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "modeler/geometry/moments.hpp"
#include "modeler/geometry/pose.hpp"
#include "modeler/ribbon/ribbon.hpp"

namespace ribbon_mapper {

/// The samples of a ribbon in the target frame of its acquisition pose. Suffices to fill the cells
/// of a plane.
struct PosedSamples {
  /// Transforms a ribbon, which must outlive this.
  PosedSamples(const Ribbon& source, const Pose& pose)
      : ribbon(&source),
        centroid(pose * source.moments.mean()),
        normal(pose.linear() * source.normal.cast<double>()),
        along(pose.linear() * source.along.cast<double>()) {}

  /// Returns the samples in the frame of the ribbon.
  const RibbonSamples& samples() const { return ribbon->samples; }
  /// Returns the position of a sample at these coordinates along and above the ribbon [m].
  Eigen::Vector3d point(float along_m, float height_m) const {
    return centroid + along_m * along + height_m * normal;
  }

  const Ribbon* ribbon;      ///< the ribbon itself, in the frame of its acquisition pose
  Eigen::Vector3d centroid;  ///< mean of its points [m]
  Eigen::Vector3d normal;    ///< unit normal
  Eigen::Vector3d along;     ///< unit direction along the ribbon
};

/// A ribbon in the target frame of its acquisition pose: the exact rigid transform of its points
/// (eq. 5 of the paper).
struct PosedRibbon : PosedSamples {
  /// Transforms a ribbon, which must outlive this.
  PosedRibbon(const Ribbon& source, const Pose& pose)
      : PosedSamples(source, pose),
        moments(source.moments.transformed(pose)),
        across(normal.cross(along)) {}

  Moments moments;         ///< of its points
  Eigen::Vector3d across;  ///< unit direction in its plane, orthogonal to `along`
};

}  // namespace ribbon_mapper
