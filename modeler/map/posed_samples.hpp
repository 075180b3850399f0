// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "modeler/geometry/pose.hpp"
#include "modeler/ribbon/ribbon.hpp"

namespace ribbon_mapper {

/// A ribbon's samples moved to where its acquisition pose is believed to be: all that the cells of
/// a plane need of it.
struct PosedSamples {
  PosedSamples(const Ribbon& ribbon, const Pose& pose)
      : samples(ribbon.samples),
        centroid(pose * ribbon.spread.mean()),
        normal(pose.linear() * ribbon.normal.cast<double>()),
        along(pose.linear() * ribbon.along.cast<double>()) {}

  Eigen::Vector3d point(float along_m, float height_m) const {
    return centroid + along_m * along + height_m * normal;
  }

  const RibbonSamples& samples;
  Eigen::Vector3d centroid, normal, along;
};

}  // namespace ribbon_mapper
