// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/mesh/mesh_file.hpp"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "modeler/io/colour.hpp"

namespace ribbon_mapper {
namespace {

aiVector3D vector_of(const Eigen::Vector3d& v) {
  const Eigen::Vector3f single = v.cast<float>();
  return {single.x(), single.y(), single.z()};
}

aiMesh* new_mesh(const PlaneMesh& plane, const Eigen::Vector3d& origin, unsigned material) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName = plane.name;
  mesh->mMaterialIndex = material;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = static_cast<unsigned>(plane.vertices.size());
  mesh->mVertices = new aiVector3D[mesh->mNumVertices];
  mesh->mNormals = new aiVector3D[mesh->mNumVertices];
  for (unsigned i = 0; i < mesh->mNumVertices; ++i) {
    mesh->mVertices[i] = vector_of(plane.vertices[i] - origin);
    mesh->mNormals[i] = vector_of(plane.normal);
  }
  mesh->mNumFaces = static_cast<unsigned>(plane.triangles.size());
  mesh->mFaces = new aiFace[mesh->mNumFaces];
  for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
    aiFace& face = mesh->mFaces[i];
    face.mNumIndices = 3;
    face.mIndices = new unsigned[3];
    std::copy(plane.triangles[i].begin(), plane.triangles[i].end(), face.mIndices);
  }
  return mesh.release();
}

aiMaterial* new_material(const PlaneMesh& plane) {
  const Colour colour = plane_colour(plane.plane_id);
  const aiColor4D diffuse(colour.red / 255.0F, colour.green / 255.0F, colour.blue / 255.0F, 1.0F);
  const aiString name(plane.name);
  const int two_sided = 1;
  const float metallic = 0.0F, rough = 1.0F;
  auto material = std::make_unique<aiMaterial>();
  material->AddProperty(&name, AI_MATKEY_NAME);
  material->AddProperty(&diffuse, 1, AI_MATKEY_COLOR_DIFFUSE);
  material->AddProperty(&diffuse, 1, "$clr.base", 0, 0);  // glTF's
  material->AddProperty(&two_sided, 1, AI_MATKEY_TWOSIDED);
  material->AddProperty(&metallic, 1, "$mat.metallicFactor", 0, 0);
  material->AddProperty(&rough, 1, "$mat.roughnessFactor", 0, 0);
  return material.release();
}

aiNode* new_node(const PlaneMesh& plane, unsigned mesh, aiNode* parent) {
  auto node = std::make_unique<aiNode>(plane.name);
  node->mParent = parent;
  node->mNumMeshes = 1;
  node->mMeshes = new unsigned[1]{mesh};
  return node.release();
}

/// Returns a scene of these meshes. The scene owns all that it points to.
std::unique_ptr<aiScene> scene_of(const std::vector<const PlaneMesh*>& planes,
                                  const Eigen::Vector3d& origin) {
  const auto count = static_cast<unsigned>(planes.size());
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode("model");
  scene->mMeshes = new aiMesh* [count] {};
  scene->mMaterials = new aiMaterial* [count] {};
  scene->mRootNode->mChildren = new aiNode* [count] {};
  scene->mNumMeshes = scene->mNumMaterials = scene->mRootNode->mNumChildren = count;
  for (unsigned i = 0; i < count; ++i) {
    scene->mMeshes[i] = new_mesh(*planes[i], origin, i);
    scene->mMaterials[i] = new_material(*planes[i]);
    scene->mRootNode->mChildren[i] = new_node(*planes[i], i, scene->mRootNode);
  }
  return scene;
}

struct FormatOfAssimp {
  const char* id;      // aiExportFormatDesc::id
  const char* suffix;  // of the main file
};

FormatOfAssimp format_of(MeshFormat format) {
  if (format == MeshFormat::gltf) return {"glb2", ".glb"};
  if (format == MeshFormat::obj) return {"obj", ".obj"};
  return {"stlb", ".stl"};
}

/// Returns the main file and those that it refers to. assimp names those in full; before 5.1, by
/// their endings, and it has the main file twice, under a name of its own.
std::vector<MeshFile> files_of(const aiExportDataBlob& blob, const std::string& suffix,
                               const std::string& model) {
  const std::string own_name = "$blobfile";
  std::vector<MeshFile> files;
  std::set<std::string> suffixes;
  for (const aiExportDataBlob* part = &blob; part != nullptr; part = part->next) {
    const std::string name = part->name.C_Str();
    if (name == own_name) continue;
    const std::size_t dot = name.rfind('.');
    const std::string ending = dot == std::string::npos ? "." + name : name.substr(dot);
    const std::string& its = part == &blob ? suffix : ending;
    if (!suffixes.insert(its).second) continue;
    std::string bytes(static_cast<const char*>(part->data), part->size);
    const std::size_t at = its == ".obj" ? bytes.find(own_name) : std::string::npos;
    if (at != std::string::npos) bytes.replace(at, own_name.size(), model);
    files.push_back({its, std::move(bytes)});
  }
  return files;
}

}  // namespace

std::vector<MeshFile> mesh_files(const std::vector<PlaneMesh>& meshes, MeshFormat format,
                                 const std::string& name, const ModelLabel& label) {
  std::vector<const PlaneMesh*> filled;
  for (const PlaneMesh& mesh : meshes) {
    if (!mesh.triangles.empty()) filled.push_back(&mesh);
  }
  if (filled.empty()) return {};
  const std::unique_ptr<aiScene> scene = scene_of(filled, label.origin);
  if (format == MeshFormat::gltf) {
    scene->mRootNode->mTransformation =
        aiMatrix4x4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
  }
  const FormatOfAssimp wanted = format_of(format);
  Assimp::Exporter exporter;
  Assimp::ExportProperties properties;
  properties.SetPropertyString("EXPORT_BLOB_NAME", name);
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), wanted.id, 0, &properties);
  if (blob == nullptr) {
    throw std::runtime_error(name + wanted.suffix +
                             " cannot be made: " + exporter.GetErrorString());
  }
  return files_of(*blob, wanted.suffix, name);
}

}  // namespace ribbon_mapper
