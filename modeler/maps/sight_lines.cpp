// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/maps/sight_lines.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

/// Appends what the lines saw, one after the other.
class SightLinesBuilder {
 public:
  SightLinesBuilder(const PosedObservations& observations, const PlaneModel& model,
                    const MapsConfig& config, const Eigen::Vector3d& origin)
      : observations_(observations),
        is_loose_(observations.ribbon_count(), true),
        margin_m_(config.surface_margin_m) {
    for (const Plane& plane : model.planes) {
      for (const std::uint32_t ribbon : plane.ribbons) is_loose_[ribbon] = false;
    }
    for (const std::uint32_t ribbon : model.gone_ribbons) is_loose_[ribbon] = false;
    result_.origin = origin;
    T_origin_model_ = Eigen::Translation3d(-origin) * observations.T_map_model();
    result_.fans.reserve(observations.ribbon_count());
    result_.lines.reserve(observations.unassigned().size());
    result_.bases.reserve(observations.unassigned().size());
  }

  SightLines build() {
    for (const UnassignedPoints& points : observations_.unassigned()) add_line(points);
    return std::move(result_);
  }

 private:
  void add_line(const UnassignedPoints& points) {
    const Pose T_origin_base = T_origin_model_ * observations_.T_model_base(points.pose);
    const Eigen::Vector3d sensor = T_origin_base * points.sensor.cast<double>();
    for (; ribbon_ < observations_.ribbon_count(); ++ribbon_) {
      const Ribbon& ribbon = observations_.source(ribbon_);
      if (ribbon.pose != points.pose) break;
      add_ribbon({ribbon, T_origin_base}, sensor);
    }
    for (const PackedPoint& point : points) {
      const Eigen::Vector3d place = T_origin_base * points.point(point).cast<double>();
      result_.returns.push_back({place.cast<float>(), false});
    }
    result_.lines.push_back({sensor.cast<float>(), static_cast<std::uint32_t>(result_.fans.size()),
                             static_cast<std::uint32_t>(result_.returns.size())});
    result_.bases.emplace_back(T_origin_base.translation().cast<float>());
  }

  void add_ribbon(const PosedSamples& ribbon, const Eigen::Vector3d& sensor) {
    const RibbonSamples& samples = ribbon.samples();
    const double height_m = std::abs(ribbon.normal.dot(sensor - ribbon.centroid));
    const double free_part = height_m > margin_m_ ? 1.0 - margin_m_ / height_m : 0.0;
    result_.fans.push_back({ribbon.point(samples.start_m, 0.0F).cast<float>(),
                            ribbon.point(samples.start_m + samples.length_m(), 0.0F).cast<float>(),
                            static_cast<float>(free_part)});
    if (!is_loose_[ribbon_]) return;
    samples.for_each([&](float along_m, float height, std::uint32_t) {
      result_.returns.push_back({ribbon.point(along_m, height).cast<float>(), true});
    });
  }

  const PosedObservations& observations_;
  std::vector<bool> is_loose_;  // by ribbon
  double margin_m_;
  Pose T_origin_model_ = Pose::Identity();
  std::size_t ribbon_ = 0;  // the next one
  SightLines result_;
};

}  // namespace

std::size_t SightLines::memory_bytes() const {
  return lines.capacity() * sizeof(SightLine) + fans.capacity() * sizeof(Fan) +
         returns.capacity() * sizeof(LooseReturn) + bases.capacity() * sizeof(Eigen::Vector3f);
}

SightLines sight_lines_of(const PosedObservations& observations, const PlaneModel& model,
                          const MapsConfig& config, const Eigen::Vector3d& origin) {
  return SightLinesBuilder(observations, model, config, origin).build();
}

}  // namespace ribbon_mapper
