// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "modeler/geometry/moments.hpp"
#include "modeler/geometry/pose.hpp"
#include "modeler/ribbon/ribbon.hpp"

namespace ribbon_mapper {

/// A ribbon moved to where its acquisition pose is believed to be (eq. 5, exactly: the rigid
/// transform of its points).
struct PosedRibbon {
  PosedRibbon(const Ribbon& source, const Pose& pose)
      : ribbon(&source),
        moments(source.spread.transformed(pose)),
        centroid(moments.mean()),
        normal(pose.linear() * source.normal.cast<double>()),
        along(pose.linear() * source.along.cast<double>()),
        across(normal.cross(along)) {}

  /// A point of one of the ribbon's samples.
  Eigen::Vector3d point(float along_m, float height_m) const {
    return centroid + along_m * along + height_m * normal;
  }

  const Ribbon* ribbon;
  Moments moments;
  Eigen::Vector3d centroid, normal, along, across;
};

}  // namespace ribbon_mapper
