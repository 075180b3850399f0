// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "modeler/io/model_label.hpp"
#include "modeler/maps/model_maps.hpp"
#include "modeler/storage/file_set.hpp"

namespace ribbon_mapper {

/// Converts a level map to an image as map_server reads it: free cells are 254, occupied ones 0,
/// unknown ones 205. The first row is that of the largest y. A comment states the label's run.
std::string navigation_map_to_pgm(const NavigationMap& map, const ModelLabel& label = {});

/// Converts the rest of a level map to map_server's YAML, which names the image's file.
std::string navigation_map_to_yaml(const NavigationMap& map, const std::string& image,
                                   const ModelLabel& label = {});

/// Adds three files to a set: the image <name>.pgm and <name>.yaml of the level map, and the
/// OctoMap <name>.bt of free and occupied space. Throws as FileSet::add().
void add_maps(const ModelMaps& maps, const ModelLabel& label, const std::string& name,
              FileSet& files);

}  // namespace ribbon_mapper
