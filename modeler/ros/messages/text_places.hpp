// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ribbon_mapper {

/// Places texts that face the viewer so that none covers another, seen from the side or obliquely
/// from above.
class TextPlaces {
 public:
  /// Creates places for texts whose capital letters are `letter_m` high.
  explicit TextPlaces(double letter_m) : letter_m_(letter_m) {}

  /// Returns a free place for a text at `wanted` or above it, and takes it. Where too many texts
  /// stand already, it is the place wanted.
  Eigen::Vector3d take(const Eigen::Vector3d& wanted, const std::string& text);

 private:
  struct Text {
    Eigen::Vector3d middle;
    double width_m, height_m;
  };
  using Column = std::pair<int, int>;

  Text text_at(const Eigen::Vector3d& middle, const std::string& text) const;
  const Text* covered_by(const Text& text) const;

  double letter_m_;
  std::map<Column, std::vector<Text>> columns_;
};

}  // namespace ribbon_mapper
