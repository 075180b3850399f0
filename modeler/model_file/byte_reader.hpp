// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ribbon_mapper {

/// Reads what a ByteWriter has written. Every method throws std::runtime_error that names the part
/// of the file if there are too few bytes.
class ByteReader {
 public:
  /// Reads bytes, which must outlive the reader. `part` names them in errors.
  ByteReader(std::string_view bytes, std::string part) : bytes_(bytes), part_(std::move(part)) {}

  /// Reads an integer.
  template <typename Integer>
  Integer integer() {
    static_assert(std::is_integral_v<Integer>);
    const std::string_view bytes = this->bytes(sizeof(Integer));
    std::uint64_t value = 0;
    for (std::size_t i = sizeof(Integer); i-- > 0;) {
      value = value << 8U | static_cast<unsigned char>(bytes[i]);
    }
    return static_cast<Integer>(value);
  }
  /// Reads a number of 32 or 64 bits, float or double.
  template <typename Number>
  Number number() {
    using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
    const Bits bits = integer<Bits>();
    Number value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  /// Reads as many numbers as the array has, of its type.
  template <typename Numbers>
  Numbers numbers() {
    Numbers values;
    for (auto& value : values) value = number<std::decay_t<decltype(value)>>();
    return values;
  }
  /// Reads a switch: 0 or 1. Throws as fail() for another value.
  bool flag() {
    const auto value = integer<std::uint8_t>();
    if (value > 1) fail("has a switch that is neither on nor off");
    return value == 1;
  }
  /// Reads so many bytes as they are.
  std::string_view bytes(std::size_t count) {
    if (count > bytes_.size()) fail("ends too early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  /// Reads a text.
  std::string text() { return std::string(bytes(integer<std::uint16_t>())); }
  /// Reads the number of elements that follow, each of at least so many bytes. Throws if so many
  /// cannot follow, so that the result is a safe number of elements to reserve.
  std::size_t count(std::size_t least_bytes_of_each) {
    const auto count = integer<std::uint64_t>();
    if (count > bytes_.size() / least_bytes_of_each) fail("states more elements than it has");
    return static_cast<std::size_t>(count);
  }
  /// Returns the number of bytes that are left.
  std::size_t left() const { return bytes_.size(); }
  /// Throws if bytes are left.
  void expect_end() const {
    if (!bytes_.empty()) fail("goes on behind its end");
  }
  /// Throws std::runtime_error: the part, and what is wrong with it.
  [[noreturn]] void fail(const std::string& defect) const {
    throw std::runtime_error("part " + part_ + " " + defect);
  }

 private:
  std::string_view bytes_;
  std::string part_;
};

}  // namespace ribbon_mapper
