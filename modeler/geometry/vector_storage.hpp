// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ribbon_mapper {

/// Reserves memory for one more element. The capacity grows by an eighth, since doubling would
/// leave up to half of it unused.
template <typename Element>
void reserve_one_more(std::vector<Element>& elements) {
  if (elements.size() == elements.capacity()) {
    elements.reserve(elements.size() + elements.size() / 8 + 16);
  }
}

/// Removes all elements but those at these ascending indices.
template <typename Element>
void keep_indices(const std::vector<std::uint32_t>& indices, std::vector<Element>& elements) {
  for (std::size_t i = 0; i < indices.size(); ++i) elements[i] = elements[indices[i]];
  elements.resize(indices.size());
}

}  // namespace ribbon_mapper
