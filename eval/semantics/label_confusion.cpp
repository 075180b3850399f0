// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/semantics/label_confusion.hpp"

#include <unordered_map>

#include "modeler/geometry/voxel_key.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr double kReach_m = 0.1;           // two cells
constexpr double kSameSideCosine = 0.906;  // 25 degrees

std::size_t index_of(Label label) { return static_cast<std::size_t>(label); }

/// True cells by place.
class LabelIndex {
 public:
  explicit LabelIndex(const std::vector<LabelledCell>& cells) : cells_(cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      voxels_[voxel_key(cells[i].centre, kReach_m)].push_back(i);
    }
  }

  /// Returns the nearest cell that looks in the direction of `normal`, null if there is none.
  const LabelledCell* nearest(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const {
    const LabelledCell* nearest = nullptr;
    double least_m2 = kReach_m * kReach_m;
    for_each_around(voxel_key(place, kReach_m), [&](VoxelKey key) {
      const auto found = voxels_.find(key);
      if (found == voxels_.end()) return;
      for (const std::size_t i : found->second) {
        const double distance_m2 = (cells_[i].centre - place).squaredNorm();
        if (distance_m2 > least_m2 || cells_[i].normal.dot(normal) < kSameSideCosine) continue;
        least_m2 = distance_m2;
        nearest = &cells_[i];
      }
    });
    return nearest;
  }

 private:
  const std::vector<LabelledCell>& cells_;
  std::unordered_map<VoxelKey, std::vector<std::size_t>, KeyHash> voxels_;
};

}  // namespace

double LabelConfusion::at(Label truth, Label model) const {
  return area_m2[index_of(truth)][index_of(model)];
}

double LabelConfusion::compared_m2() const {
  double sum = 0.0;
  for (const auto& row : area_m2) {
    for (const double area : row) sum += area;
  }
  return sum;
}

double LabelConfusion::right_share() const {
  double right_m2 = 0.0;
  for (const Label label : kLabels) right_m2 += at(label, label);
  const double compared = compared_m2();
  return compared > 0.0 ? right_m2 / compared : 1.0;
}

void LabelConfusion::add(const LabelConfusion& other) {
  for (std::size_t i = 0; i < area_m2.size(); ++i) {
    for (std::size_t k = 0; k < area_m2.size(); ++k) area_m2[i][k] += other.area_m2[i][k];
  }
  no_truth_m2 += other.no_truth_m2;
}

LabelConfusion label_confusion(const std::vector<Plane>& planes,
                               const std::vector<Decision>& labels,
                               const std::vector<LabelledCell>& truth) {
  const LabelIndex index(truth);
  LabelConfusion confusion;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane& plane = planes[i];
    const double cell_m2 = plane.cell_size_m * plane.cell_size_m;
    for (const PlaneCell& cell : plane.cells) {
      const LabelledCell* at = index.nearest(cell_centre(plane, cell), plane.normal);
      (at ? confusion.area_m2[index_of(at->label)][index_of(labels[i].label)]
          : confusion.no_truth_m2) += cell_m2;
    }
  }
  return confusion;
}

}  // namespace ribbon_mapper::eval
