// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map_files/map_files.hpp"

#include <locale>
#include <sstream>

#include "modeler/io/octomap.hpp"

namespace ribbon_mapper {
namespace {

char pixel_of(std::int8_t cell) {
  constexpr unsigned char kFree = 254, kOccupied = 0, kUnknown = 205;
  if (cell == NavigationMap::kFree) return static_cast<char>(kFree);
  return static_cast<char>(cell == NavigationMap::kOccupied ? kOccupied : kUnknown);
}

}  // namespace

std::string navigation_map_to_pgm(const NavigationMap& map, const ModelLabel& label) {
  std::string image = "P5\n# ribbon_mapper, " + in_one_line(label.frame) + "\n" +
                      label_lines(label, "# ") + std::to_string(map.width) + " " +
                      std::to_string(map.height) + "\n255\n";
  image.reserve(image.size() + map.cells.size());
  for (std::size_t row = map.height; row-- > 0;) {
    for (std::size_t i = row * map.width; i < (row + 1) * map.width; ++i) {
      image += pixel_of(map.cells[i]);
    }
  }
  return image;
}

std::string navigation_map_to_yaml(const NavigationMap& map, const std::string& image,
                                   const ModelLabel& label) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(15);
  text << label_lines(label, "# ") << "image: " << image << "\nresolution: " << map.cell_m
       << "\norigin: [" << map.corner_m.x() << ", " << map.corner_m.y()
       << ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\nmode: trinary\n";
  return text.str();
}

void add_maps(const ModelMaps& maps, const ModelLabel& label, const std::string& name,
              FileSet& files) {
  ModelLabel with_origin = label;
  with_origin.origin = maps.voxels.origin();
  files.add(name + ".pgm", navigation_map_to_pgm(maps.level, label));
  files.add(name + ".yaml", navigation_map_to_yaml(maps.level, name + ".pgm", label));
  files.add(name + ".bt", voxels_to_octomap(maps.voxels, with_origin));
}

}  // namespace ribbon_mapper
