// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/octomap.hpp"

#include <octomap/OcTree.h>

#include <algorithm>
#include <locale>
#include <sstream>

#include "modeler/io/planes_json.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kVoxelSize_m = 0.05;
constexpr double kMaxVoxels = 32000.0;  // from the origin along an axis, with a margin for cells

double voxel_size_m(const std::vector<Plane>& planes, const Eigen::Vector3d& origin) {
  double reach_m = 0.0;
  for (const Plane& plane : planes) {
    const Eigen::AlignedBox3d box = bounding_box(plane);
    if (box.isEmpty()) continue;
    for (const Eigen::Vector3d& corner : {box.min(), box.max()}) {
      reach_m = std::max(reach_m, (corner - origin).cwiseAbs().maxCoeff());
    }
  }
  double size_m = kVoxelSize_m;
  while (reach_m > kMaxVoxels * size_m) size_m *= 2.0;
  return size_m;
}

void occupy(octomap::OcTree& tree, const Eigen::Vector3d& point) {
  constexpr bool kInnerNodesLater = true;
  tree.setNodeValue(octomap::point3d(static_cast<float>(point.x()), static_cast<float>(point.y()),
                                     static_cast<float>(point.z())),
                    tree.getClampingThresMaxLog(), kInnerNodesLater);
}

/// Occupies the voxels of a cell by four points half a cell apart, which leaves no holes in oblique
/// planes.
void occupy(octomap::OcTree& tree, const Plane& plane, const PlaneCell& cell,
            const Eigen::Vector3d& origin) {
  const Eigen::Vector3d centre = cell_centre(plane, cell) - origin;
  const double quarter_m = 0.25 * plane.cell_size_m;
  for (const double du : {-quarter_m, quarter_m}) {
    for (const double dv : {-quarter_m, quarter_m}) {
      occupy(tree, centre + du * plane.axis_u + dv * plane.axis_v);
    }
  }
}

/// Returns the tree of a map, with the states as the limits of OctoMap's log odds.
octomap::OcTree tree_of(const VoxelMap& voxels) {
  constexpr bool kInnerNodesLater = true;
  constexpr int kMiddle = 32768;  // key of the first voxel on the positive side
  octomap::OcTree tree(voxels.voxel_m());
  voxels.for_each([&](const MapVoxel& voxel, VoxelState state) {
    const auto key = [&](std::size_t axis) {
      return static_cast<octomap::key_type>(voxel[axis] + kMiddle);
    };
    tree.setNodeValue(octomap::OcTreeKey(key(0), key(1), key(2)),
                      state == VoxelState::occupied ? tree.getClampingThresMaxLog()
                                                    : tree.getClampingThresMinLog(),
                      kInnerNodesLater);
  });
  tree.updateInnerOccupancy();
  tree.prune();
  return tree;
}

/// Returns the bytes that OcTree::writeBinary() writes, without its messages on stderr.
std::string binary_file(const octomap::OcTree& tree, const ModelLabel& label) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << "# Octomap OcTree binary file\n"
         << label_lines(label, "# ") << "id OcTree\nsize " << tree.size() << "\nres "
         << tree.getResolution() << "\ndata\n";
  tree.writeBinaryData(stream);
  return stream.str();
}

}  // namespace

std::string planes_to_octomap(const std::vector<Plane>& planes, const ModelLabel& label) {
  octomap::OcTree tree(voxel_size_m(planes, label.origin));
  for (const Plane& plane : planes) {
    for (const PlaneCell& cell : plane.cells) occupy(tree, plane, cell, label.origin);
  }
  tree.updateInnerOccupancy();
  tree.toMaxLikelihood();
  tree.prune();
  return binary_file(tree, label);
}

std::string voxels_to_octomap(const VoxelMap& voxels, const ModelLabel& label) {
  return binary_file(tree_of(voxels), label);
}

std::string octomap_data(const VoxelMap& voxels) {
  std::ostringstream stream;
  tree_of(voxels).writeBinaryData(stream);
  return stream.str();
}

}  // namespace ribbon_mapper
