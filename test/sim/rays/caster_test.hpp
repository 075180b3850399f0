// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "sim/rays/ray_caster.hpp"

namespace ribbon_mapper::sim {

/// A test that runs with each ray caster; one that this build lacks is skipped.
class CasterTest : public testing::TestWithParam<RayCasterKind> {
 protected:
  void SetUp() override {
    if (!is_available(GetParam())) GTEST_SKIP() << "needs the package libembree-dev";
  }
};

/// The parameters of a CasterTest.
inline const auto kAllCasters = testing::Values(RayCasterKind::bullet, RayCasterKind::embree);

/// Returns the name of a CasterTest's parameter.
inline std::string caster_name(const testing::TestParamInfo<RayCasterKind>& test) {
  return test.param == RayCasterKind::bullet ? "Bullet" : "Embree";
}

}  // namespace ribbon_mapper::sim
