// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/correction/ribbon_floor.hpp"

#include "modeler/observations/posed_ribbon.hpp"

namespace ribbon_mapper::bench {

RibbonFloor::RibbonFloor(const Modeler& modeler) {
  for (const Ribbon& ribbon : modeler.ribbons()) {
    const double w = ribbon.moments.weight();
    const Eigen::Vector3d mean = ribbon.moments.mean(), sum = w * mean;
    const Eigen::Matrix3d m = w * (ribbon.moments.covariance() + mean * mean.transpose());
    const auto first = static_cast<std::uint32_t>(sample_points_.size());
    const PosedRibbon here(ribbon, Pose::Identity());
    ribbon.samples.for_each([&](float along_m, float height_m, std::uint32_t) {
      sample_points_.push_back(here.point(along_m, height_m).cast<float>());
    });
    sources_.push_back(
        {{w, sum.x(), sum.y(), sum.z(), m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)},
         ribbon.pose,
         first,
         static_cast<std::uint32_t>(sample_points_.size())});
  }
  moved_sums_.resize(sources_.size());
  moved_points_.resize(sample_points_.size());
}

void RibbonFloor::move(const std::vector<StampedPose>& trajectory) {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& source = sources_[i];
    const Sums& s = source.sums;
    const Pose& T_map_base = trajectory[source.pose].T_map_base;
    const Eigen::Matrix3d R = T_map_base.linear();
    const Eigen::Vector3d t = T_map_base.translation();
    Eigen::Matrix3d m;
    m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    const Eigen::Vector3d rotated = R * Eigen::Vector3d(s.x, s.y, s.z);
    const Eigen::Vector3d half = rotated + (0.5 * s.weight) * t;
    const Eigen::Matrix3d A = R * m;
    const auto moment = [&](int a, int b) {
      return A.row(a).dot(R.row(b)) + half[a] * t[b] + t[a] * half[b];
    };
    moved_sums_[i] = {s.weight,
                      rotated.x() + s.weight * t.x(),
                      rotated.y() + s.weight * t.y(),
                      rotated.z() + s.weight * t.z(),
                      moment(0, 0),
                      moment(0, 1),
                      moment(0, 2),
                      moment(1, 1),
                      moment(1, 2),
                      moment(2, 2)};
    const Eigen::Matrix3f Rf = R.cast<float>();
    const Eigen::Vector3f tf = t.cast<float>();
    for (std::uint32_t k = source.first_sample; k < source.end_sample; ++k) {
      moved_points_[k].noalias() = Rf * sample_points_[k] + tf;
    }
  }
}

}  // namespace ribbon_mapper::bench
