// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/sample_packer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ribbon_mapper {
namespace {

/// A sample as given to the packer.
struct Sample {
  double along_m, height_m;
  std::size_t count;
};

/// Returns the samples in their order.
std::vector<Sample> unpacked(const RibbonSamples& samples) {
  std::vector<Sample> result;
  samples.for_each([&](float along_m, float height_m, std::uint32_t count) {
    result.push_back({along_m, height_m, count});
  });
  return result;
}

TEST(SamplePacker, KeepsPositionsToHalfAStep) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> advance_m(0.02, 0.2);
  std::normal_distribution<double> height_m(0.0, 0.01);
  std::vector<Sample> samples;
  double along_m = -3.0;
  SamplePacker packer;
  for (int i = 0; i < 500; ++i) {
    samples.push_back({along_m, height_m(random), 1u + i % 7});
    packer.add(along_m, samples[i].height_m, std::pow(samples[i].height_m, 2), samples[i].count);
    along_m += advance_m(random);
  }
  const auto packed = unpacked(packer.pack());
  ASSERT_EQ(samples.size(), packed.size());
  for (std::size_t i = 0; i < packed.size(); ++i) {
    EXPECT_NEAR(samples[i].along_m, packed[i].along_m, 0.51 * RibbonSamples::kAlongStep_m);
    EXPECT_NEAR(samples[i].height_m, packed[i].height_m, 3e-4);
    EXPECT_EQ(samples[i].count, packed[i].count);
  }
}

TEST(SamplePacker, PacksLongGapsAndManyPoints) {
  SamplePacker packer;
  packer.add(0.0, 0.0, 0.0, 1);
  packer.add(12.0, 0.001, 1e-6, 700);
  const RibbonSamples samples = packer.pack();
  EXPECT_NEAR(12.0, samples.length_m(), 0.005);
  std::size_t points = 0;
  for (const Sample& sample : unpacked(samples)) {
    points += sample.count;
    EXPECT_NEAR(sample.count == 1 ? 0.0 : 12.0, sample.along_m, 0.005);
  }
  EXPECT_EQ(701u, points);
}

TEST(SamplePacker, ReturnsTheVarianceAboutTheMeans) {
  SamplePacker packer;
  packer.add(0.0, 0.01, 0.01 * 0.01 + 4e-6, 10);
  packer.add(0.1, -0.01, 0.01 * 0.01 + 1e-6, 5);
  EXPECT_NEAR(3e-6, packer.pack().variance_m2, 1e-9);
}

TEST(SamplePacker, StartsAgainAfterPacking) {
  SamplePacker packer;
  packer.add(1.0, 0.02, 4e-4, 3);
  packer.pack();
  EXPECT_EQ(0u, packer.pack().size);
  packer.add(2.0, 0.0, 0.0, 1);
  EXPECT_EQ(1u, packer.pack().size);
}

}  // namespace
}  // namespace ribbon_mapper
