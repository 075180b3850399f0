// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ios>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

/// Numbers as text by streams, for standard libraries without std::to_chars(double): the same
/// texts, slower.
namespace ribbon_mapper::stream_numbers {

/// Returns a number in a format of streams, with this precision.
inline std::string text_of(double value, int precision, std::ios_base::fmtflags format) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.flags(format);
  stream.precision(precision);
  stream << value;
  return stream.str();
}

/// Returns the decimal number that is all of a text; nothing if it is none.
inline std::optional<double> number_from(const std::string& text) {
  const std::size_t sign = text.rfind('-', 0) == 0 ? 1 : 0;
  std::string size = text.substr(sign);
  for (char& c : size) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  double value = 0.0;
  if (size == "inf" || size == "infinity") {
    value = std::numeric_limits<double>::infinity();
  } else if (size == "nan") {
    value = std::numeric_limits<double>::quiet_NaN();
  } else {
    if (size.empty() || size.find_first_not_of("0123456789.e+-") != std::string::npos) return {};
    if (size[0] == '+' || size[0] == '-') return {};
    std::istringstream stream(size);
    stream.imbue(std::locale::classic());
    stream >> value;
    if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof()) return {};
    const bool is_zero =
        size.substr(0, size.find('e')).find_first_not_of("0.") == std::string::npos;
    if (value == 0.0 && !is_zero) return {};
  }
  return sign == 1 ? -value : value;
}

/// Returns the shorter of the fixed and the scientific text of a number, in as few digits as read
/// back as the same.
inline std::string shortest_text(double value) {
  if (!std::isfinite(value)) return text_of(value, 0, {});
  int decimals = 0;
  std::string scientific = text_of(value, decimals, std::ios_base::scientific);
  while (number_from(scientific) != value && decimals < 17) {
    scientific = text_of(value, ++decimals, std::ios_base::scientific);
  }
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  const std::string fixed = text_of(value, std::max(decimals - exponent, 0), std::ios_base::fixed);
  return fixed.size() <= scientific.size() ? fixed : scientific;
}

}  // namespace ribbon_mapper::stream_numbers
