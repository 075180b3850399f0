// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>

namespace ribbon_mapper {

/// Returns the number in a variable of the environment, or `otherwise` if it is not set.
inline int environment_number(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

}  // namespace ribbon_mapper
