// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A correction that leaves the first lines where they are costs less, and gives the same bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "modeler/modeler.hpp"
#include "test/modeler/plane_matchers.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

constexpr int kCheckpointRibbons = 32;  // a short tour has few ribbons

ModelerConfig config_with(int checkpoint_ribbons, int max_ribbons = 0) {
  ModelerConfig config;
  config.association.checkpoint_ribbons = checkpoint_ribbons;
  config.observations.max_ribbons = max_ribbons;
  return config;
}

const Lines& drifting_tour() {
  static const Lines lines =
      drive(room(), {around_the_middle, to_and_fro, wandering_drift}, 0.0, 15.0);
  return lines;
}

/// Two models of the same lines and corrections: with and without checkpoints.
class Pair {
 public:
  explicit Pair(int max_ribbons)
      : with_(config_with(kCheckpointRibbons, max_ribbons)),
        without_(config_with(0, max_ribbons)) {}

  void add_lines(std::size_t count) {
    for (; count > 0 && next_ < drifting_tour().size(); --count, ++next_) {
      const Line& line = drifting_tour()[next_];
      with_.add_scan_line(line.beams, line.poses);
      without_.add_scan_line(line.beams, line.poses);
      sent_.push_back(true_trajectory({line}).front());
    }
  }
  /// Moves the poses of [first, end), each by a different amount, and corrects both models.
  void revise(std::size_t first, std::size_t end, std::mt19937& random) {
    std::normal_distribution<double> normal(0.0, 0.01);
    for (std::size_t i = first; i < end; ++i) {
      Pose& pose = sent_[i].T_map_base;
      pose = pose * planar_pose(normal(random), normal(random), 0.2 * normal(random));
    }
    with_.correct(sent_);
    without_.correct(sent_);
  }
  void reset() {
    with_.reset(), without_.reset();
    sent_.clear();
  }
  void expect_equal() const {
    ASSERT_EQ(bytes_of(without_.planes_as_built()), bytes_of(with_.planes_as_built()));
    ASSERT_EQ(bytes_of(without_.planes()), bytes_of(with_.planes()));
    ASSERT_EQ(without_.statistics().revision, with_.statistics().revision);
  }
  std::size_t lines() const { return sent_.size(); }
  const Modeler& with() const { return with_; }
  const Modeler& without() const { return without_; }
  const std::vector<StampedPose>& sent() const { return sent_; }

 private:
  Modeler with_, without_;
  std::size_t next_ = 0;
  std::vector<StampedPose> sent_;  // the latest corrected trajectory, one pose for each line
};

std::size_t up_to(std::size_t most, std::mt19937& random) {
  return std::uniform_int_distribution<std::size_t>(1, most)(random);
}

/// Makes a random change of lines or trajectory.
void change(Pair& models, std::mt19937& random) {
  const std::size_t lines = models.lines();
  switch (up_to(8, random)) {
    case 1:
      return models.add_lines(up_to(60, random));
    case 2:
      return models.revise(0, lines, random);
    case 3:
      return models.revise(0, 1, random);
    case 4:
      return models.revise(lines, lines, random);  // the same, with the lines since then
    default:
      return models.revise(lines - up_to(lines / 2, random), lines, random);
  }
}

void expect_equal_to_clean_build(const Pair& models) {
  Modeler clean(config_with(0));
  for (std::size_t i = 0; i < models.lines(); ++i) {
    clean.add_scan_line(drifting_tour()[i].beams, drifting_tour()[i].poses);
  }
  clean.correct(models.sent());
  EXPECT_EQ(bytes_of(anonymous(clean.planes())), bytes_of(anonymous(models.with().planes())));
}

class Revision : public testing::TestWithParam<unsigned> {};

TEST_P(Revision, EqualsAWholeCorrectionToTheByte) {
  std::mt19937 random(GetParam());
  const bool is_thinned = GetParam() % 5 == 0, is_reset = GetParam() % 5 == 1;
  Pair models(is_thinned ? 500 : 0);
  if (is_reset) {
    models.add_lines(100);
    models.revise(0, 50, random);
    models.reset();
  }
  models.add_lines(150 + up_to(200, random));
  for (int i = 0; i < 8; ++i) {
    change(models, random);
    models.expect_equal();
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(is_thinned, models.with().statistics().thinned > 0);
  EXPECT_LE(models.with().statistics().associated_again,
            models.without().statistics().associated_again);
  if (is_thinned || is_reset) return;
  models.revise(models.lines() - 20, models.lines(), random);
  expect_equal_to_clean_build(models);
}

INSTANTIATE_TEST_SUITE_P(Random, Revision, testing::Range(0u, 50u));

/// Returns the number of ribbons that a revision of the last lines has associated again.
std::size_t associated_by_revision(std::size_t lines, Pair& models, std::mt19937& random) {
  const std::size_t before = models.with().statistics().associated_again;
  models.revise(models.lines() - lines, models.lines(), random);
  return models.with().statistics().associated_again - before;
}

TEST(Revisions, AssociateWhatMovedAndHalfAsMuchAgainAtMost) {
  Pair models(0);
  std::mt19937 random(1);
  models.add_lines(600);
  EXPECT_EQ(models.with().statistics().ribbons, associated_by_revision(600, models, random));
  EXPECT_EQ(0u, associated_by_revision(0, models, random));
  const std::vector<Ribbon>& ribbons = models.with().ribbons();
  for (const std::size_t lines : {5, 20, 80, 200, 400}) {
    const Time first = models.sent()[models.lines() - lines].stamp;
    const auto trajectory = models.with().trajectory();
    const auto moved = static_cast<std::size_t>(std::count_if(
        ribbons.begin(), ribbons.end(),
        [&](const Ribbon& ribbon) { return trajectory[ribbon.pose].stamp >= first; }));
    const std::size_t associated = associated_by_revision(lines, models, random);
    const std::size_t line_ribbons = 20;  // checkpoints lie between lines
    EXPECT_LE(moved, associated);
    EXPECT_LE(associated,
              moved + std::max<std::size_t>(moved / 2, kCheckpointRibbons) + 2 * line_ribbons);
  }
}

TEST(Revisions, CheckpointsTakeLessThanTheModel) {
  Pair models(0);
  std::mt19937 random(1);
  models.add_lines(600);
  models.revise(0, 600, random);
  const std::size_t model = models.without().memory_bytes();
  EXPECT_LT(model, models.with().memory_bytes());
  EXPECT_LT(models.with().memory_bytes(), 2 * model);
}

}  // namespace
}  // namespace ribbon_mapper
