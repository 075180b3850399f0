// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/shapes/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "sim/shapes/child_process.hpp"

namespace ribbon_mapper::sim {
namespace {

// assimp 5.2 aborts, crashes or hangs on some damaged files (DAE, PLY, OFF), hence a child process.
// A megabyte takes it well below a second.
constexpr std::uintmax_t kMostCpu_s = 2, kBytesPerSecond = 1'000'000;

void append(const aiMesh& mesh, const aiMatrix4x4& T_file_node, MeshShape& out) {
  const int first = static_cast<int>(out.vertices_m.size());
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D p = T_file_node * mesh.mVertices[i];
    out.vertices_m.emplace_back(p.x, p.y, p.z);
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines have no surface
    for (int corner = 0; corner < 3; ++corner)
      if (face.mIndices[corner] >= mesh.mNumVertices)
        throw std::runtime_error("a triangle has a vertex that is not there");
    out.triangles.push_back({first + static_cast<int>(face.mIndices[0]),
                             first + static_cast<int>(face.mIndices[1]),
                             first + static_cast<int>(face.mIndices[2])});
  }
}

void append(const aiScene& scene, const aiNode& node, const aiMatrix4x4& T_file_parent,
            const std::string& submesh, MeshShape& out) {
  const aiMatrix4x4 T_file_node = T_file_parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    if (submesh.empty() || submesh == mesh.mName.C_Str() || submesh == node.mName.C_Str())
      append(mesh, T_file_node, out);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    append(scene, *node.mChildren[i], T_file_node, submesh, out);
}

void centre(MeshShape& mesh) {
  Eigen::Vector3d low = mesh.vertices_m.front(), high = low;
  for (const Eigen::Vector3d& p : mesh.vertices_m) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (Eigen::Vector3d& p : mesh.vertices_m) p -= (low + high) / 2.0;
}

MeshShape parsed(const std::string& path, const MeshSelection& selection) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);  // as Gazebo does
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) throw std::runtime_error(importer.GetErrorString());
  MeshShape mesh;
  append(*scene, *scene->mRootNode, aiMatrix4x4(), selection.submesh, mesh);
  if (mesh.triangles.empty())
    throw std::runtime_error("no triangles" + (selection.submesh.empty()
                                                   ? std::string()
                                                   : " in submesh '" + selection.submesh + "'"));
  if (selection.center_submesh) centre(mesh);
  for (Eigen::Vector3d& p : mesh.vertices_m) p = p.cwiseProduct(selection.scale);
  return mesh;
}

template <typename Item>
void append_bytes(const std::vector<Item>& items, std::string& bytes) {
  const std::size_t count = items.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(items.data()), count * sizeof(Item));
}

template <typename Item>
std::vector<Item> items_from(const char*& bytes) {
  std::size_t count = 0;
  std::memcpy(&count, bytes, sizeof count);
  std::vector<Item> items(count);
  std::memcpy(static_cast<void*>(items.data()), bytes + sizeof count, count * sizeof(Item));
  bytes += sizeof count + count * sizeof(Item);
  return items;
}

std::string to_bytes(const MeshShape& mesh) {
  std::string bytes;
  append_bytes(mesh.vertices_m, bytes);
  append_bytes(mesh.triangles, bytes);
  return bytes;
}

MeshShape from_bytes(const std::string& bytes) {
  const char* at = bytes.data();
  MeshShape mesh;
  mesh.vertices_m = items_from<Eigen::Vector3d>(at);
  mesh.triangles = items_from<std::array<int, 3>>(at);
  return mesh;
}

}  // namespace

MeshShape load_mesh(const std::string& path, const MeshSelection& selection) {
  const auto limit_s =
      static_cast<unsigned>(kMostCpu_s + std::filesystem::file_size(path) / kBytesPerSecond);
  try {
    return from_bytes(result_of_child([&] { return to_bytes(parsed(path, selection)); }, limit_s));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("mesh " + path + ": " + error.what() +
                             "; export it again, as .dae, .obj or .stl");
  }
}

}  // namespace ribbon_mapper::sim
