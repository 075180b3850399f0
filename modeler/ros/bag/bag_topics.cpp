// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag/bag_topics.hpp"

#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <stdexcept>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

using Names = std::vector<std::string>;

bool is_scan(const BagTopic& topic) {
  return topic.md5 == ros::message_traits::md5sum<sensor_msgs::LaserScan>() && topic.messages > 0;
}

bool is_tf(const BagTopic& topic) {
  return topic.md5 == ros::message_traits::md5sum<tf2_msgs::TFMessage>() && topic.messages > 0;
}

std::string last_part(const std::string& topic) { return topic.substr(topic.rfind('/') + 1); }

/// Returns what stands before the last part of a topic, with its slash.
std::string space_of(const std::string& topic) { return topic.substr(0, topic.rfind('/') + 1); }

/// Returns the names of all topics for which `is_such` holds.
template <typename Condition>
Names names_of(const std::vector<BagTopic>& topics, const Condition& is_such) {
  Names names;
  for (const BagTopic& topic : topics) {
    if (is_such(topic)) names.push_back(topic.name);
  }
  return names;
}

std::string list_of(const Names& names) {
  constexpr std::size_t kMaxListed = 10;
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < kMaxListed; ++i)
    list += (i == 0 ? "" : ", ") + shown(names[i]);
  return names.size() > kMaxListed ? list + ", ..." : list;
}

std::string scans_text(const std::vector<BagTopic>& topics) {
  const Names scans = names_of(topics, is_scan);
  return scans.empty() ? "there is no topic with sensor_msgs/LaserScan in the bag"
                       : "topics with scans are " + list_of(scans);
}

bool is_called(const BagTopic& topic, const std::string& name) {
  return without_slash(topic.name) == without_slash(name);
}

TfTopics below(const std::string& topic, const std::string& note) {
  return {{topic}, {space_of(topic) + "tf_static", "/tf_static", "tf_static"}, note};
}

}  // namespace

std::string scan_topic_of(const std::vector<BagTopic>& topics, const std::string& wanted) {
  for (const BagTopic& topic : topics) {
    if (!is_called(topic, wanted.empty() ? "tilt_scan" : wanted)) continue;
    if (is_scan(topic)) return topic.name;
    if (wanted.empty()) continue;
    const std::string fault = topic.messages == 0 ? "is empty" : "carries " + shown(topic.type);
    throw std::runtime_error("topic " + shown(topic.name) + " " + fault + ": " +
                             scans_text(topics));
  }
  if (!wanted.empty()) {
    throw std::runtime_error("no topic " + shown(wanted) + ": " + scans_text(topics));
  }
  const Names scans = names_of(topics, is_scan);
  if (scans.size() == 1) return scans.front();
  const Names tilting = names_of(topics, [](const BagTopic& topic) {
    return is_scan(topic) && last_part(topic.name) == "tilt_scan";
  });
  if (tilting.size() == 1) return tilting.front();
  throw std::runtime_error("which laser? " + scans_text(topics));
}

TfTopics tf_topics_of(const std::vector<BagTopic>& topics, const std::string& wanted,
                      const std::string& scan_topic) {
  const Names found = names_of(topics, [](const BagTopic& topic) {
    return is_tf(topic) && last_part(topic.name) != "tf_static";
  });
  for (const BagTopic& topic : topics) {
    if (is_called(topic, wanted.empty() ? "tf" : wanted) && is_tf(topic))
      return below(topic.name, "");
  }
  if (!wanted.empty()) {
    throw std::runtime_error("no transforms on topic " + shown(wanted) + ": " +
                             (found.empty() ? "there are none in the bag"
                                            : "topics with transforms are " + list_of(found)));
  }
  if (found.empty()) return below("/tf", "");
  const std::string with_space = space_of(scan_topic) + "tf";
  for (const std::string& name : found) {
    if (found.size() > 1 && name != with_space) continue;
    return below(name, "there is no /tf: --tf-topic " + shown(name) + " is taken, " +
                           (found.size() > 1 ? "beside the scans" : "the only choice"));
  }
  return below("/tf", "there is no /tf: set --tf-topic to one of " + list_of(found));
}

}  // namespace ribbon_mapper
