// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/bend.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/square.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kSigmas = 4.0;
/// Part of a bend's significance that is left at the next place that is tried at first.
constexpr double kShareNearby = 0.5;
constexpr std::size_t kPlaces = 6;

/// Sums over returns in the plane of the scan: x along the chord, y across it.
struct Sums {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  Sums operator-(const Sums& other) const {
    return {n - other.n, x - other.x, y - other.y, xx - other.xx, xy - other.xy, yy - other.yy};
  }
};

/// A line of returns as a polyline that bends once: y = a + b x + c max(0, x - x of the bend).
class BentLine {
 public:
  BentLine(const ScanLine& line, const BeamRange& beams) : line_(&line), beams_(beams) {
    const Eigen::Vector3d chord = line.points[beams.end - 1] - line.points[beams.begin];
    const Eigen::Vector3d up = line.directions[beams.begin].cross(line.directions[beams.end - 1]);
    x_ = chord.normalized();
    y_ = up.cross(chord).normalized();
    centre_ = line.moments(beams.begin, beams.end).mean();
    all_ = sums(beams.begin, beams.end);
    square_error_ = all_.yy - square(all_.xy) / all_.xx;
  }

  struct Fit {
    double change_of_slope;  // c
    double square_sigmas;    // of c
  };

  /// Returns the best fit with a bend at this beam.
  Fit fit(std::size_t beam) const {
    const Sums after = all_ - sums(beams_.begin, beam);
    const double at = x_.dot(line_->points[beam] - centre_);
    const double h = after.x - after.n * at;  // sums of max(0, x - at) and its products
    const double hx = after.xx - at * after.x;
    const double hy = after.xy - at * after.y;
    const double hh = hx - at * h - square(h) / all_.n - square(hx) / all_.xx;
    const double c = (hy - hx * all_.xy / all_.xx) / hh;
    const double gain = c * c * hh;
    const double variance = (square_error_ - gain) / (all_.n - 3.0);
    return {c, gain / variance};
  }

  double angle_rad(double change_of_slope) const {
    const double slope = all_.xy / all_.xx;
    return std::abs(std::atan(slope + change_of_slope) - std::atan(slope));
  }

 private:
  Sums sums(std::size_t begin, std::size_t end) const {
    const Moments moments = line_->moments(begin, end);
    const double n = moments.weight();
    const Eigen::Vector3d mean = moments.mean() - centre_;
    const Eigen::Matrix3d covariance = moments.covariance();
    const double x = x_.dot(mean), y = y_.dot(mean);
    const Eigen::Vector3d column = covariance * x_;
    return {n,
            n * x,
            n * y,
            n * (x_.dot(column) + x * x),
            n * (y_.dot(column) + x * y),
            n * (y_.dot(covariance * y_) + y * y)};
  }

  const ScanLine* line_;
  BeamRange beams_;
  Eigen::Vector3d x_, y_, centre_;
  Sums all_;
  double square_error_;
};

/// Returns false if noise hides the largest bend, as two clusters' normals differ by more. In the
/// middle of a line of n points and this length, a bend's standard error is sigma sqrt(48 / n) / l.
bool can_show_a_bend(const ScanLine& line, const BeamRange& beams, const ScanConfig& scan,
                     const RibbonConfig& config) {
  const double square_length_m2 =
      (line.points[beams.end - 1] - line.points[beams.begin]).squaredNorm();
  const double largest_rad = config.cluster_angle_deg * kDegree;
  return static_cast<double>(beams.size()) * square_length_m2 * square(largest_rad) >
         48.0 * square(kSigmas * scan.range_sigma_m);
}

}  // namespace

std::optional<std::size_t> find_bend(const ScanLine& line, const BeamRange& beams,
                                     const ScanConfig& scan, const RibbonConfig& config) {
  const auto least = static_cast<std::size_t>(config.min_points);
  if (beams.size() < 2 * least || !can_show_a_bend(line, beams, scan, config)) return std::nullopt;
  const BentLine bent(line, beams);
  std::size_t best = 0;
  BentLine::Fit fit{0.0, 0.0};
  const auto search = [&](std::size_t begin, std::size_t end, std::size_t stride) {
    for (std::size_t beam = begin; beam < end; beam += stride) {
      const BentLine::Fit here = bent.fit(beam);
      if (here.square_sigmas > fit.square_sigmas) best = beam, fit = here;
    }
  };
  const std::size_t first = beams.begin + least, end = beams.end - least + 1;
  const std::size_t stride = std::max(least, beams.size() / kPlaces);
  search(first, end, stride);
  if (fit.square_sigmas < square(kShareNearby * kSigmas)) return std::nullopt;
  search(std::max(first, best - std::min(best, stride)), std::min(end, best + stride), 1);
  if (fit.square_sigmas < square(kSigmas)) return std::nullopt;
  if (bent.angle_rad(fit.change_of_slope) < config.min_bend_deg * kDegree) return std::nullopt;
  return best;
}

}  // namespace ribbon_mapper
