// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map_files/map_files.hpp"

#include <gmock/gmock.h>
#include <octomap/OcTree.h>

#include <memory>
#include <sstream>

#include "modeler/io/octomap.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;

NavigationMap three_by_two() {
  NavigationMap map;
  map.cell_m = 0.05;
  map.corner_m = {-1.25, 2.0};
  map.width = 3;
  map.height = 2;
  map.cells = {0,  100, -1,  // the lower row
               -1, -1,  0};
  return map;
}

/// A solid cube of 32^3 voxels, free but for one occupied face.
VoxelMap cube(const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) {
  VoxelGrid grid;
  for (int x = -16; x < 16; ++x) {
    for (int y = -16; y < 16; ++y) {
      for (int z = -16; z < 16; ++z) {
        grid.at({x, y, z}) =
            static_cast<std::uint8_t>(x == 15 ? VoxelState::occupied : VoxelState::free);
      }
    }
  }
  return {0.05, origin, std::move(grid)};
}

TEST(MapFiles, TheImageBeginsWithTheLargestY) {
  const std::string image = navigation_map_to_pgm(three_by_two());
  ASSERT_GT(image.size(), 6U);
  EXPECT_EQ(image.substr(0, 3), "P5\n");
  EXPECT_THAT(image, HasSubstr("\n3 2\n255\n"));
  const char u = static_cast<char>(205), f = static_cast<char>(254), o = 0;
  EXPECT_EQ(image.substr(image.size() - 6), (std::string{u, u, f, f, o, u}));
}

TEST(MapFiles, TheYamlHasAllKeysOfMapServer) {
  EXPECT_EQ(navigation_map_to_yaml(three_by_two(), "kitchen.pgm"),
            "image: kitchen.pgm\nresolution: 0.05\norigin: [-1.25, 2, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\nmode: trinary\n");
}

TEST(MapFiles, OctomapReadsFreeOccupiedAndUnknown) {
  std::istringstream file(voxels_to_octomap(cube()));
  octomap::OcTree tree(0.1);
  ASSERT_TRUE(tree.readBinary(file));
  EXPECT_DOUBLE_EQ(tree.getResolution(), 0.05);
  std::size_t occupied = 0, free = 0;
  for (int x = -20; x < 20; ++x) {
    for (int y = -20; y < 20; ++y) {
      for (int z = -20; z < 20; ++z) {
        const octomap::OcTreeNode* node =
            tree.search(0.05 * (x + 0.5), 0.05 * (y + 0.5), 0.05 * (z + 0.5));
        if (node == nullptr) continue;
        ++(tree.isNodeOccupied(node) ? occupied : free);
        EXPECT_EQ(tree.isNodeOccupied(node), x == 15);
      }
    }
  }
  EXPECT_EQ(occupied, 32U * 32U);
  EXPECT_EQ(free, 31U * 32U * 32U);
  EXPECT_LT(tree.size(), 32U * 32U * 32U / 4U) << "equal voxels are not pruned";
}

TEST(MapFiles, TheDataOfAMessageAreThoseOfTheFile) {
  const std::string file = voxels_to_octomap(cube()), data = octomap_data(cube());
  ASSERT_GT(file.size(), data.size());
  EXPECT_EQ(file.substr(file.size() - data.size()), data);
  EXPECT_EQ(file.substr(file.size() - data.size() - 5, 5), "data\n");
}

TEST(MapFiles, AreASetThatNamesRunAndOrigin) {
  const TemporaryDirectory directory;
  FileSet files(directory.path(), "kitchen_map");
  ModelLabel label;
  label.run = "0123456789abcdef";
  add_maps({cube({1000.0, 0.0, -2000.0}), three_by_two()}, label, "kitchen_map", files);
  EXPECT_EQ(files.commit().size(), 3U);
  EXPECT_THAT(content_of(directory.path() / "kitchen_map.pgm"),
              HasSubstr("# run 0123456789abcdef"));
  EXPECT_THAT(content_of(directory.path() / "kitchen_map.yaml"),
              HasSubstr("image: kitchen_map.pgm"));
  EXPECT_THAT(content_of(directory.path() / "kitchen_map.bt"), HasSubstr("# origin 1000 0 -2000"));
}

}  // namespace
}  // namespace ribbon_mapper
