// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "modeler/geometry/moments.hpp"
#include "modeler/geometry/pose.hpp"
#include "modeler/ribbon/ribbon.hpp"

namespace ribbon_mapper {

/// A ribbon's samples moved to where its acquisition pose is believed to be: all that the cells of
/// a plane need of it.
struct PosedSamples {
  PosedSamples(const Ribbon& source, const Pose& pose)
      : ribbon(&source),
        centroid(pose * source.moments.mean()),
        normal(pose.linear() * source.normal.cast<double>()),
        along(pose.linear() * source.along.cast<double>()) {}

  const RibbonSamples& samples() const { return ribbon->samples; }
  Eigen::Vector3d point(float along_m, float height_m) const {
    return centroid + along_m * along + height_m * normal;
  }

  const Ribbon* ribbon;
  Eigen::Vector3d centroid, normal, along;
};

/// A ribbon moved to where its acquisition pose is believed to be (eq. 5, exactly: the rigid
/// transform of its points).
struct PosedRibbon : PosedSamples {
  PosedRibbon(const Ribbon& source, const Pose& pose)
      : PosedSamples(source, pose),
        moments(source.moments.transformed(pose)),
        across(normal.cross(along)) {}

  Moments moments;
  Eigen::Vector3d across;
};

}  // namespace ribbon_mapper
