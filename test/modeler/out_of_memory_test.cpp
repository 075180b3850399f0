// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every allocation may fail: what has the strong guarantee is then unchanged and can be used on.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "modeler/observations/observations.hpp"
#include "test/modeler/association/scene.hpp"
#include "test/modeler/plane_matchers.hpp"

namespace {

long allocations_left = -1;  // negative: any number

}  // namespace

void* operator new(std::size_t size) {
  if (allocations_left == 0) throw std::bad_alloc();
  if (allocations_left > 0) --allocations_left;
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (allocations_left == 0) return nullptr;
  if (allocations_left > 0) --allocations_left;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new[](std::size_t size) { return operator new(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace ribbon_mapper {
namespace {

using namespace mini_world;

/// Calls `work` with memory for so many allocations. Returns whether that was enough.
template <typename Work>
bool succeeds_with(long allocations, const Work& work) {
  allocations_left = allocations;
  try {
    work();
    allocations_left = -1;
    return true;
  } catch (const std::bad_alloc&) {
    allocations_left = -1;
    return false;
  }
}

TrackedPose pose_of(std::size_t i) {
  const Pose T_map_base = planar_pose(0.1 * static_cast<double>(i), 0.0, 0.0);
  return {{from_seconds(1.0 + static_cast<double>(i)), T_map_base}, T_map_base};
}

LineObservations line_of(std::size_t ribbons) {
  LineObservations line;
  for (std::size_t i = 0; i < ribbons; ++i) {
    const Eigen::Vector3d begin(0.0, static_cast<double>(i), 0.0);
    line.ribbons.push_back(
        ribbon_between(begin, begin + Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()));
  }
  return line;
}

/// Returns all that can be seen of observations.
std::string state_of(const Observations& observations) {
  std::string state = std::to_string(observations.unassigned().size());
  const PosedObservations posed = observations.posed();
  for (std::size_t i = 0; i < posed.ribbon_count(); ++i) {
    const PosedRibbon ribbon = posed.ribbon(i);
    double samples = 0.0;
    ribbon.samples().for_each(
        [&](float along, float height, std::uint32_t n) { samples += along + height + n; });
    state += " " + std::to_string(ribbon.centroid.sum()) + " " + std::to_string(samples);
  }
  return state;
}

TEST(OutOfMemory, ALineIsAddedAsAWholeOrNot) {
  Observations observations({});
  const LineObservations line = line_of(20);
  long failures = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    if (i == 30) observations.correct({{pose_of(0).in_map.stamp, planar_pose(0.0, 1.0, 0.0)}});
    const std::string before = state_of(observations);
    for (long n = 0; !succeeds_with(n, [&] { observations.add_line(pose_of(i), line); }); ++n) {
      ++failures;
      ASSERT_EQ(before, state_of(observations));
      ASSERT_EQ(i, observations.trajectory().size());
      ASSERT_EQ(i, observations.trajectory().recorded().stamps().size());
    }
    ASSERT_EQ(i + 1, observations.trajectory().poses().size());
    ASSERT_EQ(20 * (i + 1), observations.ribbons().size());
  }
  EXPECT_GT(failures, 20);
}

TEST(OutOfMemory, ThinningIsDoneOrNot) {
  Observations observations({});
  for (std::size_t i = 0; i < 60; ++i) observations.add_line(pose_of(i), line_of(20));
  const std::string before = state_of(observations);
  long n = 0;
  for (; !succeeds_with(n, [&] { observations.thin(600); }); ++n) {
    ASSERT_EQ(before, state_of(observations)) << "allocation " << n;
  }
  EXPECT_GT(n, 10);
  EXPECT_EQ(600u, observations.ribbons().size());
  observations.add_line(pose_of(60), line_of(20));
  EXPECT_EQ(620u, observations.ribbons().size());
}

Lines short_tour() {
  return drive(room(), {around_the_middle, to_and_fro, wandering_drift}, 0.0, 3.0);
}

/// Corrects `modeler` with less memory than it needs, then with enough, and expects what `other`, a
/// model of the same, then is.
void expect_done_or_not(const std::vector<StampedPose>& trajectory, Modeler& modeler,
                        Modeler& other) {
  const std::string before = bytes_of(modeler.planes());
  const std::size_t revision = modeler.statistics().revision;
  long failures = 0;
  for (long n = 0; !succeeds_with(n, [&] { modeler.correct(trajectory); }); n += 1 + n / 4) {
    ++failures;
    ASSERT_EQ(before, bytes_of(modeler.planes())) << "allocation " << n;
    ASSERT_EQ(revision, modeler.statistics().revision);
  }
  EXPECT_GT(failures, 10);
  other.correct(trajectory);
  EXPECT_EQ(bytes_of(other.planes()), bytes_of(modeler.planes()));
}

TEST(OutOfMemory, ACorrectionIsDoneOrNot) {
  const Lines lines = short_tour();
  Modeler modeler = model_of(lines), other = model_of(lines);
  expect_done_or_not(true_trajectory(lines, 20), modeler, other);
}

TEST(OutOfMemory, ARevisionIsDoneOrNot) {
  const Lines lines = short_tour();
  ModelerConfig config;
  config.association.checkpoint_ribbons = 8;
  Modeler modeler = model_of(lines, config), other = model_of(lines, config);
  std::vector<StampedPose> trajectory = true_trajectory(lines);
  modeler.correct(trajectory);
  other.correct(trajectory);
  for (std::size_t i = lines.size() - 30; i < lines.size(); ++i) {
    Pose& pose = trajectory[i].T_map_base;
    pose = pose * planar_pose(0.01, 0.0, 0.002);
  }
  const std::size_t associated = modeler.statistics().associated_again;
  expect_done_or_not(trajectory, modeler, other);
  EXPECT_LT(modeler.statistics().associated_again - associated, modeler.statistics().ribbons / 2);
}

}  // namespace
}  // namespace ribbon_mapper
