// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/cell_grid.hpp"

#include <algorithm>

namespace ribbon_mapper {
namespace {

/// Largest share of the fullest neighbour's count that noise carries into a cell, for a noise
/// within the plane of 0.4 cells.
constexpr float kSpilledShare = 0.05F;

template <int rows, int columns>
using Counts = Eigen::Array<float, rows, columns, Eigen::RowMajor>;

/// A coordinate along an axis of the grid in fixed-point arithmetic, with a resolution of 2^-32 of
/// a cell. Multiplication and rounding down take a single instruction each.
class FixedPoint {
 public:
  explicit FixedPoint(double cells) : parts_(static_cast<std::int64_t>(cells * kOne)) {}

  int floor() const { return static_cast<int>(parts_ >> 32); }
  FixedPoint operator+(FixedPoint other) const { return FixedPoint(parts_ + other.parts_); }
  friend FixedPoint operator*(int factor, FixedPoint x) { return FixedPoint(factor * x.parts_); }

 private:
  static constexpr double kOne = 4294967296.0;  // 2^32, one cell
  explicit FixedPoint(std::int64_t parts) : parts_(parts) {}

  std::int64_t parts_;
};

}  // namespace

/// A tile and the smallest count of each of its cells for which the cell counts as seen. Smaller
/// counts are attributed to noise at the edge of what was seen.
struct CellGrid::Screened {
  static constexpr int kSide = kTileSide;

  /// Returns the counts of a tile as a matrix, without copying them.
  static auto counts_of(const Tile& other) {
    constexpr int kSize = sizeof(Sums) / sizeof(float);
    using Strides = Eigen::Stride<kSide * kSize, kSize>;
    return Eigen::Map<const Counts<kSide, kSide>, 0, Strides>(&other.sums.front().count);
  }

  Screened(const TwoSidedVector<TileRow>& tiles, int row, int column) {
    // The counts of the tile and of the cells around it.
    Counts<kSide + 2, kSide + 2> counts = Counts<kSide + 2, kSide + 2>::Zero();
    for (int dv = -1; dv <= 1; ++dv) {
      const TileRow* const tile_row = tiles.find(row + dv);
      if (!tile_row) continue;
      for (int du = -1; du <= 1; ++du) {
        const auto* const other = tile_row->find(column + du);
        if (!other || !*other) continue;
        const Side u(du), v(dv);
        counts.block(v.to, u.to, v.length, u.length) =
            counts_of(**other).block(v.from, u.from, v.length, u.length);
      }
    }
    const Counts<kSide + 2, kSide> max_in_row =
        counts.leftCols<kSide>().max(counts.middleCols<kSide>(1)).max(counts.rightCols<kSide>());
    const Counts<kSide, kSide> max_counts = max_in_row.topRows<kSide>()
                                                .max(max_in_row.middleRows<kSide>(1))
                                                .max(max_in_row.bottomRows<kSide>());
    min_counts = (kSpilledShare * max_counts).max(1.0F);
    tile = tiles.find(row)->find(column)->get();
  }

  const Tile* tile;
  Counts<kSide, kSide> min_counts;

 private:
  /// The range to copy from the neighbour at d = -1, 0 or 1 along one axis.
  struct Side {
    explicit Side(int d)
        : from(d < 0 ? kSide - 1 : 0),
          to(d == 0  ? 1
             : d < 0 ? 0
                     : kSide + 1),
          length(d == 0 ? kSide : 1) {}
    int from, to, length;
  };
};

CellGrid::CellGrid(const Plane& frame) {
  to_grid_.row(0) = frame.axis_u.transpose() / frame.cell_size_m;
  to_grid_.row(1) = frame.axis_v.transpose() / frame.cell_size_m;
  to_grid_.row(2) = frame.normal.transpose();
  grid_shift_ = -to_grid_ * frame.origin;
}

CellGrid::Tile& CellGrid::tile_of(int u, int v) {
  const int column = u >> kTileBits, row = v >> kTileBits;
  std::unique_ptr<Tile>& tile = tiles_.at(row).at(column);
  if (!tile) tile = std::make_unique<Tile>(column * kTileSide, row * kTileSide);
  return *tile;
}

// Along a ribbon, grid positions are linear in the number of steps. Heights do not move a sample to
// another cell, because the ribbon is nearly parallel to the plane.
void CellGrid::add(const PosedSamples& ribbon) {
  const RibbonSamples& samples = ribbon.samples();
  const Eigen::Vector3d start = grid_position(ribbon.point(samples.start_m, 0.0F));
  const Eigen::Vector3d step = to_grid_ * (RibbonSamples::kAlongStep_m * ribbon.along);
  const FixedPoint u_start(start.x()), v_start(start.y()), u_step(step.x()), v_step(step.y());
  const auto first_m = static_cast<float>(start.z()), step_m = static_cast<float>(step.z());
  const auto height_step_m =
      static_cast<float>(to_grid_.row(2).dot(ribbon.normal) * samples.height_step_m);
  const float own_square_m2 = samples.variance_m2;
  Tile* tile = &tile_of(u_start.floor(), v_start.floor());
  samples.for_each_packed([&](int steps, const PackedSample& sample) {
    const int u = (u_start + steps * u_step).floor(), v = (v_start + steps * v_step).floor();
    if (!tile->covers(u, v)) tile = &tile_of(u, v);
    const float distance_m =
        first_m + static_cast<float>(steps) * step_m + sample.height * height_step_m;
    tile->at(u, v).add(sample.count, distance_m, own_square_m2);
  });
}

/// Appends the cells of a row of tiles, sorted by (v, u).
void CellGrid::append_cells(int row, std::vector<PlaneCell>& cells) const {
  const TileRow& tile_row = *tiles_.find(row);
  std::vector<Screened> tiles;
  for (int column = tile_row.begin(); column < tile_row.end(); ++column) {
    if (*tile_row.find(column)) tiles.emplace_back(tiles_, row, column);
  }
  for (int v = 0; v < kTileSide; ++v) {
    for (const Screened& screened : tiles) {
      for (int u = 0; u < kTileSide; ++u) {
        const Sums& sums = screened.tile->sums[v * kTileSide + u];
        if (sums.count < screened.min_counts(v, u)) continue;
        const float mean = sums.distance_m / sums.count;
        const float variance = std::max(0.0F, sums.square_m2 / sums.count - mean * mean);
        cells.push_back({screened.tile->u0 + u, screened.tile->v0 + v,
                         static_cast<std::uint32_t>(sums.count), mean, variance});
      }
    }
  }
}

std::vector<PlaneCell> CellGrid::cells() const {
  std::vector<PlaneCell> cells;
  for (int row = tiles_.begin(); row < tiles_.end(); ++row) append_cells(row, cells);
  return cells;
}

}  // namespace ribbon_mapper
