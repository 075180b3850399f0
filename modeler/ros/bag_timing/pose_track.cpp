// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_timing/pose_track.hpp"

namespace ribbon_mapper {
namespace {

constexpr Time kStep = std::chrono::milliseconds(5);

}  // namespace

PoseTrack::PoseTrack(const tf2::BufferCore& tf, const Frames& frames,
                     const std::string& laser_frame, Time from, Time to)
    : from_(from) {
  LaserBeams instant;
  for (instant.stamp = from; instant.stamp <= to; instant.stamp += kStep) {
    std::optional<Sample> sample;
    if (instant.stamp > Time(0)) {
      const auto found = find_line_poses(tf, frames, laser_frame, instant);
      if (const auto* poses = std::get_if<LinePoses>(&found)) {
        sample = Sample{poses->T_odom_base_first, poses->T_base_laser_first, poses->T_map_base};
      }
    }
    samples_.push_back(sample);
  }
}

std::optional<PoseTrack::Sample> PoseTrack::at(Time time) const {
  if (time < from_) return std::nullopt;
  const auto before = static_cast<std::size_t>((time - from_) / kStep);
  if (before + 1 >= samples_.size() || !samples_[before] || !samples_[before + 1]) {
    return std::nullopt;
  }
  const double share = to_seconds((time - from_) % kStep) / to_seconds(kStep);
  const Sample &a = *samples_[before], &b = *samples_[before + 1];
  return Sample{interpolate(a.T_odom_base, b.T_odom_base, share),
                interpolate(a.T_base_laser, b.T_base_laser, share),
                interpolate(a.T_map_base, b.T_map_base, share)};
}

std::optional<LinePoses> PoseTrack::poses_of(const LaserBeams& beams) const {
  const auto first = at(beams.stamp), last = at(end_of(beams)), middle = at(middle_of(beams));
  if (!first || !last || !middle) return std::nullopt;
  return LinePoses{first->T_odom_base, last->T_odom_base, first->T_base_laser, last->T_base_laser,
                   middle->T_map_base};
}

}  // namespace ribbon_mapper
