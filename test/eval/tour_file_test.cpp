// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the model file of the apartment's tour takes: on the disk, and to be loaded.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "eval/experiment/sim_conversion.hpp"
#include "modeler/io/config_file.hpp"
#include "modeler/io/planes_json.hpp"
#include "modeler/model_file/model_file.hpp"
#include "sim/tour/tour.hpp"

namespace ribbon_mapper::eval {
namespace {

template <typename Work>
double cpu_seconds_of(const Work& work) {
  const auto now = [] {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

class TourFile : public testing::Test {
 protected:
  TourFile()
      : world(sim::World::load(PROJECT_DIR "/worlds/apartment.sdf", {})),
        tour(world, sim::Route::load(PROJECT_DIR "/worlds/apartment.route.yaml"), {}),
        modeler(load_config(PROJECT_DIR "/config/simulation.yaml")) {
    while (const auto scan = tour.next_scan()) {
      const LaserBeams beams = beams_of(*scan);
      const LinePoses poses = noisy_poses(tour, beams);
      modelling_s += cpu_seconds_of([&] { modeler.add_scan_line(beams, poses); });
      range_bytes += beams.ranges_m.size() * sizeof(float);
    }
  }
  std::vector<StampedPose> truth() const {
    std::vector<StampedPose> poses = modeler.trajectory();
    for (StampedPose& pose : poses) pose.T_map_base = tour.true_T_map_base(pose.stamp);
    return poses;
  }

  sim::World world;
  sim::Tour tour;
  Modeler modeler;
  double modelling_s = 0.0;
  std::size_t range_bytes = 0;
};

TEST_F(TourFile, IsSmallQuickAndExact) {
  const std::string bytes = to_model_file(modeler);
  EXPECT_LE(bytes.size(), 2 * range_bytes);
  double loading_s = 1e9;
  std::optional<Modeler> loaded;
  for (int i = 0; i < 3; ++i) {
    loading_s = std::min(loading_s, cpu_seconds_of([&] {
                           ModelFile file = from_model_file(bytes);
                           loaded.emplace(file.config, std::move(file.model));
                         }));
  }
  EXPECT_LE(10.0 * loading_s, modelling_s);
  EXPECT_EQ(bytes, to_model_file(*loaded));
  modeler.correct(truth());
  loaded->correct(truth());
  EXPECT_EQ(22u, loaded->planes().size());
  EXPECT_EQ(planes_to_json(modeler.planes()), planes_to_json(loaded->planes()));
  EXPECT_EQ(to_model_file(modeler), to_model_file(*loaded));
  EXPECT_LE(to_model_file(modeler).size(), 2 * range_bytes);
  RecordProperty("bytes_per_range_byte", std::to_string(static_cast<double>(bytes.size()) /
                                                        static_cast<double>(range_bytes)));
  RecordProperty("modelling_per_loading", std::to_string(modelling_s / loading_s));
}

}  // namespace
}  // namespace ribbon_mapper::eval
