// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ribbon_mapper {

/// Appends numbers to bytes, the least significant byte first, whatever the machine.
class ByteWriter {
 public:
  /// Makes room for so many bytes in total.
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }

  /// Appends an integer, in two's complement.
  template <typename Integer>
  void integer(Integer value) {
    static_assert(std::is_integral_v<Integer>);
    auto rest = static_cast<std::uint64_t>(value);
    std::array<char, sizeof(Integer)> bytes;
    for (char& byte : bytes) {
      byte = static_cast<char>(rest & 0xFFU);
      rest >>= 8U;
    }
    bytes_.append(bytes.data(), bytes.size());
  }
  /// Appends a number as IEEE 754 has it, in 32 bits.
  void number(float value) { integer(bits_of<std::uint32_t>(value)); }
  /// Appends a number as IEEE 754 has it, in 64 bits.
  void number(double value) { integer(bits_of<std::uint64_t>(value)); }
  /// Appends all numbers of a range.
  template <typename Numbers>
  void numbers(const Numbers& values) {
    for (const auto value : values) number(value);
  }
  /// Appends bytes as they are.
  void bytes(std::string_view bytes) { bytes_.append(bytes); }
  /// Appends a text of less than 64 KiB with its length; a longer one is cut.
  void text(std::string_view text) {
    const auto length = static_cast<std::uint16_t>(text.size() < kMaxText ? text.size() : kMaxText);
    integer(length);
    bytes(text.substr(0, length));
  }

  /// Returns all bytes. The writer is empty afterwards.
  std::string take() { return std::exchange(bytes_, {}); }

 private:
  static constexpr std::size_t kMaxText = 0xFFFF;

  template <typename Bits, typename Number>
  static Bits bits_of(Number value) {
    static_assert(sizeof(Bits) == sizeof(Number));
    Bits bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
  }

  std::string bytes_;
};

}  // namespace ribbon_mapper
