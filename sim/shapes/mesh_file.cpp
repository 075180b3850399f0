// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/shapes/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cctype>
#include <filesystem>
#include <stdexcept>

namespace ribbon_mapper::sim {
namespace {

/// Formats that Gazebo reads, too. In others, assimp 5.2 may abort or hang on a damaged file (PLY,
/// OFF), so that the whole program would end.
bool is_readable(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".dae" || extension == ".obj" || extension == ".stl";
}

void append(const aiMesh& mesh, const aiMatrix4x4& T_file_node, MeshShape& out) {
  const int first = static_cast<int>(out.vertices_m.size());
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D p = T_file_node * mesh.mVertices[i];
    out.vertices_m.emplace_back(p.x, p.y, p.z);
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines have no surface
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

}  // namespace

MeshShape load_mesh(const std::string& path, const MeshSelection& selection) {
  if (!is_readable(path))
    throw std::runtime_error("mesh " + path + ": is read as .dae, .obj or .stl; convert it");
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);  // as Gazebo does
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (!scene || !scene->mRootNode)
    throw std::runtime_error("mesh " + path + ": " + importer.GetErrorString() +
                             "; export it again, as .dae, .obj or .stl");
  MeshShape mesh;
  append(*scene, *scene->mRootNode, aiMatrix4x4(), selection.submesh, mesh);
  if (mesh.triangles.empty())
    throw std::runtime_error(
        "mesh " + path + ": no triangles" +
        (selection.submesh.empty() ? std::string() : " in submesh '" + selection.submesh + "'"));
  if (selection.center_submesh) centre(mesh);
  for (Eigen::Vector3d& p : mesh.vertices_m) p = p.cwiseProduct(selection.scale);
  return mesh;
}

}  // namespace ribbon_mapper::sim
