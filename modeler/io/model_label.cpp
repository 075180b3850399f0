// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/model_label.hpp"

#include <Eigen/Geometry>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "modeler/io/planes_json.hpp"
#include "modeler/text/coefficients.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kOriginStep_m = 1000.0;  // floats resolve 0.1 mm at that distance

}  // namespace

Eigen::Vector3d origin_of(const std::vector<Plane>& planes) {
  Eigen::AlignedBox3d box;
  for (const Plane& plane : planes) {
    const Eigen::AlignedBox3d bounds = bounding_box(plane);
    if (!bounds.isEmpty()) box.extend(bounds);
  }
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  if (box.isEmpty()) return origin;
  for (int i = 0; i < 3; ++i) {
    const bool is_near = -box.min()[i] <= kOriginStep_m && box.max()[i] <= kOriginStep_m;
    if (!is_near) origin[i] = kOriginStep_m * std::round(box.center()[i] / kOriginStep_m);
  }
  return origin;
}

// FNV-1a gives the same hash on all machines.
std::string run_id_of(const std::vector<std::string>& texts) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::string& text : texts) {
    for (const char byte : text + '\0') {
      hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    }
  }
  std::array<char, 16> digits;
  const auto end = std::to_chars(digits.begin(), digits.end(), hash, 16).ptr;
  const auto count = static_cast<std::size_t>(end - digits.begin());
  return std::string(digits.size() - count, '0') + std::string(digits.data(), count);
}

std::string label_lines(const ModelLabel& label, const std::string& prefix) {
  std::string lines;
  if (!label.run.empty()) lines += prefix + "run " + label.run + "\n";
  if (label.origin.isZero(0.0)) return lines;
  lines += prefix + "origin";  // whole metres
  for (const double coordinate : coefficients_of(label.origin)) {
    lines += " " + std::to_string(static_cast<std::int64_t>(coordinate));
  }
  return lines + "\n";
}

std::string in_one_line(std::string text, std::size_t max_size) {
  for (char& character : text) {
    if (static_cast<unsigned char>(character) < ' ') character = ' ';
  }
  if (text.size() > max_size) text = text.substr(0, max_size - 3) + "...";
  return text;
}

}  // namespace ribbon_mapper
