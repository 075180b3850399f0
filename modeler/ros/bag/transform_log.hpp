// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "modeler/geometry/time.hpp"
#include "modeler/ros/intake/frame_tree.hpp"
#include "modeler/ros/messages/transform_entry.hpp"

namespace ribbon_mapper {

/// A transform with numbers in place of names: 72 bytes.
struct LoggedTransform {
  Time stamp{0};             ///< when it holds
  std::uint32_t parent = 0;  ///< see TransformLog
  std::uint32_t child = 0;   ///< the same
  double translation[3]{};   ///< [m]
  double rotation[4]{};      ///< x, y, z, w
};

/// What a recording says about a frame: its parents, and how its transforms came.
struct LoggedLink {
  std::set<std::string> parents;  ///< one, if nothing is wrong
  std::size_t moving = 0;         ///< transforms on /tf
  std::size_t fixed = 0;          ///< transforms on /tf_static
  std::size_t repeated = 0;       ///< of /tf, stamped as one before; these are left out
  std::size_t differing = 0;      ///< repeated ones that say something else than the first
  std::size_t backwards = 0;      ///< of /tf, stamped more than a second before earlier ones
  double longest_gap_s = 0.0;     ///< between successive stamps
  double delay_sum_s = 0.0;       ///< of all on /tf: time of recording minus stamp

  /// Returns how long after their stamps transforms were recorded, on average.
  double delay_s() const { return moving == 0 ? 0.0 : delay_sum_s / static_cast<double>(moving); }
};

/// All transforms of a recording in the order of their stamps: when they were recorded does not
/// matter. A frame that is both static and moving moves.
class TransformLog {
 public:
  /// Creates an empty log that keeps `max_transforms`, of 72 bytes each. Transforms whose parent is
  /// one of `drop_frames` are left out.
  TransformLog(std::set<std::string> drop_frames, std::size_t max_transforms)
      : drop_frames_(std::move(drop_frames)), max_transforms_(max_transforms) {}

  /// Adds the transforms of a message that was recorded at a time.
  void add(const tf2_msgs::TFMessage& message, bool is_static, Time recorded);

  /// Returns whether there are too many moving transforms to keep. The log then has to be told
  /// which frames matter, and needs the messages again; the statistics are complete.
  bool is_full() const;
  /// Forgets the moving transforms of a full log.
  void forget_moving();
  /// Adds the transforms of a message of /tf for the second time, of some child frames only.
  void add_again(const tf2_msgs::TFMessage& message, const std::set<std::string>& children);

  /// Sorts the transforms and leaves out those repeated, or stamped before a time jump. To be
  /// called once, after the last message.
  void finish();

  /// Enters those static transforms into a buffer whose frames do not move.
  void enter_fixed(tf2::BufferCore& buffer);
  /// Enters moving transforms into a buffer that reaches back `cache_s`, so that it holds all
  /// around `from` to `until`. Calls should ask for later and later times; an earlier one than the
  /// buffer holds costs a new beginning.
  void enter(Time from, Time until, double cache_s, tf2::BufferCore& buffer);

  /// Returns the statistics of each child frame.
  const std::map<std::string, LoggedLink>& links() const { return links_; }
  /// Returns the frames.
  const FrameTree& tree() const { return tree_; }
  /// Returns how many transforms were unusable, and the defect of the last one.
  const TransformCounts& counts() const { return counts_; }
  /// Returns the number of messages.
  std::size_t messages() const { return messages_; }
  /// Returns the number of transforms whose frames have a leading slash.
  std::size_t with_slash() const { return with_slash_; }

 private:
  using Transforms = std::vector<LoggedTransform>;
  void store(const geometry_msgs::TransformStamped& transform);
  std::uint32_t number_of(const std::string& frame);
  geometry_msgs::TransformStamped message_of(const LoggedTransform& transform) const;
  void finish(Transforms& transforms, LoggedLink& link);

  std::set<std::string> drop_frames_;
  std::size_t max_transforms_;
  std::map<std::string, LoggedLink> links_;  ///< by child
  FrameTree tree_;
  TransformCounts counts_;
  std::size_t messages_ = 0, with_slash_ = 0, stored_ = 0;
  std::map<std::string, std::uint32_t> numbers_;
  std::vector<std::string> names_;                      ///< by number
  std::vector<geometry_msgs::TransformStamped> fixed_;  ///< in order of recording
  std::map<std::uint32_t, Transforms> moving_;          ///< by child; empty when finished
  Transforms sorted_;                                   ///< by stamp, when finished
  std::size_t next_ = 0;                                ///< to be entered
};

}  // namespace ribbon_mapper
