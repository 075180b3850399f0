// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace ribbon_mapper::eval {

/// Returns what printf() would print, up to 511 characters: a row of a table.
template <typename... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  std::array<char, 512> text;
  std::snprintf(text.data(), text.size(), pattern, arguments...);
  return text.data();
}

}  // namespace ribbon_mapper::eval
