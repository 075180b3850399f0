// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ribbon_mapper {

/// Makes room for one more element; by an eighth, where doubling would leave half of it unused.
template <typename Element>
void grow_sparingly(std::vector<Element>& elements) {
  if (elements.size() == elements.capacity()) {
    elements.reserve(elements.size() + elements.size() / 8 + 16);
  }
}

}  // namespace ribbon_mapper
