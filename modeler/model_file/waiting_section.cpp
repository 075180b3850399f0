// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/model_file/waiting_section.hpp"

#include <cmath>

#include "modeler/model_file/pose_matrix.hpp"
#include "modeler/scan/scan_line.hpp"
#include "modeler/text/coefficients.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::size_t kLineBytes = 536, kCandidateBytes = 45;  // the least of each
constexpr double kLargestOrigin_m = 1e10;

// Members in the order of the file.
constexpr double LaserBeams::*kBeams[] = {
    &LaserBeams::angle_min_rad, &LaserBeams::angle_increment_rad, &LaserBeams::time_increment_s,
    &LaserBeams::range_min_m, &LaserBeams::range_max_m};
constexpr Pose LinePoses::*kPoses[] = {&LinePoses::T_odom_base_first, &LinePoses::T_odom_base_last,
                                       &LinePoses::T_base_laser_first,
                                       &LinePoses::T_base_laser_last, &LinePoses::T_map_base};
constexpr std::size_t NoReturnFilter::Candidate::*kCounts[] = {
    &NoReturnFilter::Candidate::lines, &NoReturnFilter::Candidate::equal,
    &NoReturnFilter::Candidate::near, &NoReturnFilter::Candidate::beyond,
    &NoReturnFilter::Candidate::removed};

void write_line(const LaserBeams& beams, const LinePoses& poses, ByteWriter& to) {
  to.integer(std::int64_t{beams.stamp.count()});
  for (const auto member : kBeams) to.number(beams.*member);
  for (const auto member : kPoses) write_matrix(poses.*member, to);
  to.integer(std::uint64_t{beams.ranges_m.size()});
  to.numbers(beams.ranges_m);
}

void read_line(ByteReader& from, LaserBeams& beams, LinePoses& poses) {
  beams.stamp = Time(from.integer<std::int64_t>());
  for (const auto member : kBeams) beams.*member = from.number<double>();
  for (const auto member : kPoses) poses.*member = read_matrix(from);
  beams.ranges_m.resize(from.count(sizeof(float)));
  for (float& range_m : beams.ranges_m) range_m = from.number<float>();
  if (const auto defect = find_defect(beams, poses)) from.fail("has a line that waits: " + *defect);
}

void write_average(const LineAverager::Sums& average, ByteWriter& to) {
  to.integer(static_cast<std::uint8_t>(average.lines));
  if (average.lines == 0) return;
  write_line(average.beams, average.poses, to);
  to.integer(std::int64_t{average.last_stamp.count()});
  to.numbers(average.sums_m);
  for (const std::uint16_t count : average.returns) to.integer(count);
  for (const std::uint16_t count : average.agreeing) to.integer(count);
}

LineAverager::Sums read_average(ByteReader& from) {
  LineAverager::Sums average;
  average.lines = from.integer<std::uint8_t>();
  if (average.lines > LineAverager::kMaxLines) from.fail("has an average of too many lines");
  if (average.lines == 0) return average;
  read_line(from, average.beams, average.poses);
  average.last_stamp = Time(from.integer<std::int64_t>());
  const std::size_t beams = average.beams.ranges_m.size();
  average.sums_m.resize(beams), average.returns.resize(beams), average.agreeing.resize(beams);
  for (float& sum : average.sums_m) sum = from.number<float>();
  for (std::uint16_t& count : average.returns) count = from.integer<std::uint16_t>();
  for (std::uint16_t& count : average.agreeing) count = from.integer<std::uint16_t>();
  return average;
}

void write_evidence(const NoReturnFilter::Evidence& evidence, ByteWriter& to) {
  to.integer(std::uint64_t{evidence.beams});
  to.integer(std::uint64_t{evidence.candidates.size()});
  for (const NoReturnFilter::Candidate& candidate : evidence.candidates) {
    to.number(candidate.range_m);
    for (const auto member : kCounts) to.integer(std::uint64_t{candidate.*member});
    to.integer(static_cast<std::uint8_t>(candidate.is_no_return));
  }
}

NoReturnFilter::Evidence read_evidence(ByteReader& from) {
  NoReturnFilter::Evidence evidence;
  evidence.beams = static_cast<std::size_t>(from.integer<std::uint64_t>());
  evidence.candidates.resize(from.count(kCandidateBytes));
  for (NoReturnFilter::Candidate& candidate : evidence.candidates) {
    candidate.range_m = from.number<float>();
    for (const auto member : kCounts) {
      candidate.*member = static_cast<std::size_t>(from.integer<std::uint64_t>());
    }
    candidate.is_no_return = from.flag();
  }
  return evidence;
}

}  // namespace

void write_waiting(const ScanFrontEnd::Parts& parts, ByteWriter& to) {
  for (const double coordinate : coefficients_of(parts.odom_origin)) to.number(coordinate);
  to.integer(std::uint64_t{parts.lines.size()});
  for (const ScanFrontEnd::Parts::Line& line : parts.lines) {
    to.integer(static_cast<std::uint8_t>(line.averaged_lines));
    write_line(line.beams, line.poses, to);
  }
  to.integer(std::uint64_t{parts.done});
  write_average(parts.average, to);
  write_evidence(parts.no_returns, to);
}

ScanFrontEnd::Parts read_waiting(ByteReader& from) {
  ScanFrontEnd::Parts parts;
  for (int i = 0; i < 3; ++i) {
    parts.odom_origin[i] = from.number<double>();
    if (!(std::abs(parts.odom_origin[i]) < kLargestOrigin_m))
      from.fail("has an origin that cannot be");
  }
  parts.lines.resize(from.count(kLineBytes));
  for (std::size_t i = 0; i < parts.lines.size(); ++i) {
    ScanFrontEnd::Parts::Line& line = parts.lines[i];
    line.averaged_lines = from.integer<std::uint8_t>();
    read_line(from, line.beams, line.poses);
    if (line.averaged_lines == 0 ||
        (i > 0 && middle_of(line.beams) <= middle_of(parts.lines[i - 1].beams))) {
      from.fail("has lines that wait in no order");
    }
  }
  parts.done = static_cast<std::size_t>(from.integer<std::uint64_t>());
  parts.average = read_average(from);
  parts.no_returns = read_evidence(from);
  return parts;
}

}  // namespace ribbon_mapper
