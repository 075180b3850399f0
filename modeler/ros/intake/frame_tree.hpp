// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "modeler/ros/intake/line_poses.hpp"

namespace ribbon_mapper {

/// The frames of tf, each with its parent.
class FrameTree {
 public:
  FrameTree() = default;  ///< empty
  /// Reads the frames that a buffer holds now.
  explicit FrameTree(const tf2::BufferCore& buffer);

  /// Adds a frame below its parent; the last parent counts.
  void add(const std::string& parent, const std::string& child) { parents_[child] = parent; }

  /// Returns whether tf has a frame.
  bool has(const std::string& frame) const;
  /// Returns a frame, its parent and so on up to the root. A loop ends where it closes.
  std::vector<std::string> chain_from(const std::string& frame) const;
  /// Returns the way from the root to a frame, such as "map -> odom -> base_link". Returns all
  /// links, 20 at most, if tf does not have the frame.
  std::string text(const std::string& frame) const;

 private:
  std::map<std::string, std::string> parents_;  ///< by child
};

/// Which frames were named by the user. Those are never replaced.
struct NamedFrames {
  bool map = false;   ///< Frames::map
  bool odom = false;  ///< Frames::odom
  bool base = false;  ///< Frames::base
};

/// Returns the frames to use if tf lacks some of the wanted ones: those that the user has not named
/// are taken from the way between root and laser if there is only one choice. Odometry is the frame
/// with "odom" in its name, or lies between base and map; the base is the frame below it, or has
/// "base" in its name; the map is the frame above odometry. Without such a frame, odometry is the
/// map too. Without odometry, the base is: the robot then has to stand still. Returns nothing if
/// there are several choices or none. Returns the wanted frames if tf has all of them.
std::optional<Frames> choose_frames(const FrameTree& tree, const std::string& laser_frame,
                                    const Frames& wanted, const NamedFrames& named);

/// Returns the settings that differ, such as "--map-frame odom": each name of a setting is
/// `prefix`, the name of the frame, and `suffix`.
std::string settings_text(const Frames& wanted, const Frames& chosen, const std::string& prefix,
                          const std::string& suffix);

/// Returns which of the frames tf lacks, separated by commas; empty if it has all.
std::string missing_frames(const FrameTree& tree, const Frames& frames);

}  // namespace ribbon_mapper
