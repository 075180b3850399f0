// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <type_traits>

namespace ribbon_mapper {

// Numbers as text, whatever the locale of the process.

/// Returns the shortest text that reads back as the same number.
std::string shortest_text(double value);

/// Returns the digits of an integer.
template <typename Integer, typename = std::enable_if_t<std::is_integral_v<Integer>>>
std::string shortest_text(Integer value) {
  return std::to_string(value);
}

/// Returns a number with up to 20 decimals.
std::string fixed_text(double value, int decimals);

/// Returns a number as 1.2345e+06, with up to 20 decimals.
std::string scientific_text(double value, int decimals);

/// Returns a number with up to 20 significant digits, as %g of printf.
std::string general_text(double value, int digits);

/// Returns the decimal number that is all of a text; nothing if it is none. Takes no spaces and no
/// plus before it. A number that is too large or too small for a double is none.
std::optional<double> number_from(const std::string& text);

}  // namespace ribbon_mapper
