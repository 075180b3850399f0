// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/micro.hpp"
#include "bench/rays/rays_peer.hpp"
#include "bench/recording/tour_recording.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"
#include "sim/robot/hokuyo.hpp"
#include "sim/robot/pr2.hpp"
#include "sim/world/sdf_reader.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr int kLines = 200;
const std::string kSection = "ray casting in the flat, lines of the tour";

/// Lines evenly over the tour, with the robot and its tilt in motion.
class Lines {
 public:
  explicit Lines(const TourSource& source)
      : route_(sim::Route::load(source.route.string())),
        tilt_(source.config.tilt),
        hokuyo_(source.config.hokuyo, 1) {
    for (int i = 0; i < kLines; ++i) stamps_.push_back(i * (route_.duration() / kLines));
  }

  Pose T_map_laser(Time time) const {
    return sim::pr2::T_map_laser(route_.T_map_base(time), tilt_.angle_rad(time));
  }
  std::size_t beams() const { return stamps_.size() * hokuyo_.beam_count(); }

  /// The simulator as it is used: motion, noise, mixed pixels.
  void scan_all(const sim::World& world) {
    for (const Time stamp : stamps_) {
      keep(hokuyo_.scan(world, stamp, [this](Time time) { return T_map_laser(time); }));
    }
  }

  std::vector<Ray> rays(double angle_increment_rad) const {
    std::vector<Ray> rays;
    for (const Time stamp : stamps_) {
      for (int i = 0; i < hokuyo_.beam_count(); ++i) {
        const Pose T = T_map_laser(stamp + hokuyo_.beam_time(i));
        const double angle = hokuyo_.angle_min_rad() + i * angle_increment_rad;
        rays.push_back(
            {T.translation(), T.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0)});
      }
    }
    return rays;
  }

 private:
  sim::Route route_;
  sim::TiltProfile tilt_;
  sim::Hokuyo hokuyo_;
  std::vector<Time> stamps_;
};

RayCasting ours(const sim::World& world) {
  return [&world](const std::vector<Ray>& rays, double max_range_m, std::vector<float>& ranges) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto hit = world.cast(rays[i].origin, rays[i].direction, max_range_m);
      ranges[i] = hit ? static_cast<float>(hit->range_m) : std::numeric_limits<float>::infinity();
    }
  };
}

RayCasting ours_by_line(const sim::World& world) {
  return [&world](const std::vector<Ray>& rays, double max_range_m, std::vector<float>& ranges) {
    const auto hits = world.cast_line(rays, max_range_m);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ranges[i] =
          hits[i] ? static_cast<float>(hits[i]->range_m) : std::numeric_limits<float>::infinity();
    }
  };
}

/// How two ways to cast the same rays differ.
std::string differences(const std::vector<float>& a, const std::vector<float>& b) {
  double largest_m = 0.0;
  std::size_t apart = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference_m = a[i] == b[i] ? 0.0 : std::abs(a[i] - b[i]);
    if (difference_m < 0.001)
      largest_m = std::max(largest_m, difference_m);
    else
      ++apart;
  }
  char text[128];
  std::snprintf(text, sizeof text,
                "to World::cast: %zu of %zu rays differ by 1 mm or more, others %.3f mm", apart,
                a.size(), 1e3 * largest_m);
  return text;
}

}  // namespace

void measure_rays(const Inputs& /*inputs*/, Report& report) {
  const TourSource source = apartment_tour();
  const sim::World world = sim::World::load(source.world.string());
  Lines lines(source);
  const auto rays = lines.rays(source.config.hokuyo.angle_increment_rad);
  const double max_range_m = source.config.hokuyo.range_max_m;
  const std::vector<std::pair<std::string, RayCasting>> ways{
      {"ours: World::cast, ray by ray", ours(world)},
      {"btCollisionWorld::rayTest, a body for each shape",
       bullet_ray_test(sim::read_sdf(source.world.string(), {}))},
      {"Embree rtcIntersect1, high quality", embree(world.triangles())},
      {"ours: World::cast_line", ours_by_line(world)}};
  const std::string whole = "ours: Hokuyo::scan, motion and noise on";
  std::vector<std::vector<float>> ranges(ways.size(), std::vector<float>(rays.size()));
  MicroBenchmarks benchmarks;
  benchmarks.add(whole, lines.beams(), [&] { lines.scan_all(world); });
  for (std::size_t i = 0; i < ways.size(); ++i) {
    benchmarks.add(ways[i].first, rays.size(),
                   [&, i] { ways[i].second(rays, max_range_m, ranges[i]); });
  }
  const auto ns = benchmarks.ns_per_item();
  const double ours_ns = ns.at(whole);
  report.add({kSection, whole, {}, ours_ns, 1.0, {}, "", {{"rays_per_s", 1e9 / ours_ns}}});
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const double row_ns = ns.at(ways[i].first);
    report.add({kSection,
                ways[i].first,
                {},
                row_ns,
                row_ns / ours_ns,
                {},
                i > 0 ? differences(ranges[i], ranges[0]) : "",
                {{"rays_per_s", 1e9 / row_ns}}});
  }
  report.set("rays_vs_raytest", ns.at(ways[1].first) / ours_ns);
  report.set("rays_vs_embree", ns.at(ways[2].first) / ours_ns);
  report.set("rays_per_second", 1e9 / ours_ns);
}

}  // namespace ribbon_mapper::bench
