// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts memory allocations per scan line while the robot stands still and observes nothing new.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "eval/experiment/sim_conversion.hpp"
#include "modeler/modeler.hpp"
#include "modeler/program/installed_files.hpp"
#include "modeler/ribbon/ribbon_extraction.hpp"
#include "sim/robot/hokuyo.hpp"
#include "sim/robot/pr2.hpp"
#include "sim/robot/tilt_profile.hpp"
#include "sim/world/world.hpp"

namespace {
std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  // aligned_alloc() requires a size that is a multiple of the alignment.
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace

// NOLINTBEGIN: replaceable allocation functions; the array forms call these.
void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
// NOLINTEND

namespace ribbon_mapper {
namespace {

constexpr int kLinesPerPeriod = 120;
constexpr int kPeriods = 12;  // the first half is not counted

struct Line {
  LaserBeams beams;
  LinePoses poses;
};

/// Returns lines of a robot that stands in the apartment's living room and tilts its laser.
std::vector<Line> standing_lines() {
  const auto world = sim::World::load(find_installed_file("worlds/apartment.sdf").string());
  const Pose T_map_base = planar_pose(-2.1, 1.0, 0.4);
  const sim::TiltProfile tilt{sim::TiltProfileConfig{}};
  const auto T_base_laser = [&](Time time) { return sim::pr2::T_base_laser(tilt.angle_rad(time)); };
  sim::Hokuyo hokuyo(sim::HokuyoConfig{}, 1);
  std::vector<Line> lines;
  for (int i = 0; i < kPeriods * kLinesPerPeriod; ++i) {
    const sim::Scan scan = hokuyo.scan(world, i * hokuyo.period(),
                                       [&](Time time) { return T_map_base * T_base_laser(time); });
    Line& line = lines.emplace_back();
    line.beams = eval::beams_of(scan);
    line.poses.T_odom_base_first = line.poses.T_odom_base_last = T_map_base;
    line.poses.T_map_base = T_map_base;
    line.poses.T_base_laser_first = T_base_laser(line.beams.stamp);
    line.poses.T_base_laser_last = T_base_laser(end_of(line.beams));
  }
  return lines;
}

/// Returns the number of allocations of work(line) for each line of the second half.
template <typename Work>
std::vector<std::size_t> counts_of(const std::vector<Line>& lines, const Work& work) {
  std::vector<std::size_t> counts;
  counts.reserve(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t before = allocations;
    work(lines[i]);
    if (i >= lines.size() / 2) counts.push_back(allocations - before);
  }
  std::size_t sum = 0;
  for (const std::size_t count : counts) sum += count;
  std::printf("allocations per line: mean %.2f, max %zu\n",
              static_cast<double>(sum) / static_cast<double>(counts.size()),
              *std::max_element(counts.begin(), counts.end()));
  return counts;
}

double share_of_allocating(const std::vector<std::size_t>& counts) {
  const auto allocating =
      std::count_if(counts.begin(), counts.end(), [](std::size_t count) { return count > 0; });
  return static_cast<double>(allocating) / static_cast<double>(counts.size());
}

/// Returns a function that adds a line to a buffer and calls work() for each middle line.
template <typename Work>
auto on_middle_lines(LineBuffer& buffer, const Work& work) {
  return [&buffer, work](const Line& line) {
    place_beams(line.beams, line.poses, ScanConfig{}, buffer.incoming());
    buffer.push();
    while (const auto lines = buffer.next_three_lines()) work(*lines);
  };
}

// Due to noise, a line may have more surfels than any line before; a vector then grows once.
constexpr double kSeldom = 0.01;

TEST(Allocations, StopFromBeamsToSurfels) {
  LineBuffer buffer(ScanConfig{}.range_sigma_m);
  std::vector<Surfel> surfels;
  std::size_t made = 0;
  const auto counts =
      counts_of(standing_lines(), on_middle_lines(buffer, [&](const ThreeLines& lines) {
                  estimate_surfels(lines, ScanConfig{}, RibbonConfig{}, surfels);
                  made += surfels.size();
                }));
  ASSERT_GT(made, 10000u);
  EXPECT_LE(share_of_allocating(counts), kSeldom);
}

TEST(Allocations, StopFromBeamsToRibbons) {
  LineBuffer buffer(ScanConfig{}.range_sigma_m);
  RibbonExtraction extraction(ScanConfig{}, RibbonConfig{});
  std::size_t made = 0;
  const auto counts =
      counts_of(standing_lines(), on_middle_lines(buffer, [&](const ThreeLines& lines) {
                  made += extraction.extract(lines).ribbons.size();
                }));
  ASSERT_GT(made, 1000u);
  EXPECT_LE(share_of_allocating(counts), kSeldom);
}

// The model itself grows: now and then its storage is enlarged by a block or by a share. A
// hypothesis that arises from noise allocates lists of its ribbons and of the voxels that it
// touches.
TEST(Allocations, OfTheWholeModelAreThoseOfItsGrowth) {
  const std::vector<Line> lines = standing_lines();
  Modeler modeler(ModelerConfig{});
  const auto counts =
      counts_of(lines, [&](const Line& line) { modeler.add_scan_line(line.beams, line.poses); });
  ASSERT_GT(modeler.statistics().ribbons, 1000u);
  std::size_t sum = 0;
  for (const std::size_t count : counts) sum += count;
  const double mean = static_cast<double>(sum) / static_cast<double>(counts.size());
  std::printf("allocations per line: mean %.2f, %.0f %% of lines allocate\n", mean,
              100.0 * share_of_allocating(counts));
  EXPECT_LT(mean, 1.0);
}

}  // namespace
}  // namespace ribbon_mapper
