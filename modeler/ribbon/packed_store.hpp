// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace ribbon_mapper {

/// Keeps runs of small records one after the other in large blocks. A run stays where it is, and
/// nothing is freed before the store.
template <typename Record>
class PackedStore {
 public:
  /// A copy of [first, first + count); valid as long as the store, also if that is moved.
  const Record* keep(const Record* first, std::size_t count) {
    if (count > room_) add_block(std::max(count, block_size));
    Record* const kept = next_;
    std::copy(first, first + count, kept);
    next_ += count, room_ -= count;
    return kept;
  }

  std::size_t memory_bytes() const { return bytes_; }

 private:
  static constexpr std::size_t block_size = std::size_t{1} << 16;

  void add_block(std::size_t size) {
    blocks_.push_back(std::make_unique<Record[]>(size));
    next_ = blocks_.back().get(), room_ = size;
    bytes_ += size * sizeof(Record);
  }

  std::vector<std::unique_ptr<Record[]>> blocks_;
  Record* next_ = nullptr;  // free room in the last block
  std::size_t room_ = 0, bytes_ = 0;
};

}  // namespace ribbon_mapper
