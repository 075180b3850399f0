// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/mesh/mesh_file.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <fstream>
#include <set>

#include "modeler/surface/outline.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/mesh/mesh_area.hpp"

namespace ribbon_mapper {
namespace {

/// Returns a wall of 4 m x 2.5 m at x_m that looks along +x, with a door and a window.
Plane wall(std::int64_t id, double x_m) {
  Plane plane;
  plane.id = id;
  plane.normal = Eigen::Vector3d::UnitX();
  plane.axis_u = Eigen::Vector3d::UnitY(), plane.axis_v = Eigen::Vector3d::UnitZ();
  plane.origin.x() = x_m, plane.d_m = -x_m;
  for (int v = 0; v < 50; ++v) {
    for (int u = 0; u < 80; ++u) {
      const bool door = u >= 10 && u < 26 && v < 40;
      const bool window = u >= 50 && u < 65 && v >= 20 && v < 40;
      if (!door && !window) plane.cells.push_back({u, v, 1, 0.0F, 0.0F});
    }
  }
  plane.area_m2 = static_cast<double>(plane.cells.size()) * 0.05 * 0.05;
  plane.outlines = outlines_of(plane, {});
  return plane;
}

double area_m2(const PlaneMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d ab = mesh.vertices[b] - mesh.vertices[a];
    sum += 0.5 * ab.cross(mesh.vertices[c] - mesh.vertices[a]).dot(mesh.normal);
  }
  return sum;
}

/// What assimp's importer finds in files.
struct Opened {
  std::multiset<std::string> names;  // of the objects
  double area_m2 = 0.0;
  aiVector3D highest{0, 0, 0};
};

void visit(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, Opened& opened) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    opened.names.insert(node.mName.C_Str());
    opened.area_m2 += triangles_m2(mesh);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D place = transform * mesh.mVertices[v];
      for (unsigned axis = 0; axis < 3; ++axis) {
        opened.highest[axis] = std::max(opened.highest[axis], place[axis]);
      }
    }
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    visit(scene, *node.mChildren[i], transform, opened);
}

Opened opened(const std::vector<MeshFile>& files) {
  const TemporaryDirectory directory;
  for (const MeshFile& file : files) {
    std::ofstream(directory.path() / ("flat" + file.suffix), std::ios::binary) << file.bytes;
  }
  Assimp::Importer importer;
  const auto path = directory.path() / ("flat" + files.at(0).suffix);
  const aiScene* scene = importer.ReadFile(path.string(), aiProcess_JoinIdenticalVertices);
  Opened result;
  EXPECT_NE(scene, nullptr) << importer.GetErrorString();
  if (scene != nullptr) visit(*scene, *scene->mRootNode, {}, result);
  return result;
}

TEST(PlaneMesh, HasTheAreaOfTheOutlines) {
  const Plane plane = wall(1, 3.0);
  const PlaneMesh mesh = mesh_of(plane);
  EXPECT_NEAR(area_m2(mesh), plane.area_m2, 1e-9) << "counter-clockwise, without door and window";
  EXPECT_EQ(mesh.name, "plane 1");
  for (const Eigen::Vector3d& vertex : mesh.vertices) EXPECT_DOUBLE_EQ(vertex.x(), 3.0);
}

TEST(PlaneMesh, OfAPlaneWithoutOutlinesIsEmpty) { EXPECT_TRUE(mesh_of(Plane()).triangles.empty()); }

TEST(MeshFile, OpensWithOneObjectPerPlane) {
  const std::vector<Plane> planes{wall(7, 0.0), wall(12, 2.0), wall(400, 5.0)};
  for (const MeshFormat format : {MeshFormat::gltf, MeshFormat::obj}) {
    const Opened result = opened(mesh_files(meshes_of(planes), format, "flat"));
    EXPECT_EQ(result.names, (std::multiset<std::string>{"plane 12", "plane 400", "plane 7"}));
    EXPECT_NEAR(result.area_m2, 3.0 * planes[0].area_m2, 1e-3);
  }
}

TEST(MeshFile, NamesObjectsByIdAndLabel) {
  const auto meshes = meshes_of({wall(7, 0.0), wall(12, 2.0)}, {"wall", "door leaf"});
  for (const MeshFormat format : {MeshFormat::gltf, MeshFormat::obj}) {
    EXPECT_EQ(opened(mesh_files(meshes, format, "flat")).names,
              (std::multiset<std::string>{"plane 12 door leaf", "plane 7 wall"}));
  }
}

TEST(MeshFile, OfStlHasTheArea) {
  const std::vector<Plane> planes{wall(7, 0.0), wall(12, 2.0)};
  const auto files = mesh_files(meshes_of(planes), MeshFormat::stl, "flat");
  EXPECT_NEAR(opened(files).area_m2, 2.0 * planes[0].area_m2, 1e-3);
}

TEST(MeshFile, HasTheFormatsUpAxis) {
  const auto meshes = meshes_of({wall(7, 3.0)});  // 4 m along y, 2.5 m high
  const aiVector3D gltf = opened(mesh_files(meshes, MeshFormat::gltf, "flat")).highest;
  EXPECT_NEAR(gltf.x, 3.0F, 1e-5F);
  EXPECT_NEAR(gltf.y, 2.5F, 1e-5F);
  const aiVector3D obj = opened(mesh_files(meshes, MeshFormat::obj, "flat")).highest;
  EXPECT_NEAR(obj.y, 4.0F, 1e-5F);
  EXPECT_NEAR(obj.z, 2.5F, 1e-5F);
}

TEST(MeshFile, IsNearTheOriginOfTheModel) {
  ModelLabel label;
  label.origin = {5000.0, 0.0, 0.0};
  const auto files = mesh_files(meshes_of({wall(7, 5001.5)}), MeshFormat::stl, "flat", label);
  EXPECT_NEAR(opened(files).highest.x, 1.5F, 1e-5F);
}

TEST(MeshFile, NamesItsMaterials) {
  const auto files = mesh_files(meshes_of({wall(7, 0.0)}), MeshFormat::obj, "flat");
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[1].suffix, ".mtl");
  EXPECT_NE(files[0].bytes.find("mtllib flat.mtl"), std::string::npos);
}

TEST(MeshFile, OfNoPlanesIsNone) {
  EXPECT_TRUE(mesh_files({}, MeshFormat::gltf, "flat").empty());
  EXPECT_TRUE(mesh_files(meshes_of({Plane()}), MeshFormat::obj, "flat").empty());
}

TEST(MeshFile, HasTheSameBytesAgain) {
  const auto meshes = meshes_of({wall(7, 0.0), wall(8, 1.0)});
  for (const MeshFormat format : {MeshFormat::gltf, MeshFormat::obj, MeshFormat::stl}) {
    EXPECT_EQ(mesh_files(meshes, format, "flat").at(0).bytes,
              mesh_files(meshes, format, "flat").at(0).bytes);
  }
}

}  // namespace
}  // namespace ribbon_mapper
