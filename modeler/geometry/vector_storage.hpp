// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ribbon_mapper {

/// Reserves memory for `count` more elements. The capacity grows by an eighth, since doubling would
/// leave up to half of it unused.
template <typename Element>
void reserve_more(std::vector<Element>& elements, std::size_t count) {
  if (elements.size() + count > elements.capacity()) {
    elements.reserve(elements.size() + std::max(count, elements.size() / 8 + 16));
  }
}

/// Reserves memory for one more element, as reserve_more().
template <typename Element>
void reserve_one_more(std::vector<Element>& elements) {
  reserve_more(elements, 1);
}

/// Removes all elements but those at these ascending indices.
template <typename Element>
void keep_indices(const std::vector<std::uint32_t>& indices, std::vector<Element>& elements) {
  for (std::size_t i = 0; i < indices.size(); ++i) elements[i] = elements[indices[i]];
  elements.resize(indices.size());
}

}  // namespace ribbon_mapper
