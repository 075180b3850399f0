// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/maps/maps_config.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/plane_model.hpp"

namespace ribbon_mapper {

/// The beams of a ribbon: with the sensor it spans a triangle, which no surface crosses. A ribbon's
/// beams are successive and all return from its plane.
struct Fan {
  Eigen::Vector3f first;   ///< first end of the ribbon [m]
  Eigen::Vector3f last;    ///< other end [m]
  float free_part = 0.0F;  ///< part of the way from the sensor to the ribbon that is free
};

/// A return that belongs to no plane.
struct LooseReturn {
  Eigen::Vector3f point;  ///< where it is [m]
  bool has_fan = false;   ///< the way to it is part of a fan
};

/// What one scan line saw. Its fans and returns begin where those of the line before end.
struct SightLine {
  Eigen::Vector3f sensor;        ///< origin of the beams [m]
  std::uint32_t end_fan = 0;     ///< one past its last element of SightLines::fans
  std::uint32_t end_return = 0;  ///< one past its last element of SightLines::returns
};

/// What all beams of a model passed and where they ended: a small copy of the observations at their
/// poses, to be used by another thread. Takes about 30 bytes for each ribbon and 16 for each return
/// that belongs to no plane.
struct SightLines {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of all positions, in map [m]
  std::vector<SightLine> lines;                      ///< in the order of time
  std::vector<Fan> fans;                             ///< in the order of lines and beams
  std::vector<LooseReturn> returns;                  ///< in the order of lines
  std::vector<Eigen::Vector3f> bases;                ///< places of base_footprint, by line [m]

  /// Returns the memory in use.
  std::size_t memory_bytes() const;
};

/// Returns the sight lines of all observations. `model` is that of the same observations. Ribbons
/// of its planes have no loose returns, nor have those that are gone. Positions are relative to
/// `origin`, in map.
SightLines sight_lines_of(const PosedObservations& observations, const PlaneModel& model,
                          const MapsConfig& config,
                          const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

}  // namespace ribbon_mapper
