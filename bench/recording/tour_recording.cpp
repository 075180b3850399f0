// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/recording/tour_recording.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>

#include "bench/recording/recording_file.hpp"
#include "eval/experiment/sim_conversion.hpp"
#include "modeler/program/installed_files.hpp"
#include "sim/truth/truth.hpp"

namespace ribbon_mapper::bench {
namespace {

RecordedLine recorded(const sim::Scan& scan, const sim::Tour& tour) {
  RecordedLine line;
  line.beams = eval::beams_of(scan);
  line.poses = eval::noisy_poses(tour, line.beams);
  const Time middle = middle_of(line.beams);
  line.T_map_base_true = tour.true_T_map_base(middle);
  line.T_map_odom_true = line.T_map_base_true * tour.T_odom_base(middle).inverse(Eigen::Isometry);
  line.faces.assign(scan.faces.begin(), scan.faces.end());
  return line;
}

Recording driven(const TourSource& source) {
  const sim::World world = sim::World::load(source.world.string());
  sim::Tour tour(world, sim::Route::load(source.route.string()), source.config);
  sim::TruthCollector truth(world);
  Recording recording;
  recording.name = source.name;
  recording.duration_s = to_seconds(tour.duration());
  while (const auto scan = tour.next_scan()) {
    recording.lines.push_back(recorded(*scan, tour));
    truth.add(*scan);
  }
  for (const sim::Face& face : world.faces()) {
    recording.face_normals.push_back(face.planar ? face.normal : Eigen::Vector3d::Zero().eval());
  }
  recording.truth = eval::patches_of(truth.planes());
  return recording;
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

TourSource apartment_tour() {
  TourSource source;
  source.name = "apartment";
  source.world = find_installed_file("worlds/apartment.sdf");
  source.route = find_installed_file("worlds/apartment.route.yaml");
  source.config.localisation.drift = 3.0;  // as in the experiment
  return source;
}

TourSource apartment_tour(int beams) {
  TourSource source = apartment_tour();
  source.name += "_" + std::to_string(beams);
  const double half_rad = 0.5 * (beams - 1) * source.config.hokuyo.angle_increment_rad;
  source.config.hokuyo.angle_min_rad = -half_rad;
  source.config.hokuyo.angle_max_rad = half_rad;
  return source;
}

Recording recording_of(const TourSource& source, const std::filesystem::path& cache) {
  const std::size_t hash = std::hash<std::string>()(text_of(source.world) + text_of(source.route));
  char suffix[32];
  std::snprintf(suffix, sizeof suffix, ".%016zx.tour", hash);
  const auto file = cache / (source.name + suffix);
  if (auto recording = read_recording(file)) return *std::move(recording);
  std::printf("recording the tour %s in %s\n", source.name.c_str(), file.c_str());
  std::fflush(stdout);
  Recording recording = driven(source);
  write_recording(recording, file);
  return recording;
}

}  // namespace ribbon_mapper::bench
