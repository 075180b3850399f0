// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/tum.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "modeler/geometry/pose_defect.hpp"
#include "modeler/text/coefficients.hpp"
#include "modeler/text/number_text.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kQuaternionTolerance = 0.01;  // some files have only four decimals

/// Returns a time in seconds, exact to the nanosecond.
std::string seconds_text(Time time) {
  const auto since_epoch = time.count();
  const std::string nanoseconds = std::to_string(std::abs(since_epoch % 1'000'000'000));
  return (since_epoch < 0 ? "-" : "") + std::to_string(std::abs(since_epoch / 1'000'000'000)) +
         "." + std::string(9 - nanoseconds.size(), '0') + nanoseconds;
}

std::string to_line(const StampedPose& pose) {
  std::string line = seconds_text(pose.stamp);
  Eigen::Quaterniond q(pose.T_map_base.linear());
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  for (const double value : coefficients_of(pose.T_map_base.translation()))
    line += " " + fixed_text(value, 9);
  for (const double value : coefficients_of(q.coeffs())) line += " " + fixed_text(value, 12);
  return line + "\n";
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
  if (const auto defect = find_defect(pose.T_map_base)) return "the pose " + *defect;
  return "";
}

bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#';
}

}  // namespace

std::string to_tum(const std::vector<StampedPose>& trajectory, const std::string& run) {
  std::string text = run.empty() ? "" : "# run " + run + "\n";
  text += "# stamp tx ty tz qx qy qz qw\n";
  for (const StampedPose& pose : trajectory) text += to_line(pose);
  return text;
}

std::string to_covariance_csv(const std::vector<StampedPose>& trajectory,
                              const std::vector<Matrix6>& covariances, const std::string& run) {
  if (trajectory.size() != covariances.size()) {
    throw std::invalid_argument("covariances: there must be one for each pose");
  }
  constexpr std::array<const char*, 6> kNames{"x", "y", "z", "roll", "pitch", "yaw"};
  std::string text = (run.empty() ? "" : "# run " + run + "\n") + "stamp";
  const auto for_each_column = [](const auto& visit) {
    for (int row = 0; row < 6; ++row) {
      for (int column = row; column < 6; ++column) visit(row, column);
    }
  };
  for_each_column(
      [&](int row, int column) { text += std::string(",") + kNames[row] + "_" + kNames[column]; });
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    text += "\n" + seconds_text(trajectory[i].stamp);
    for_each_column([&](int row, int column) {
      text += "," + scientific_text(covariances[i](row, column), 6);
    });
  }
  return text + "\n";
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
