// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/segment_smoother.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon_mapper {
namespace {

constexpr std::size_t lines = 9;

/// Of a robot that drives along a curve.
std::vector<Pose> curve() { return std::vector<Pose>(lines + 1, planar_pose(0.1, 0.0, 0.05)); }

Pose after(const std::vector<Pose>& steps, std::size_t count) {
  Pose pose = planar_pose(1.0, -2.0, 0.3);
  for (std::size_t i = 0; i < count; ++i) pose = pose * steps[i];
  return pose;
}

double distance(const Pose& a, const Pose& b) { return (a.matrix() - b.matrix()).norm(); }

double yaw_sigma(const PoseBelief& belief) { return std::sqrt(belief.covariance(5, 5)); }

TEST(Bridge, WithoutAnErrorItIsTheOdometry) {
  const std::vector<Pose> steps = curve();
  const Bridge bridge(steps, {}, after(steps, 0), after(steps, lines + 1));
  for (std::size_t i = 0; i < lines; ++i) {
    EXPECT_LT(distance(after(steps, i + 1), bridge.without(i).T_model_base), 1e-9);
  }
}

TEST(Bridge, SpreadsAMismatchOverTheWayAndIsLeastCertainInTheMiddle) {
  const std::vector<Pose> steps(lines + 1, planar_pose(0.0, 0.0, 0.05));  // turns on the spot
  const OdometryNoise noise;
  const Pose first = after(steps, 0);
  const Pose last = after(steps, lines + 1) * planar_pose(0.0, 0.0, 0.1);
  const Bridge bridge(steps, noise, first, last);
  EXPECT_NEAR(0.3 + 5 * 0.05 + 0.05, yaw_of(bridge.without(4).T_model_base), 1e-6);
  // In the middle of ten equal steps two halves of five meet, each as uncertain as the other.
  const double half = 5 * noise.variances(steps[0])[5];
  EXPECT_NEAR(std::sqrt(half / 2.0), yaw_sigma(bridge.without(4)), 1e-6);
  EXPECT_GT(yaw_sigma(bridge.without(4)), yaw_sigma(bridge.without(0)));
  EXPECT_GT(yaw_sigma(bridge.without(4)), yaw_sigma(bridge.without(lines - 1)));
}

TEST(Bridge, OneEndIsEnough) {
  const std::vector<Pose> steps = curve();
  const Bridge from_first(steps, {}, after(steps, 0), std::nullopt);
  const Bridge from_last(steps, {}, std::nullopt, after(steps, lines + 1));
  for (std::size_t i = 0; i < lines; ++i) {
    EXPECT_LT(distance(after(steps, i + 1), from_first.without(i).T_model_base), 1e-6);
    EXPECT_LT(distance(after(steps, i + 1), from_last.without(i).T_model_base), 1e-6);
  }
  EXPECT_LT(yaw_sigma(from_first.without(0)), yaw_sigma(from_first.without(lines - 1)));
  EXPECT_GT(yaw_sigma(from_last.without(0)), yaw_sigma(from_last.without(lines - 1)));
}

TEST(Bridge, WhatOneLineObservesItsNeighboursLearn) {
  const std::vector<Pose> steps = curve();
  const Pose truth = after(steps, 5) * planar_pose(0.03, -0.02, 0.04);
  Bridge bridge(steps, {}, after(steps, 0), after(steps, lines + 1));
  const PoseBelief third_before = bridge.without(3), fifth_before = bridge.without(5);
  const auto observe = [&](std::size_t line, const PoseBelief& without_it) {
    Observation observation;
    observation.T_model_base = without_it.T_model_base;
    if (line != 4) return observation;
    observation.information = 1e8 * Matrix6::Identity();
    observation.gradient = observation.information * error_between(without_it.T_model_base, truth);
    return observation;
  };
  bridge.sweep(observe);
  const PoseBelief fourth = updated(bridge.without(4), observe(4, bridge.without(4)));
  EXPECT_LT(distance(truth, fourth.T_model_base), 1e-3);
  const auto off = [&](const PoseBelief& third, const PoseBelief& fifth) {
    return distance(truth, third.T_model_base * steps[4]) +
           distance(truth * steps[5], fifth.T_model_base);
  };
  EXPECT_LT(off(bridge.without(3), bridge.without(5)), 0.5 * off(third_before, fifth_before));
  EXPECT_LT(yaw_sigma(bridge.without(3)), yaw_sigma(third_before));
}

}  // namespace
}  // namespace ribbon_mapper
