// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "bench/micro.hpp"
#include "bench/rays/rays_peer.hpp"
#include "bench/recording/tour_recording.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"
#include "sim/rays/ray_caster.hpp"
#include "sim/robot/hokuyo.hpp"
#include "sim/robot/pr2.hpp"
#include "sim/sdf/sdf_reader.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr int kLines = 200;
const std::string kSection = "ray casting in the flat, lines of the tour";
const std::string kRayTest = "btCollisionWorld::rayTest, a body for each shape";

/// Lines spread evenly over the tour, with the robot and its tilt in motion.
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
  std::size_t beams() const { return beams_of_a_line() * stamps_.size(); }
  std::size_t beams_of_a_line() const { return static_cast<std::size_t>(hokuyo_.beam_count()); }

  /// Runs the simulator as it is used: with motion, noise and mixed pixels.
  void scan_all(const sim::World& world) {
    for (const Time stamp : stamps_) {
      keep(hokuyo_.scan(world, stamp, [this](Time time) { return T_map_laser(time); }));
    }
  }

  /// Returns the rays of all beams, line by line.
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

RayCasting casting_of(const sim::World& world) {
  return [&world](const std::vector<Ray>& rays, double max_range_m, std::vector<float>& ranges) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto hit = world.cast(rays[i].origin, rays[i].direction, max_range_m);
      ranges[i] = hit ? static_cast<float>(hit->range_m) : std::numeric_limits<float>::infinity();
    }
  };
}

/// Returns how the ranges `a` differ from `b`, those of the same rays by World::cast with Bullet.
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
                "to World::cast, Bullet: %zu of %zu rays differ by 1 mm or more, others %.3f mm",
                apart, a.size(), 1e3 * largest_m);
  return text;
}

/// The world with each ray caster of this build, Bullet first.
struct CasterWorld {
  std::string name;
  sim::World world;
};

std::vector<CasterWorld> worlds_of(const std::string& path) {
  std::vector<CasterWorld> worlds;
  worlds.push_back({"Bullet", sim::World::load(path)});
  if (sim::is_available(sim::RayCasterKind::embree))
    worlds.push_back({"Embree", sim::World::load(path, {}, sim::RayCasterKind::embree)});
  return worlds;
}

std::string scan_row(const CasterWorld& caster) {
  return "ours: Hokuyo::scan, motion and noise on, " + caster.name;
}

/// Sets the ratios of the whole scan with each caster to Bullet's plain ray test.
void set_ratios(const std::map<std::string, double>& ns, const std::vector<CasterWorld>& casters,
                std::size_t beams_of_a_line, Report& report) {
  const double bullet_ns = ns.at(scan_row(casters[0]));
  report.set("rays_vs_raytest", ns.at(kRayTest) / bullet_ns);
  report.set("rays_per_second", 1e9 / bullet_ns);
  report.set("scan_ms", 1e-6 * bullet_ns * static_cast<double>(beams_of_a_line));
  if (casters.size() < 2) return;
  const double embree_ns = ns.at(scan_row(casters[1]));
  report.set("rays_embree_vs_bullet", bullet_ns / embree_ns);
  report.set("rays_per_second_embree", 1e9 / embree_ns);
}

}  // namespace

void measure_rays(const Inputs& /*inputs*/, Report& report) {
  const TourSource source = apartment_tour();
  const std::vector<CasterWorld> casters = worlds_of(source.world.string());
  Lines lines(source);
  const auto rays = lines.rays(source.config.hokuyo.angle_increment_rad);
  const double max_range_m = source.config.hokuyo.range_max_m;
  std::vector<std::pair<std::string, RayCasting>> ways;
  for (const CasterWorld& caster : casters)
    ways.emplace_back("ours: World::cast, " + caster.name, casting_of(caster.world));
  ways.emplace_back(kRayTest,
                    bullet_ray_test(sim::read_sdf(source.world.string(), {}, false).shapes));
  std::vector<std::vector<float>> ranges(ways.size(), std::vector<float>(rays.size()));
  MicroBenchmarks benchmarks;
  for (const CasterWorld& caster : casters)
    benchmarks.add(scan_row(caster), lines.beams(), [&] { lines.scan_all(caster.world); });
  for (std::size_t i = 0; i < ways.size(); ++i)
    benchmarks.add(ways[i].first, rays.size(),
                   [&, i] { ways[i].second(rays, max_range_m, ranges[i]); });
  const auto ns = benchmarks.ns_per_item();
  const auto add = [&](const std::string& row, const std::string& remark) {
    const double row_ns = ns.at(row);
    const double ratio = row_ns / ns.at(scan_row(casters[0]));
    report.add({kSection, row, {}, row_ns, ratio, {}, remark, {{"rays_per_s", 1e9 / row_ns}}});
  };
  for (const CasterWorld& caster : casters) add(scan_row(caster), "");
  for (std::size_t i = 0; i < ways.size(); ++i)
    add(ways[i].first, i > 0 ? differences(ranges[i], ranges[0]) : "");
  set_ratios(ns, casters, lines.beams_of_a_line(), report);
}

}  // namespace ribbon_mapper::bench
