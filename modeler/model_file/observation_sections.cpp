// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/model_file/observation_sections.hpp"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace ribbon_mapper {
namespace {

constexpr std::size_t kRibbonBytes = 100, kSampleBytes = 3;  // without its samples
constexpr std::size_t kLineBytes = 20, kPointBytes = 8;      // without its points
constexpr float kLargest_m = 1e10F;                          // in the frame of the base
constexpr float kLargestStep_m = 1.0F;                       // of packed points: 33 km in all

std::array<float, 3> numbers_of(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3f read_vector(ByteReader& from) {
  const auto numbers = from.numbers<std::array<float, 3>>();
  return {numbers[0], numbers[1], numbers[2]};
}

bool is_unit(const Eigen::Vector3f& v) { return std::abs(v.norm() - 1.0F) < 1e-3F; }

bool is_within(float value, float least, float most) { return value >= least && value <= most; }

bool can_be(const Ribbon& ribbon) {
  for (const float number : ribbon.moments.numbers()) {
    if (!is_within(std::abs(number), 0.0F, kLargest_m * kLargest_m)) return false;
  }
  const RibbonSamples& samples = ribbon.samples;
  return ribbon.moments.weight() > 0.0 && ribbon.moments.mean().norm() < kLargest_m &&
         is_unit(ribbon.normal) && is_unit(ribbon.along) && ribbon.first_beam <= ribbon.last_beam &&
         ribbon.area_m2 > 0.0F && ribbon.area_m2 < kLargest_m && samples.size > 0 &&
         is_within(std::abs(samples.start_m), 0.0F, kLargest_m) &&
         is_within(samples.height_step_m, 0.0F, kLargest_m) &&
         is_within(samples.variance_m2, 0.0F, kLargest_m);
}

/// Writes each sample in one step, as there are millions.
void write_samples(const RibbonSamples& samples, ByteWriter& to) {
  std::string bytes(kSampleBytes * samples.size, '\0');
  for (std::uint32_t i = 0; i < samples.size; ++i) {
    const PackedSample& sample = samples.first[i];
    bytes[kSampleBytes * i] = static_cast<char>(sample.advance);
    bytes[kSampleBytes * i + 1] = static_cast<char>(sample.count);
    bytes[kSampleBytes * i + 2] = static_cast<char>(sample.height);
  }
  to.bytes(bytes);
}

/// Writes a point in one step.
void write_point(const PackedPoint& point, ByteWriter& to) {
  const auto part = [](auto value, unsigned place) {
    return std::uint64_t{static_cast<std::uint16_t>(value)} << (16U * place);
  };
  const auto& p = point.from_sensor;
  to.integer(part(p[0], 0) | part(p[1], 1) | part(p[2], 2) | part(point.count, 3));
}

void write_ribbon(const Ribbon& ribbon, ByteWriter& to) {
  for (const std::uint32_t index : {ribbon.pose, ribbon.first_beam, ribbon.last_beam}) {
    to.integer(index);
  }
  to.numbers(ribbon.moments.numbers());
  to.numbers(numbers_of(ribbon.normal));
  to.numbers(numbers_of(ribbon.along));
  to.number(ribbon.sigma_across_rad);
  to.number(ribbon.area_m2);
  const RibbonSamples& samples = ribbon.samples;
  to.number(samples.start_m);
  to.number(samples.height_step_m);
  to.number(samples.variance_m2);
  to.integer(samples.size);
  write_samples(samples, to);
}

void read_samples(ByteReader& from, std::vector<PackedSample>& samples) {
  const auto size = from.integer<std::uint32_t>();
  if (size > from.left() / kSampleBytes) from.fail("states more samples than it has");
  samples.resize(size);
  const std::string_view bytes = from.bytes(kSampleBytes * size);
  for (std::size_t i = 0; i < size; ++i) {
    samples[i].advance = static_cast<std::uint8_t>(bytes[kSampleBytes * i]);
    samples[i].count = static_cast<std::uint8_t>(bytes[kSampleBytes * i + 1]);
    samples[i].height = static_cast<std::int8_t>(bytes[kSampleBytes * i + 2]);
  }
}

/// Reads a ribbon whose samples are in a buffer.
Ribbon read_ribbon(ByteReader& from, std::vector<PackedSample>& buffer) {
  Ribbon ribbon;
  for (std::uint32_t* index : {&ribbon.pose, &ribbon.first_beam, &ribbon.last_beam}) {
    *index = from.integer<std::uint32_t>();
  }
  ribbon.moments = CompactMoments::of(from.numbers<CompactMoments::Numbers>());
  ribbon.normal = read_vector(from);
  ribbon.along = read_vector(from);
  ribbon.sigma_across_rad = from.number<float>();
  ribbon.area_m2 = from.number<float>();
  ribbon.samples.start_m = from.number<float>();
  ribbon.samples.height_step_m = from.number<float>();
  ribbon.samples.variance_m2 = from.number<float>();
  read_samples(from, buffer);
  ribbon.samples.first = buffer.data();
  ribbon.samples.size = static_cast<std::uint32_t>(buffer.size());
  ribbon.length_m = ribbon.samples.length_m();
  return ribbon;
}

}  // namespace

void write_ribbons(const std::vector<Ribbon>& ribbons, ByteWriter& to) {
  std::size_t samples = 0;
  for (const Ribbon& ribbon : ribbons) samples += ribbon.samples.size;
  to.reserve(sizeof(std::uint64_t) + kRibbonBytes * ribbons.size() + kSampleBytes * samples);
  to.integer(std::uint64_t{ribbons.size()});
  for (const Ribbon& ribbon : ribbons) write_ribbon(ribbon, to);
}

std::vector<Ribbon> read_ribbons(ByteReader& from, std::size_t poses,
                                 PackedStore<PackedSample>& samples) {
  std::vector<Ribbon> ribbons;
  const std::size_t count = from.count(kRibbonBytes);
  ribbons.reserve(count);
  std::vector<PackedSample> buffer;
  for (std::size_t i = 0; i < count; ++i) {
    Ribbon ribbon = read_ribbon(from, buffer);
    const bool is_in_order = i == 0 || ribbon.pose >= ribbons.back().pose;
    if (ribbon.pose >= poses || !is_in_order || !can_be(ribbon)) {
      from.fail("has a ribbon that cannot be, number " + std::to_string(i));
    }
    ribbon.samples.first = samples.add(buffer.data(), buffer.size());
    ribbons.push_back(ribbon);
  }
  return ribbons;
}

void write_unassigned(const std::vector<UnassignedPoints>& lines, ByteWriter& to) {
  to.integer(std::uint64_t{lines.size()});
  for (const UnassignedPoints& line : lines) {
    to.numbers(numbers_of(line.sensor));
    to.number(line.step_m);
    to.integer(line.size);
    for (const PackedPoint& point : line) write_point(point, to);
  }
}

std::vector<UnassignedPoints> read_unassigned(ByteReader& from, std::size_t lines,
                                              PackedStore<PackedPoint>& points) {
  if (from.count(kLineBytes) != lines) from.fail("has not one element for each line");
  std::vector<UnassignedPoints> all(lines);
  std::vector<PackedPoint> buffer;
  for (std::uint32_t i = 0; i < lines; ++i) {
    UnassignedPoints& line = all[i];
    line.pose = i;
    line.sensor = read_vector(from);
    line.step_m = from.number<float>();
    line.size = from.integer<std::uint32_t>();
    const bool is_near = line.sensor.cwiseAbs().maxCoeff() <= kLargest_m;
    if (line.size > from.left() / kPointBytes || !line.sensor.allFinite() || !is_near ||
        !is_within(line.step_m, 0.0F, kLargestStep_m)) {
      from.fail("has points that cannot be, of line " + std::to_string(i));
    }
    buffer.resize(line.size);
    for (PackedPoint& point : buffer) {
      auto parts = from.integer<std::uint64_t>();
      for (std::int16_t& coordinate : point.from_sensor) {
        coordinate = static_cast<std::int16_t>(parts & 0xFFFFU);
        parts >>= 16U;
      }
      point.count = static_cast<std::uint16_t>(parts);
    }
    line.first = points.add(buffer.data(), buffer.size());
  }
  return all;
}

}  // namespace ribbon_mapper
