// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag/bag_lines.hpp"

#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <stdexcept>

#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/transform_entry.hpp"

namespace ribbon_mapper {
namespace {

using Scan = sensor_msgs::LaserScan;

bool is_scan(const BagTopic& topic) {
  return topic.md5 == ros::message_traits::md5sum<Scan>() && topic.messages > 0;
}

std::string list_of(const std::vector<BagTopic>& topics) {
  std::string list;
  for (const BagTopic& topic : topics) {
    if (is_scan(topic)) list += (list.empty() ? "" : ", ") + topic.name;
  }
  return list.empty() ? "there is no topic with sensor_msgs/LaserScan in the bag"
                      : "topics with scans are " + list;
}

}  // namespace

std::string scan_topic_of(const std::vector<BagTopic>& topics, const std::string& wanted) {
  const std::string name = without_slash(wanted.empty() ? "tilt_scan" : wanted);
  std::vector<std::string> scans;
  for (const BagTopic& topic : topics) {
    if (is_scan(topic)) scans.push_back(topic.name);
    if (without_slash(topic.name) != name) continue;
    if (is_scan(topic)) return topic.name;
    if (wanted.empty()) continue;
    const std::string fault = topic.messages == 0 ? "is empty" : "carries " + topic.type;
    throw std::runtime_error("topic " + topic.name + " " + fault + ": " + list_of(topics));
  }
  if (wanted.empty() && scans.size() == 1) return scans.front();
  throw std::runtime_error((wanted.empty() ? "which laser? " : "no topic " + wanted + ": ") +
                           list_of(topics));
}

BagLines::BagLines(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
                   LineLog& log)
    : bags_(bags),
      options_(options),
      intake_(options.intake, log),
      tf_(ros::Duration(options.tf_cache_s)),
      scan_topic_(scan_topic_of(bags_.topics(), options.scan_topic)) {
  bags_.read({"/tf_static", "tf_static"}, [this](const rosbag::MessageInstance& message) {
    if (const auto fixed = message.instantiate<tf2_msgs::TFMessage>()) {
      refused_ += enter_transforms(*fixed, true, options_.tf_drop_frames, tf_);
    }
    return true;
  });
  line_count_ = bags_.view({scan_topic_})->size();
  messages_ = bags_.view({scan_topic_, "/tf", "tf"});
  at_ = messages_->begin();
}

BagLines::~BagLines() = default;

std::optional<ReadyLine> BagLines::next() {
  try {
    for (;;) {
      if (auto line = intake_.take_next(tf_, now_)) return line;
      if (at_ == messages_->end()) return intake_.take_next_at_end(tf_);
      take(*at_);
      ++at_;
    }
  } catch (const ros::Exception& error) {
    throw damaged_bag(error);
  }
}

void BagLines::take(const rosbag::MessageInstance& message) {
  now_ = Moment::recorded(message.getTime());
  if (message.getTopic() != scan_topic_) {
    if (const auto moving = message.instantiate<tf2_msgs::TFMessage>()) {
      refused_ += enter_transforms(*moving, false, options_.tf_drop_frames, tf_);
    }
  } else if (const auto scan = message.instantiate<Scan>()) {
    intake_.add(*scan, now_);
  }
}

}  // namespace ribbon_mapper
