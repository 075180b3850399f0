// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints what assimp's importer finds in a mesh file: a line for each object with its area [m2] and
// its name.

#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstdio>

#include "test/mesh/mesh_area.hpp"

namespace {

void print(const aiScene& scene, const aiNode& node) {
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    std::printf("%.6f %s\n", ribbon_mapper::triangles_m2(*scene.mMeshes[node.mMeshes[i]]),
                node.mName.C_Str());
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) print(scene, *node.mChildren[i]);
}

}  // namespace

int main(int argc, char** argv) {
  Assimp::Importer importer;
  const aiScene* scene = argc == 2 ? importer.ReadFile(argv[1], 0) : nullptr;
  if (scene == nullptr) {
    std::fprintf(stderr, "usage: mesh_areas FILE. %s\n", importer.GetErrorString());
    return 1;
  }
  print(*scene, *scene->mRootNode);
  return 0;
}
