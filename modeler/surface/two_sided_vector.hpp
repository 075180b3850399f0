// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace ribbon_mapper {

/// A vector that grows at both ends and whose indices may be negative.
template <typename Item>
class TwoSidedVector {
 public:
  /// Returns the item at an index. Grows the vector up to that index if necessary.
  Item& at(int index) {
    if (items_.empty()) begin_ = index;
    if (index < begin_) grow_in_front(begin_ - index);
    if (index >= end()) items_.resize(static_cast<std::size_t>(index - begin_) + 1);
    return items_[static_cast<std::size_t>(index - begin_)];
  }

  /// Returns the item at an index, or null if it is beyond the ends.
  const Item* find(int index) const {
    if (index < begin_ || index >= end()) return nullptr;
    return &items_[static_cast<std::size_t>(index - begin_)];
  }

  /// Returns the first index.
  int begin() const { return begin_; }
  /// Returns the index after the last one.
  int end() const { return begin_ + static_cast<int>(items_.size()); }

 private:
  void grow_in_front(int count) {
    std::vector<Item> grown(items_.size() + static_cast<std::size_t>(count));
    std::move(items_.begin(), items_.end(), grown.begin() + count);
    items_ = std::move(grown);
    begin_ -= count;
  }

  int begin_ = 0;
  std::vector<Item> items_;
};

}  // namespace ribbon_mapper
