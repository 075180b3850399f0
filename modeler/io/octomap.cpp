// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/octomap.hpp"

#include <octomap/OcTree.h>

#include <sstream>

namespace ribbon_mapper {
namespace {

constexpr double kVoxelSize_m = 0.05;

void occupy(octomap::OcTree& tree, const Eigen::Vector3d& point) {
  constexpr bool kInnerNodesLater = true;
  tree.setNodeValue(octomap::point3d(static_cast<float>(point.x()), static_cast<float>(point.y()),
                                     static_cast<float>(point.z())),
                    tree.getClampingThresMaxLog(), kInnerNodesLater);
}

/// Occupies the voxels of a cell by four points half a cell apart, which leaves no holes in oblique
/// planes.
void occupy(octomap::OcTree& tree, const Plane& plane, const PlaneCell& cell) {
  const Eigen::Vector3d centre = cell_centre(plane, cell);
  const double quarter_m = 0.25 * plane.cell_size_m;
  for (const double du : {-quarter_m, quarter_m}) {
    for (const double dv : {-quarter_m, quarter_m}) {
      occupy(tree, centre + du * plane.axis_u + dv * plane.axis_v);
    }
  }
}

/// Returns the bytes that OcTree::writeBinary() writes, without its messages on stderr.
std::string binary_file(const octomap::OcTree& tree) {
  std::ostringstream stream;
  stream << "# Octomap OcTree binary file\nid OcTree\nsize " << tree.size() << "\nres "
         << tree.getResolution() << "\ndata\n";
  tree.writeBinaryData(stream);
  return stream.str();
}

}  // namespace

std::string planes_to_octomap(const std::vector<Plane>& planes) {
  octomap::OcTree tree(kVoxelSize_m);
  for (const Plane& plane : planes) {
    for (const PlaneCell& cell : plane.cells) occupy(tree, plane, cell);
  }
  tree.updateInnerOccupancy();
  tree.toMaxLikelihood();
  tree.prune();
  return binary_file(tree);
}

}  // namespace ribbon_mapper
