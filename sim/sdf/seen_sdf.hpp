// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sim/sdf/sdf_notes.hpp"
#include "sim/sdf/sdf_state.hpp"

namespace ribbon_mapper::sim {

/// Name of the element of a model, link or collision that says what it is: "wall", for example.
/// SDF leaves such names to others
/// (http://sdformat.org/tutorials?tut=custom_elements_attributes_proposal).
constexpr const char* kLabelElement = "ribbon_mapper:label";

/// What a laser sees of an SDF file.
struct SeenSdf {
  std::string xml;  ///< SDF as new as the library reads, up to 1.9: a world of models with links,
                    ///< collisions and frames, no more
  SdfState state;   ///< where models and links are instead
  SdfNotes notes;   ///< what is not in `xml`
};

/// Reads an SDF file and all models that it includes, and leaves out what no laser sees. Models
/// without a collision are taken from their visuals if `visuals` is true. As Gazebo does, renames
/// elements of equal names and knows model://sun and model://ground_plane. URIs of meshes become
/// paths. They and includes are looked up beside the file that holds them, beside the world, then
/// in `model_paths`. Throws std::runtime_error that names file, line, model and what to do.
SeenSdf seen_sdf(const std::string& path, const std::vector<std::string>& model_paths,
                 bool visuals);

}  // namespace ribbon_mapper::sim
