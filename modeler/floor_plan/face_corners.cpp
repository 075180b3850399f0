// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "modeler/floor_plan/wall_face.hpp"
#include "modeler/semantics/top_view.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kLeastSine = 0.35;  // of the angle at a corner: from 20 degrees on
constexpr double kSquare_m = 1.0;    // of the top view; more than a joint

/// Returns where the line of a face crosses that of another one, along the first; nothing if they
/// are nearly parallel.
std::optional<double> crossing_m(const WallFace& face, const WallFace& other) {
  const double sine = other.normal.dot(face.along());
  if (std::abs(sine) < kLeastSine) return std::nullopt;
  return (other.distance_m - face.distance_m * other.normal.dot(face.normal)) / sine;
}

/// Returns how far a position along a face is from an end of it, or 0 where it was seen [m].
double gap_m(const WallFace& face, double along_m) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Interval& piece : face.seen) {
    least_m = std::min(least_m, std::max({piece.begin - along_m, along_m - piece.end, 0.0}));
  }
  return least_m;
}

/// Faces that have an end near a place, or pass it.
class Corners {
 public:
  Corners(const std::vector<WallFace>& faces, const FloorPlanConfig& config)
      : faces_(faces), config_(config) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (const Interval& piece : faces[i].seen) {
        for (double along_m = piece.begin; along_m < piece.end; along_m += 0.5 * kSquare_m) {
          view_.at(faces[i].at(along_m)).push_back(i);
        }
        view_.at(faces[i].at(piece.end)).push_back(i);
      }
    }
  }

  /// Returns where an end belongs: at the nearest corner, or where it is.
  /// `side` is 1 for an upper end, -1 for a lower one.
  double fitted_m(std::size_t index, double along_m, double side) const {
    const WallFace& face = faces_[index];
    double result_m = along_m, least_m = std::numeric_limits<double>::infinity();
    view_.for_each_around(face.at(along_m), 1, [&](std::size_t other) {
      const auto corner_m = crossing_m(face, faces_[other]);
      if (!corner_m) return;
      const double moved_m = std::abs(*corner_m - along_m);
      const double apart_m = gap_m(faces_[other], faces_[other].along_m(face.at(*corner_m)));
      const bool is_before =
          side * faces_[other].normal.dot(face.along()) > 0.0 && side * (along_m - *corner_m) > 0.0;
      if (moved_m > (is_before ? config_.overshoot_m : config_.joint_m)) return;
      if (apart_m > config_.joint_m) return;
      if (moved_m + apart_m >= least_m) return;
      least_m = moved_m + apart_m;
      result_m = *corner_m;
    });
    return result_m;
  }

 private:
  const std::vector<WallFace>& faces_;
  const FloorPlanConfig& config_;
  TopView<std::size_t> view_{kSquare_m};
};

}  // namespace

void fit_corners(std::vector<WallFace>& faces, const FloorPlanConfig& config) {
  const Corners corners(faces, config);
  std::vector<Intervals> fitted;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Intervals& pieces = fitted.emplace_back();
    for (const Interval& piece : faces[i].seen) {
      const Interval moved{corners.fitted_m(i, piece.begin, -1.0),
                           corners.fitted_m(i, piece.end, 1.0)};
      if (moved.begin < moved.end) pieces.push_back(moved);
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i].seen = united(fitted[i]);
}

}  // namespace ribbon_mapper
