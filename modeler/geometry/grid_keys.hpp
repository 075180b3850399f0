// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace ribbon_mapper {

/// Hashes keys that are packed from coordinates (finalizer of MurmurHash3).
struct KeyHash {
  /// Returns the hash of a key.
  std::size_t operator()(std::uint64_t key) const {
    key = (key ^ (key >> 33)) * 0xff51afd7ed558ccdULL;
    key = (key ^ (key >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return key ^ (key >> 33);
  }
};

/// Returns the largest integer that is not greater than `x`. Unlike std::floor on baseline x86-64,
/// this is no function call.
template <typename Real>
std::int32_t floor_to_int(Real x) {
  const auto i = static_cast<std::int32_t>(x);
  return i - (x < static_cast<Real>(i) ? 1 : 0);
}

}  // namespace ribbon_mapper
