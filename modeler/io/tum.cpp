// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/tum.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace ribbon_mapper {
namespace {

constexpr double kQuaternionTolerance = 0.01;  // some files have only four decimals

std::string to_line(const StampedPose& pose) {
  const auto since_epoch = pose.stamp.count();
  const auto magnitude = std::abs(since_epoch);
  const Eigen::Vector3d t = pose.T_map_base.translation();
  Eigen::Quaterniond q(pose.T_map_base.linear());
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  std::array<char, 256> line;
  std::snprintf(line.data(), line.size(), "%s%lld.%09lld %.9f %.9f %.9f %.12f %.12f %.12f %.12f\n",
                since_epoch < 0 ? "-" : "", static_cast<long long>(magnitude / 1'000'000'000),
                static_cast<long long>(magnitude % 1'000'000'000), t.x(), t.y(), t.z(), q.x(),
                q.y(), q.z(), q.w());
  return line.data();
}

/// Parses a line into `pose`. Returns an error message, empty on success.
std::string parse_line(const std::string& line, StampedPose& pose) {
  std::istringstream stream(line);
  stream.imbue(std::locale::classic());
  long double stamp_s = 0.0L;  // a double cannot hold nanoseconds since 1970
  std::array<double, 7> v{};
  stream >> stamp_s;
  for (double& value : v) stream >> value;
  if (stream.fail()) return "expected 8 finite numbers: stamp tx ty tz qx qy qz qw";
  if (stream >> std::ws; !stream.eof()) return "more than 8 numbers";
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (!(std::abs(q.norm() - 1.0) <= kQuaternionTolerance))
    return "the quaternion does not have unit length";
  constexpr long double kLargest_s = std::numeric_limits<Time::rep>::max() / 1e9L;
  if (!(std::abs(stamp_s) < kLargest_s)) return "the stamp is too large";
  pose.stamp = Time(static_cast<Time::rep>(std::llround(stamp_s * 1e9L)));
  pose.T_map_base = Eigen::Translation3d(v[0], v[1], v[2]) * q.normalized();
  return "";
}

bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#';
}

}  // namespace

std::string to_tum(const std::vector<StampedPose>& trajectory) {
  std::string text = "# stamp tx ty tz qx qy qz qw\n";
  for (const StampedPose& pose : trajectory) text += to_line(pose);
  return text;
}

std::vector<StampedPose> from_tum(const std::string& text, const std::string& name) {
  std::vector<StampedPose> trajectory;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (is_comment(line)) continue;
    StampedPose pose;
    std::string error = parse_line(line, pose);
    const bool increases = trajectory.empty() || trajectory.back().stamp < pose.stamp;
    if (error.empty() && !increases) error = "the stamp is not later than the one before";
    if (!error.empty()) {
      throw std::runtime_error(name + ", line " + std::to_string(number) + ": " + error);
    }
    trajectory.push_back(pose);
  }
  return trajectory;
}

std::vector<StampedPose> read_tum(const std::filesystem::path& path) {
  std::ifstream file(path);
  file.peek();  // a directory can be opened but not read
  if (!file.is_open() || file.bad()) {
    throw std::runtime_error("cannot read " + path.string() + ": " + std::strerror(errno));
  }
  std::ostringstream text;
  text << file.rdbuf();
  return from_tum(text.str(), path.string());
}

}  // namespace ribbon_mapper
