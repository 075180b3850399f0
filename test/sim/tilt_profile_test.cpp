// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/robot/tilt_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ribbon_mapper::sim {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using E = std::invalid_argument;
using Shape = TiltProfileConfig::Shape;

double at(const TiltProfile& profile, double time_s) {
  return profile.angle_rad(from_seconds(time_s));
}

TEST(TiltProfile, LinearIsATriangleThatStartsLookingUp) {
  const TiltProfile manip(TiltProfileConfig::preset("manip"));  // 3 s, 0.75, 0.25
  EXPECT_NEAR(at(manip, 0.0), -0.5, 1e-9);
  EXPECT_NEAR(at(manip, 0.75), 0.25, 1e-9);
  EXPECT_NEAR(at(manip, 1.5), 1.0, 1e-9);
  EXPECT_NEAR(at(manip, 2.25), 0.25, 1e-9);
  EXPECT_NEAR(at(manip, 3.0), -0.5, 1e-9);
  EXPECT_NEAR(at(manip, 301.0), -0.5 + 1.0, 1e-9) << "1 s into the 101st period";
  EXPECT_DOUBLE_EQ(manip.period_s(), 3.0);
  EXPECT_NEAR(at(TiltProfile(TiltProfileConfig::preset("slow")), 2.5), 0.25, 1e-9);
}

/// pr2_move_base.py: 1.05 to -0.7 in 1.8 s, back in 0.5125 s, from rest to rest at 30 rad/s2.
TEST(TiltProfile, NavGoesFromRestToRest) {
  const TiltProfile nav(TiltProfileConfig::preset("nav"));
  EXPECT_DOUBLE_EQ(nav.period_s(), 2.3125);
  EXPECT_NEAR(at(nav, 0.0), 1.05, 1e-9);
  EXPECT_NEAR(at(nav, 0.9), (1.05 - 0.7) / 2.0, 1e-9) << "symmetric";
  EXPECT_NEAR(at(nav, 1.8), -0.7, 1e-6);
  EXPECT_NEAR(at(nav, 2.3125), 1.05, 1e-6);
  const double h = 1e-4;
  for (double t = h; t < 2.0 * 2.3125; t += 0.0037) {
    const double rate = (at(nav, t + h) - at(nav, t - h)) / (2.0 * h);
    const double acceleration = (at(nav, t + h) - 2.0 * at(nav, t) + at(nav, t - h)) / (h * h);
    EXPECT_LE(std::abs(acceleration), 30.0 * 1.001) << t;
    EXPECT_LE(std::abs(rate), 10.0) << t;
  }
  const auto rate = [&](double t) { return (at(nav, t + h) - at(nav, t - h)) / (2.0 * h); };
  EXPECT_NEAR(rate(0.5), rate(1.3), 1e-6) << "cruises";
  EXPECT_NEAR(rate(0.9), -1.75 / (1.8 - 0.03311), 2e-3) << "0.99 rad/s, ramps of 33 ms";
  EXPECT_NEAR(rate(1.8), 0.0, 0.01) << "stands at the turning point";
}

TEST(TiltProfile, IsClampedToTheJointsLimits) {
  const TiltProfile wide(TiltProfileConfig::linear(6.0, 1.5, 0.25));
  EXPECT_NEAR(at(wide, 0.0), -0.7854, 1e-9);
  EXPECT_NEAR(at(wide, 3.0), 1.48353, 1e-9);
}

TEST(TiltProfile, RefusesWhatTheJointCannotDo) {
  const auto made = [](const TiltProfileConfig& config) {
    return [config] { TiltProfile{config}; };
  };
  EXPECT_THAT(made(TiltProfileConfig::linear(0.2, 0.75, 0.25)),
              ThrowsMessage<E>(HasSubstr("10 rad/s")));
  EXPECT_THAT(made({Shape::blended_linear, {1, -0.7, 1}, {0, 0.3, 2.3}, 30.0}),
              ThrowsMessage<E>(HasSubstr("acceleration limit")));
  EXPECT_THAT(made({Shape::linear, {1, 0, 0.9}, {0, 1, 2}, 30.0}),
              ThrowsMessage<E>(HasSubstr("last position must equal the first")));
  EXPECT_THAT(made({Shape::linear, {1, 0, 1}, {0, 2, 2}, 30.0}),
              ThrowsMessage<E>(HasSubstr("times must increase")));
  EXPECT_THAT(made({Shape::linear, {1, 0, 1}, {0.5, 1, 2}, 30.0}),
              ThrowsMessage<E>(HasSubstr("begin with 0")));
  EXPECT_THAT(made({Shape::linear, {1, 1}, {0, 1, 2}, 30.0}),
              ThrowsMessage<E>(HasSubstr("equally many")));
  EXPECT_THAT(made({Shape::linear, {1, NAN, 1}, {0, 1, 2}, 30.0}),
              ThrowsMessage<E>(HasSubstr("finite")));
  EXPECT_THAT([] { TiltProfileConfig::preset("fast"); },
              ThrowsMessage<E>(HasSubstr("manip, nav or slow")));
}

}  // namespace
}  // namespace ribbon_mapper::sim
