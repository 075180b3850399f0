// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <assimp/mesh.h>

namespace ribbon_mapper {

/// Returns the area of the triangles of a mesh [m2].
inline double triangles_m2(const aiMesh& mesh) {
  double sum = 0.0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const unsigned* corners = mesh.mFaces[i].mIndices;
    const aiVector3D a = mesh.mVertices[corners[0]];
    sum += 0.5 * ((mesh.mVertices[corners[1]] - a) ^ (mesh.mVertices[corners[2]] - a)).Length();
  }
  return sum;
}

}  // namespace ribbon_mapper
