// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/box_index.hpp"

#include <algorithm>

namespace ribbon_mapper {

/// Collects the boxes that intersect one, as Eigen::BVIntersect() visits the tree.
struct BoxIndex::Query {
  // NOLINTBEGIN(readability-identifier-naming): Eigen's names
  bool intersectVolume(const Eigen::AlignedBox3d& volume) const { return volume.intersects(box); }
  bool intersectObject(const Entry& entry) {
    if (entry.box.intersects(box)) found.push_back(entry.index);
    return false;  // go on
  }
  // NOLINTEND(readability-identifier-naming)

  Eigen::AlignedBox3d box;
  std::vector<std::size_t> found{};
};

BoxIndex::BoxIndex(const std::vector<Eigen::AlignedBox3d>& boxes) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty()) entries.push_back({i, boxes[i]});
  }
  tree_.init(entries.begin(), entries.end());
}

std::vector<std::size_t> BoxIndex::near(const Eigen::AlignedBox3d& box, double reach_m) const {
  if (box.isEmpty()) return {};
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(reach_m);
  Query query{{box.min() - reach, box.max() + reach}};
  Eigen::BVIntersect(tree_, query);
  std::sort(query.found.begin(), query.found.end());
  return query.found;
}

}  // namespace ribbon_mapper
