// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the lines of a small room and what C++ makes of them: room_lines PRESET FOLDER.
#include <cstdio>

#include "modeler/io/config_file.hpp"
#include "modeler/io/planes_json.hpp"
#include "modeler/io/tum.hpp"
#include "modeler/model_file/model_file.hpp"
#include "test/modeler/mini_world.hpp"
#include "test/python/lines_file.hpp"

using namespace ribbon_mapper;

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void write_model(const Modeler& modeler, const std::filesystem::path& folder,
                 const std::string& name) {
  const std::vector<Plane> planes = modeler.planes();
  const Semantics semantics = semantics_of(planes, positions_of(modeler.trajectory()));
  const std::vector<const Annotation*> none(planes.size());
  write(folder / (name + ".json"),
        planes_to_json(planes, {}, plane_labels(planes, semantics, none)));
  write(folder / (name + ".tum"), to_tum(modeler.trajectory()));
  save_model_file(modeler, folder / (name + ".ribbons"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: room_lines PRESET FOLDER\n");
    return 2;
  }
  using namespace mini_world;
  const std::filesystem::path folder = argv[2];
  const Lines lines = drive(room(), {around_the_middle, to_and_fro, wandering_drift}, 0.0, 15.0);
  Modeler modeler(load_config(argv[1]));
  LinesFile file(folder / "lines");
  for (const Line& line : lines) {
    file.add(line.beams, line.poses);
    modeler.add_scan_line(line.beams, line.poses);
  }
  write_model(modeler, folder, "recorded");
  const std::vector<StampedPose> truth = true_trajectory(lines);
  write(folder / "truth.tum", to_tum(truth));
  modeler.correct(read_tum(folder / "truth.tum"));
  write_model(modeler, folder, "corrected");
  return 0;
}
