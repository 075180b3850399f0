// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/text/number_text.hpp"

#include <array>
#include <charconv>
#include <limits>

#include "modeler/text/stream_numbers.hpp"

namespace ribbon_mapper {

#ifdef __cpp_lib_to_chars

namespace {

template <typename... Format>
std::string text_of(double value, Format... format) {
  constexpr std::size_t kLongest = std::numeric_limits<double>::max_exponent10 + 32;
  std::array<char, kLongest> text;
  return {text.data(), std::to_chars(text.begin(), text.end(), value, format...).ptr};
}

}  // namespace

std::string shortest_text(double value) { return text_of(value); }

std::string fixed_text(double value, int decimals) {
  return text_of(value, std::chars_format::fixed, decimals);
}

std::string scientific_text(double value, int decimals) {
  return text_of(value, std::chars_format::scientific, decimals);
}

std::string general_text(double value, int digits) {
  return text_of(value, std::chars_format::general, digits);
}

std::optional<double> number_from(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end) return std::nullopt;
  return value;
}

#else  // the standard library of gcc 10 and older

std::string shortest_text(double value) { return stream_numbers::shortest_text(value); }

std::string fixed_text(double value, int decimals) {
  return stream_numbers::text_of(value, decimals, std::ios_base::fixed);
}

std::string scientific_text(double value, int decimals) {
  return stream_numbers::text_of(value, decimals, std::ios_base::scientific);
}

std::string general_text(double value, int digits) {
  return stream_numbers::text_of(value, digits, {});
}

std::optional<double> number_from(const std::string& text) {
  return stream_numbers::number_from(text);
}

#endif

}  // namespace ribbon_mapper
