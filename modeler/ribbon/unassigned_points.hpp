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
  std::uint16_t count = 0;                    ///< points
};

/// Returns of one scan line that belong to no ribbon: too few side by side for a normal, or seen by
/// this line alone. They do not say where a plane is, only how far a plane was seen.
struct UnassignedPoints {
  static constexpr int max_steps = 32767, max_count = 65535;

  std::uint32_t pose = 0;  ///< acquisition pose: index into the trajectory
  std::uint32_t size = 0;
  const PackedPoint* first = nullptr;                ///< kept by a PackedStore
  Eigen::Vector3f sensor = Eigen::Vector3f::Zero();  ///< in the frame of the acquisition pose
  float step_m = 0.001F;  ///< a millimetre, or what the furthest of them needs

  const PackedPoint* begin() const { return first; }
  const PackedPoint* end() const { return first + size; }
  /// In the frame of the acquisition pose.
  Eigen::Vector3f point(const PackedPoint& packed) const {
    return sensor + step_m * Eigen::Vector3f(packed.from_sensor[0], packed.from_sensor[1],
                                             packed.from_sensor[2]);
  }
};

}  // namespace ribbon_mapper
