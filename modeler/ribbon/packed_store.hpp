// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace ribbon_mapper {

/// Stores sequences of small elements one after the other in large blocks. A sequence stays at its
/// address, and no memory is freed before the store.
template <typename Element>
class PackedStore {
 public:
  /// Makes room for `count` elements: add() of that many in total then cannot fail.
  void reserve(std::size_t count) {
    if (count > room_) add_block(std::max(count, kBlockSize));
  }

  /// Stores a copy of [first, first + count) and returns its address. It is valid as long as the
  /// store, also after the store was moved.
  const Element* add(const Element* first, std::size_t count) {
    reserve(count);
    Element* const stored = next_;
    std::copy(first, first + count, stored);
    next_ += count, room_ -= count;
    return stored;
  }

  /// Returns the size of all blocks.
  std::size_t memory_bytes() const { return bytes_; }

 private:
  static constexpr std::size_t kBlockSize = std::size_t{1} << 16;

  void add_block(std::size_t size) {
    blocks_.push_back(std::make_unique<Element[]>(size));
    next_ = blocks_.back().get(), room_ = size;
    bytes_ += size * sizeof(Element);
  }

  std::vector<std::unique_ptr<Element[]>> blocks_;
  Element* next_ = nullptr;  // free room in the last block
  std::size_t room_ = 0, bytes_ = 0;
};

}  // namespace ribbon_mapper
