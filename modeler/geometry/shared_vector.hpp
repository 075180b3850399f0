// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "modeler/geometry/vector_storage.hpp"

namespace ribbon_mapper {

/// A vector whose copies share their elements, in blocks, until one of them changes an element.
///
/// A copy is cheap and costs memory only for what changes afterwards. Copies that share elements
/// must stay within one thread.
template <typename Element>
class SharedVector {
 public:
  /// Returns the number of elements.
  std::size_t size() const { return size_; }
  /// Returns an element to be read.
  const Element& operator[](std::size_t index) const {
    return blocks_[index / kWidth]->elements[index % kWidth];
  }
  /// Returns an element to be changed. It is valid until the vector is copied or changed.
  Element& edit(std::size_t index) {
    std::shared_ptr<Block>& block = blocks_[index / kWidth];
    if (block.use_count() > 1) block = std::make_shared<Block>(*block);
    return block->elements[index % kWidth];
  }
  /// Appends an element.
  void push_back(Element element) {
    if (size_ % kWidth == 0) {
      reserve_one_more(blocks_);
      blocks_.push_back(std::make_shared<Block>());
    }
    edit(size_) = std::move(element);
    ++size_;
  }

  /// Returns true if an element is the same object in memory as that of `other`.
  bool shares(std::size_t index, const SharedVector& other) const {
    return index < size_ && index < other.size_ &&
           blocks_[index / kWidth] == other.blocks_[index / kWidth];
  }
  /// Calls function(element) for each element whose block `other` does not share.
  template <typename Function>
  void for_each_unshared(const SharedVector& other, const Function& function) const {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (i < other.blocks_.size() && blocks_[i] == other.blocks_[i]) continue;
      for (const Element& element : blocks_[i]->elements) function(element);
    }
  }
  /// Returns the memory of the references to elements.
  std::size_t memory_bytes() const { return blocks_.capacity() * sizeof(blocks_[0]); }

 private:
  static constexpr std::size_t kWidth = 4;  // few, as a change copies a whole block
  struct Block {
    std::array<Element, kWidth> elements;
  };

  std::vector<std::shared_ptr<Block>> blocks_;
  std::size_t size_ = 0;
};

}  // namespace ribbon_mapper
