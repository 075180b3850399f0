// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/line_poses.hpp"

#include <tf2/exceptions.h>

#include <stdexcept>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

/// Never leaves find_line_poses(): five lookups in a row read best without a test after each.
struct LookupFailure {
  MissingTransform missing;
};

MissingTransform missing_transform(const tf2::BufferCore& tf, const std::string& target,
                                   const std::string& source, const std::string& detail) {
  for (const std::string& frame : {source, target}) {
    if (!tf._frameExists(frame)) return {"frame " + shown(frame) + " is not in tf", detail};
  }
  return {"no transform from " + shown(source) + " to " + shown(target) + " at its time", detail};
}

MissingTransform missing_link(const std::string& target, const std::string& source,
                              const std::string& detail) {
  return {"no transform connects " + shown(source) + " and " + shown(target) +
              ": they are in two trees of tf",
          detail};
}

Pose lookup(const tf2::BufferCore& tf, const std::string& target, const std::string& source,
            Time time) {
  try {
    return pose_of(tf.lookupTransform(target, source, stamp_of(time)).transform);
  } catch (const tf2::ConnectivityException& error) {
    throw LookupFailure{missing_link(target, source, shown(error.what(), 300))};
  } catch (const std::runtime_error& error) {  // of tf2; of ROS if times are 68 years apart
    throw LookupFailure{missing_transform(tf, target, source, shown(error.what(), 300))};
  }
}

}  // namespace

std::variant<LinePoses, MissingTransform> find_line_poses(const tf2::BufferCore& tf,
                                                          const Frames& frames,
                                                          const std::string& laser_frame,
                                                          const LaserBeams& beams) {
  const Time first = beams.stamp, last = end_of(beams);
  try {
    LinePoses poses;
    poses.T_base_laser_first = lookup(tf, frames.base, laser_frame, first);
    poses.T_base_laser_last = lookup(tf, frames.base, laser_frame, last);
    poses.T_odom_base_first = lookup(tf, frames.odom, frames.base, first);
    poses.T_odom_base_last = lookup(tf, frames.odom, frames.base, last);
    poses.T_map_base = lookup(tf, frames.map, frames.base, middle_of(beams));
    return poses;
  } catch (const LookupFailure& failure) {
    return failure.missing;
  }
}

}  // namespace ribbon_mapper
