// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag/bag_lines.hpp"

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>

#include <stdexcept>

#include "modeler/ros/bag/bag_message.hpp"
#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

using Scan = sensor_msgs::LaserScan;

constexpr int kMaxScansForFrame = 100;

/// Returns the pose of odometry as tf has it.
tf2_msgs::TFMessage transform_of(const nav_msgs::Odometry& odometry) {
  tf2_msgs::TFMessage message;
  geometry_msgs::TransformStamped& transform = message.transforms.emplace_back();
  transform.header = odometry.header;
  transform.child_frame_id = odometry.child_frame_id;
  transform.transform.translation.x = odometry.pose.pose.position.x;
  transform.transform.translation.y = odometry.pose.pose.position.y;
  transform.transform.translation.z = odometry.pose.pose.position.z;
  transform.transform.rotation = odometry.pose.pose.orientation;
  return message;
}

}  // namespace

BagLines::BagLines(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
                   LineLog& log)
    : bags_(bags),
      options_(options),
      scan_topic_(scan_topic_of(bags_.topics(), options.scan_topic)),
      tf_topics_(tf_topics_of(bags_.topics(), options.tf_topic, scan_topic_)),
      transforms_(options.tf_drop_frames, options.max_transforms),
      intake_(with_frames_chosen(), log),
      tf_(ros::Duration(options.tf_cache_s)) {
  transforms_.enter_fixed(tf_);
  scans_ = bags_.view({scan_topic_});
  line_count_ = scans_->size();
  at_ = scans_->begin();
}

BagLines::~BagLines() = default;

void BagLines::read_transforms() {
  for (const bool is_static : {true, false}) {
    bags_.read(is_static ? tf_topics_.fixed : tf_topics_.moving,
               [&](const rosbag::MessageInstance& message) {
                 if (const auto tf = message_of<tf2_msgs::TFMessage>(message))
                   transforms_.add(*tf, is_static, time_of(message.getTime()));
                 return true;
               });
  }
  if (!options_.odometry_topic.empty()) read_odometry();
  find_laser_frame();
  if (transforms_.is_full()) read_again();
  transforms_.finish();
}

/// Adds the poses of odometry. Throws std::runtime_error if there are none.
void BagLines::read_odometry() {
  std::size_t count = 0;
  bags_.read({options_.odometry_topic}, [&](const rosbag::MessageInstance& message) {
    if (const auto odometry = message_of<nav_msgs::Odometry>(message)) {
      transforms_.add(transform_of(*odometry), false, time_of(message.getTime()));
      ++count;
    }
    return true;
  });
  if (count > 0) return;
  throw std::runtime_error("no odometry on topic " + shown(options_.odometry_topic) +
                           ": set it to a topic of nav_msgs/Odometry, see `rosbag info`");
}

/// Keeps only the transforms between the root and the frames in use.
void BagLines::read_again() {
  std::set<std::string> laser_frames, children;
  bags_.read({scan_topic_}, [&](const rosbag::MessageInstance& message) {
    if (const auto scan = message_of<Scan>(message))
      laser_frames.insert(without_slash(scan->header.frame_id));
    return true;
  });
  const Frames& frames = options_.intake.frames;
  laser_frames.insert({frames.map, frames.odom, frames.base});
  for (const std::string& frame : laser_frames) {
    const std::vector<std::string> chain = transforms_.tree().chain_from(frame);
    children.insert(chain.begin(), chain.end());
  }
  transforms_.forget_moving();
  bags_.read(tf_topics_.moving, [&](const rosbag::MessageInstance& message) {
    if (const auto tf = message_of<tf2_msgs::TFMessage>(message))
      transforms_.add_again(*tf, children);
    return true;
  });
}

/// Takes the frame of the first scan whose frame is in tf.
void BagLines::find_laser_frame() {
  int scans = 0;
  bags_.read({scan_topic_}, [&](const rosbag::MessageInstance& message) {
    const auto scan = message_of<Scan>(message);
    if (!scan) return true;
    const std::string frame = without_slash(scan->header.frame_id);
    const bool is_known = transforms_.tree().has(frame);
    if (laser_frame_.empty() || is_known) laser_frame_ = frame;
    return !is_known && ++scans < kMaxScansForFrame;
  });
}

IntakeOptions BagLines::with_frames_chosen() {
  if (!tf_topics_.note.empty()) choices_.push_back(tf_topics_.note);
  read_transforms();
  const FrameTree& tree = transforms_.tree();
  Frames& frames = options_.intake.frames;
  const std::string missing = missing_frames(tree, frames);
  if (missing.empty() || transforms_.links().empty()) return options_.intake;
  const std::string lack = "tf has no frame " + missing + ", but " + tree.text(laser_frame_);
  const auto chosen = choose_frames(tree, laser_frame_, frames, options_.named_frames);
  if (!chosen) {
    const NamedFrames& named = options_.named_frames;
    const bool is_named = named.map || named.odom || named.base;
    choices_.push_back(lack + ": set --map-frame, --odom-frame and --base-frame" +
                       (is_named ? ", or leave out those that you have set" : ""));
    return options_.intake;
  }
  std::string text = lack + ": " + settings_text(frames, *chosen, "--", "-frame ");
  text += " is taken, the only choice";
  if (chosen->map == chosen->base) {
    text += ": without odometry, the robot is taken to stand still";
  } else if (chosen->map == chosen->odom) {
    text += ": there is no localisation, so drift stays unless a trajectory corrects it";
  }
  choices_.push_back(text);
  frames = *chosen;
  return options_.intake;
}

std::optional<ReadyLine> BagLines::next() {
  try {
    for (;;) {
      if (auto line = intake_.take_next_at_end(tf_)) return line;
      if (at_ == scans_->end()) return std::nullopt;
      const auto scan = message_of<Scan>(*at_);
      const Moment recorded = Moment::recorded(at_->getTime());
      ++at_;
      if (!scan) continue;
      intake_.add(*scan, recorded);
      if (!find_defect(*scan)) enter_transforms_around(*scan);
    }
  } catch (const ros::Exception& error) {
    throw damaged_bag(error);
  }
}

void BagLines::enter_transforms_around(const Scan& scan) {
  const double duration_s = scan.time_increment * static_cast<double>(scan.ranges.size() - 1);
  const Time first = time_of(scan.header.stamp) + from_seconds(options_.intake.scan_time_offset_s);
  const Time until = first + from_seconds(duration_s + options_.intake.transform_timeout_s);
  transforms_.enter(first, until, options_.tf_cache_s, tf_);
}

}  // namespace ribbon_mapper
