// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace ribbon_mapper {

/// A few neighbouring returns in eight bytes.
struct PackedPoint {
  std::array<std::int16_t, 3> from_sensor{};  ///< mean [UnassignedPoints::step_m]
  std::uint16_t count = 0;                    ///< number of points
};

/// Returns of one scan line that belong to no ribbon: too few side by side for a normal, or seen by
/// this line alone. They do not tell where a plane is, only how far a plane was seen.
struct UnassignedPoints {
  static constexpr int kMaxSteps = 32767;  ///< largest coordinate of a packed point [step_m]
  static constexpr int kMaxCount = 65535;  ///< largest number of returns in a packed point

  std::uint32_t pose = 0;                            ///< acquisition pose: trajectory index
  std::uint32_t size = 0;                            ///< number of packed points
  const PackedPoint* first = nullptr;                ///< the points; owned by a PackedStore
  Eigen::Vector3f sensor = Eigen::Vector3f::Zero();  ///< sensor in the acquisition pose's frame [m]
  float step_m = 0.001F;  ///< unit of the coordinates: 1 mm, or more if the furthest point needs it

  /// Returns an iterator to the first point.
  const PackedPoint* begin() const { return first; }
  /// Returns an iterator past the last point.
  const PackedPoint* end() const { return first + size; }
  /// Returns a point in the frame of the acquisition pose [m].
  Eigen::Vector3f point(const PackedPoint& packed) const {
    return sensor + step_m * Eigen::Vector3f(packed.from_sensor[0], packed.from_sensor[1],
                                             packed.from_sensor[2]);
  }
};

}  // namespace ribbon_mapper
