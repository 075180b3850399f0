// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rays/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace ribbon_mapper::sim {
namespace {

using Box = Eigen::AlignedBox3d;

constexpr int kBins = 16;
constexpr int kMaxInLeaf = 8;
constexpr double kNodeCost = 0.5;  ///< of a node against that of an item
constexpr int kGoodLevels = 40;    ///< deeper than this, ranges are halved: 32 levels at most

double half_area(const Box& box) {
  if (box.isEmpty()) return 0.0;
  const Eigen::Vector3d s = box.sizes();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

/// Items [begin, end) of the order, and their common box.
struct Range {
  int begin, end;
  Box box;
  int size() const { return end - begin; }
};

class Builder {
 public:
  Builder(const std::vector<Box>& boxes, double margin_m, BoxTree& tree)
      : boxes_(boxes), margin_m_(margin_m), tree_(tree) {
    tree_.items.resize(boxes.size());
    std::iota(tree_.items.begin(), tree_.items.end(), 0);
  }

  void build() {
    const Range all = range(0, static_cast<int>(boxes_.size()));
    tree_.nodes.emplace_back();
    fill(0, children_of(all, 0), 0);
  }

 private:
  struct Split {
    int axis;
    double place_m;
    double cost;
  };

  Range range(int begin, int end) const {
    Box box;
    for (int i = begin; i < end; ++i) box.extend(boxes_[tree_.items[i]]);
    return {begin, end, box};
  }

  /// Of the borders of equal bins along one axis, the one with the least cost.
  Split best_split(const Range& all, const Box& centres, int axis) const {
    struct Bin {
      Box box;
      int count = 0;
    };
    std::array<Bin, kBins> bins;
    const double low_m = centres.min()[axis];
    const double bin_m = centres.sizes()[axis] / kBins;
    for (int i = all.begin; i < all.end; ++i) {
      const Box& box = boxes_[tree_.items[i]];
      const int bin = std::min(kBins - 1, static_cast<int>((box.center()[axis] - low_m) / bin_m));
      bins[bin].box.extend(box);
      ++bins[bin].count;
    }
    std::array<double, kBins> right_cost{};
    Bin right;
    for (int i = kBins - 1; i > 0; --i) {
      right.box.extend(bins[i].box);
      right.count += bins[i].count;
      right_cost[i] = half_area(right.box) * right.count;
    }
    Split best{axis, low_m, std::numeric_limits<double>::infinity()};
    Bin left;
    for (int i = 1; i < kBins; ++i) {
      left.box.extend(bins[i - 1].box);
      left.count += bins[i - 1].count;
      const double cost = half_area(left.box) * left.count + right_cost[i];
      if (cost < best.cost) best = {axis, low_m + i * bin_m, cost};
    }
    return best;
  }

  /// Two parts, or nothing if the items are better kept together.
  std::optional<std::array<Range, 2>> split(const Range& all, int level) {
    Box centres;
    for (int i = all.begin; i < all.end; ++i) centres.extend(boxes_[tree_.items[i]].center());
    std::optional<Split> best;
    for (int axis = 0; axis < 3 && level < kGoodLevels; ++axis) {
      if (!(centres.sizes()[axis] > 0.0)) continue;
      const Split candidate = best_split(all, centres, axis);
      if (!best || candidate.cost < best->cost) best = candidate;
    }
    const double area = half_area(all.box);
    if (all.size() <= kMaxInLeaf && (!best || best->cost + kNodeCost * area >= area * all.size()))
      return std::nullopt;
    const int middle = best ? parted(all, *best) : (all.begin + all.end) / 2;
    return std::array<Range, 2>{range(all.begin, middle), range(middle, all.end)};
  }

  int parted(const Range& all, const Split& best) {
    const auto first = tree_.items.begin() + all.begin, last = tree_.items.begin() + all.end;
    const auto middle = std::stable_partition(first, last, [&](std::int32_t item) {
      return boxes_[item].center()[best.axis] < best.place_m;
    });
    if (middle == first || middle == last) return (all.begin + all.end) / 2;
    return static_cast<int>(middle - tree_.items.begin());
  }

  /// Up to four parts: the largest is split as long as that pays.
  std::vector<Range> children_of(const Range& all, int level) {
    std::vector<Range> done, open{all};
    while (!open.empty() && done.size() + open.size() < BoxTree::kChildren) {
      const auto largest =
          std::max_element(open.begin(), open.end(), [](const Range& a, const Range& b) {
            return half_area(a.box) * a.size() < half_area(b.box) * b.size();
          });
      const Range whole = *largest;
      open.erase(largest);
      if (const auto parts = split(whole, level))
        open.insert(open.end(), parts->begin(), parts->end());
      else
        done.push_back(whole);
    }
    done.insert(done.end(), open.begin(), open.end());
    return done;
  }

  void fill(std::size_t node, const std::vector<Range>& children, int level) {
    const bool is_leaf = children.size() == 1;
    for (int i = 0; i < BoxTree::kChildren; ++i) {
      const bool present = i < static_cast<int>(children.size());
      set_box(node, i, present ? children[i].box : Box());
      tree_.nodes[node].first[i] = present ? children[i].begin : 0;
      tree_.nodes[node].count[i] = present ? children[i].size() : 0;
      if (!present || is_leaf || children[i].size() == 1) continue;
      const std::vector<Range> grandchildren = children_of(children[i], level + 1);
      if (grandchildren.size() == 1) continue;
      tree_.nodes[node].first[i] = static_cast<std::int32_t>(tree_.nodes.size());
      tree_.nodes[node].count[i] = 0;
      tree_.nodes.emplace_back();
      fill(tree_.nodes.size() - 1, grandchildren, level + 1);
    }
  }

  void set_box(std::size_t node, int child, const Box& box) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      float low_m = kInfinity, high_m = -kInfinity;
      if (!box.isEmpty()) {
        low_m = std::nextafter(static_cast<float>(box.min()[axis] - margin_m_), -kInfinity);
        high_m = std::nextafter(static_cast<float>(box.max()[axis] + margin_m_), kInfinity);
      }
      tree_.nodes[node].low_m[axis][child] = low_m;
      tree_.nodes[node].high_m[axis][child] = high_m;
    }
  }

  const std::vector<Box>& boxes_;
  const double margin_m_;
  BoxTree& tree_;
};

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes, double margin_m) {
  Builder(boxes, margin_m, *this).build();
}

}  // namespace ribbon_mapper::sim
