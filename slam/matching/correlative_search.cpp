// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/matching/correlative_search.hpp"

#include <tsl/robin_map.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "modeler/geometry/grid_keys.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr int kFull = 100;                                   // on a point
constexpr int kBeside = 60;                                  // in the next cell
constexpr double kElsewhere_m = 0.6, kElsewhere_rad = 0.15;  // a second peak lies beyond

int cell_of(double metres) { return floor_to_int(metres / CorrelativeSearch::kCell_m); }

}  // namespace

struct CorrelativeSearch::Candidate {
  int level = 0, angle = 0, x = 0, y = 0;  // the lower corner of 2^level squared positions
  int sum = 0;
};

struct CorrelativeSearch::Task {
  std::vector<Offsets> points;  // by angle
  std::vector<double> yaws;     // by angle
  int radius = 0;               // in cells
  int least = 0;                // sums must be larger
  std::optional<Candidate> found, excluded;

  bool is_excluded(const Candidate& c) const {
    return excluded && std::hypot(c.x - excluded->x, c.y - excluded->y) * kCell_m < kElsewhere_m &&
           std::abs(wrapped(yaws[c.angle] - yaws[excluded->angle])) < kElsewhere_rad;
  }
};

CorrelativeSearch::CorrelativeSearch(const LevelPoints& points) {
  int right = 0, top = 0;
  const auto is_near = [](const LevelPoint& p) {
    return std::abs(p.x_m) < kMaxExtent_m && std::abs(p.y_m) < kMaxExtent_m;
  };
  for (const LevelPoint& p : points) {
    if (!is_near(p)) continue;
    left_ = std::min(left_, cell_of(p.x_m)), right = std::max(right, cell_of(p.x_m));
    bottom_ = std::min(bottom_, cell_of(p.y_m)), top = std::max(top, cell_of(p.y_m));
  }
  const int margin = 1 + (1 << (kLevels - 1));  // coarse cells begin outside
  left_ -= margin, bottom_ -= margin;
  columns_ = right + 2 - left_, rows_ = top + 2 - bottom_;
  grids_.resize(kLevels);
  grids_[0].assign(static_cast<std::size_t>(columns_) * rows_, 0);
  for (const LevelPoint& p : points) {
    if (!is_near(p)) continue;
    const std::size_t at =
        static_cast<std::size_t>(cell_of(p.y_m) - bottom_) * columns_ + cell_of(p.x_m) - left_;
    for (const std::size_t beside : {at - 1, at + 1, at - columns_, at + columns_})
      grids_[0][beside] = std::max<std::uint8_t>(grids_[0][beside], kBeside);
    grids_[0][at] = kFull;
  }
  pool();
}

/// Makes the coarser grids: the largest value of a square whose lower corner is the cell.
void CorrelativeSearch::pool() {
  for (int level = 1; level < kLevels; ++level) {
    const int step = 1 << (level - 1);
    std::vector<std::uint8_t> rows_done = grids_[level - 1];
    for (int y = 0; y < rows_; ++y) {
      std::uint8_t* row = &rows_done[static_cast<std::size_t>(y) * columns_];
      for (int x = 0; x + step < columns_; ++x) row[x] = std::max(row[x], row[x + step]);
    }
    grids_[level] = std::move(rows_done);
    for (int y = 0; y + step < rows_; ++y) {
      std::uint8_t* row = &grids_[level][static_cast<std::size_t>(y) * columns_];
      const std::uint8_t* above = row + static_cast<std::size_t>(step) * columns_;
      for (int x = 0; x < columns_; ++x) row[x] = std::max(row[x], above[x]);
    }
  }
}

int CorrelativeSearch::value(int level, int x, int y) const {
  const int column = x - left_, row = y - bottom_;
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return 0;
  return grids_[level][static_cast<std::size_t>(row) * columns_ + column];
}

int CorrelativeSearch::sum(const Offsets& points, int level, int x, int y) const {
  int total = 0;
  for (const auto& [px, py] : points) total += value(level, px + x, py + y);
  return total;
}

std::vector<CorrelativeSearch::Candidate> CorrelativeSearch::coarsest(const Task& task) const {
  int level = 0;
  while (level + 1 < kLevels && (1 << level) < task.radius) ++level;
  std::vector<Candidate> candidates;
  for (int angle = 0; angle < static_cast<int>(task.points.size()); ++angle) {
    for (int y = -task.radius; y <= task.radius; y += 1 << level) {
      for (int x = -task.radius; x <= task.radius; x += 1 << level) {
        const int total = sum(task.points[angle], level, x, y);
        if (total > task.least) candidates.push_back({level, angle, x, y, total});
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.sum > b.sum; });
  return candidates;
}

void CorrelativeSearch::descend(const Candidate& candidate, Task& task) const {
  if (candidate.sum <= task.least) return;
  if (candidate.level == 0) {
    if (task.is_excluded(candidate)) return;
    task.found = candidate, task.least = candidate.sum;
    return;
  }
  const int level = candidate.level - 1, half = 1 << level;
  std::array<Candidate, 4> parts;
  std::size_t count = 0;
  for (const int dy : {0, half}) {
    for (const int dx : {0, half}) {
      const int x = candidate.x + dx, y = candidate.y + dy;
      if (x > task.radius || y > task.radius) continue;
      parts[count++] = {level, candidate.angle, x, y,
                        sum(task.points[candidate.angle], level, x, y)};
    }
  }
  std::stable_sort(parts.begin(), parts.begin() + count,
                   [](const Candidate& a, const Candidate& b) { return a.sum > b.sum; });
  for (std::size_t i = 0; i < count; ++i) descend(parts[i], task);
}

std::optional<CorrelativeSearch::Candidate> CorrelativeSearch::best(Task& task) const {
  task.found.reset();
  for (const Candidate& candidate : coarsest(task)) descend(candidate, task);
  return task.found;
}

std::optional<SearchResult> CorrelativeSearch::find(const LevelPoints& points,
                                                    const PlanarPose& guess,
                                                    const SearchWindow& window,
                                                    double second_share) const {
  if (points.empty() || columns_ <= 0) return std::nullopt;
  double farthest = 1.0;
  for (const LevelPoint& p : points)
    farthest = std::max(farthest, static_cast<double>(std::hypot(p.x_m, p.y_m)));
  const double step_rad = 1.4 * kCell_m / std::min(farthest, 12.0);
  const int steps = static_cast<int>(std::ceil(std::min(M_PI, window.angle_rad) / step_rad));
  Task task;
  for (int i = -steps; i <= steps; ++i) {
    const double yaw = guess.yaw_rad + i * step_rad, c = std::cos(yaw), s = std::sin(yaw);
    task.yaws.push_back(yaw);
    Offsets& cells = task.points.emplace_back();
    cells.reserve(points.size());
    for (const LevelPoint& p : points)
      cells.emplace_back(cell_of(guess.x_m + c * p.x_m - s * p.y_m),
                         cell_of(guess.y_m + s * p.x_m + c * p.y_m));
  }
  task.radius = std::max(1, static_cast<int>(std::ceil(window.radius_m / kCell_m)));
  const double full = static_cast<double>(kFull) * static_cast<double>(points.size());
  task.least = static_cast<int>(window.least_score * full);
  const auto first = best(task);
  if (!first) return std::nullopt;
  const auto pose_of = [&](const Candidate& candidate) {
    return PlanarPose{guess.x_m + candidate.x * kCell_m, guess.y_m + candidate.y * kCell_m,
                      wrapped(task.yaws[candidate.angle])};
  };
  SearchResult result{pose_of(*first), first->sum / full, 0.0, {}};
  if (second_share <= 0.0) return result;
  task.excluded = first, task.least = static_cast<int>(second_share * first->sum);
  if (const auto second = best(task)) {
    result.second_score = second->sum / full;
    result.T_map_base_second = pose_of(*second);
  }
  return result;
}

LevelPoints thinned(const LevelPoints& points, double spacing_m) {
  tsl::robin_map<std::uint64_t, bool, KeyHash> taken;
  LevelPoints kept;
  for (const LevelPoint& p : points) {
    const auto x = static_cast<std::uint32_t>(floor_to_int(p.x_m / spacing_m));
    const auto y = static_cast<std::uint32_t>(floor_to_int(p.y_m / spacing_m));
    if (taken.emplace((static_cast<std::uint64_t>(x) << 32) | y, true).second) kept.push_back(p);
  }
  return kept;
}

}  // namespace ribbon_mapper::slam
