// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>

#include "modeler/polygon/polygon.hpp"

namespace ribbon_mapper {

/// An area that is asked about many points. GEOS indexes its edges.
class PreparedArea {
 public:
  /// Prepares the area of polygons, which may touch but not overlap. Throws as the operations on
  /// polygons do.
  explicit PreparedArea(const Polygons& polygons);
  ~PreparedArea();
  PreparedArea(const PreparedArea&) = delete;
  PreparedArea& operator=(const PreparedArea&) = delete;

  /// Returns true if a point is in the area or on its boundary.
  bool holds(const Eigen::Vector2d& point) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace ribbon_mapper
