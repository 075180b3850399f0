// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag/bag_set.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <stdexcept>
#include <tuple>

#include "modeler/ros/bag/bag_structure.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReindex =
    ": it was not closed when the recording ended; run `rosbag reindex FILE` on a copy";

std::unique_ptr<rosbag::Bag> open(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw std::runtime_error(file.string() + ": there is no such file");
  if (!fs::is_regular_file(file, error)) throw std::runtime_error(file.string() + ": is no file");
  if (fs::file_size(file, error) == 0) throw std::runtime_error(file.string() + ": is empty");
  if (::access(file.c_str(), R_OK) != 0) {
    throw std::runtime_error(file.string() + ": cannot be read: " + std::strerror(errno));
  }
  try {
    check_bag_structure(file);
    return std::make_unique<rosbag::Bag>(file.string(), rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error(file.string() + ": has no index" + kReindex);
  } catch (const std::exception& exception) {
    throw std::runtime_error(file.string() + ": is no bag, or cut short (" + exception.what() +
                             "); copy it again, or try `rosbag reindex FILE` on a copy");
  }
}

}  // namespace

std::runtime_error damaged_bag(const std::exception& error) {
  return std::runtime_error(std::string("the bag is damaged (") + error.what() +
                            "); copy it again, or try `rosbag fix` or `rosbag reindex` on a copy");
}

BagSet::BagSet(const std::vector<fs::path>& files) {
  if (files.empty()) throw std::runtime_error("no bag is given");
  for (const fs::path& file : files) bags_.push_back(open(file));
}

std::vector<BagTopic> BagSet::topics() const {
  std::map<std::tuple<std::string, std::string>, BagTopic> found;
  for (const auto& bag : bags_) {
    rosbag::View all(*bag);
    for (const rosbag::ConnectionInfo* info : all.getConnections()) {
      BagTopic& topic = found[{info->topic, info->md5sum}];
      topic.name = info->topic, topic.type = info->datatype, topic.md5 = info->md5sum;
    }
  }
  for (auto& entry : found) {
    BagTopic& topic = entry.second;
    for (const auto& bag : bags_) {
      rosbag::View view(*bag, [&](const rosbag::ConnectionInfo* info) {
        return info->topic == topic.name && info->md5sum == topic.md5;
      });
      topic.messages += view.size();
    }
  }
  std::vector<BagTopic> topics;
  for (const auto& [key, topic] : found) topics.push_back(topic);
  return topics;
}

std::unique_ptr<rosbag::View> BagSet::view(const std::vector<std::string>& topics) const {
  auto view = std::make_unique<rosbag::View>();
  for (const auto& bag : bags_) view->addQuery(*bag, rosbag::TopicQuery(topics));
  return view;
}

void BagSet::read(const std::vector<std::string>& topics,
                  const std::function<bool(const rosbag::MessageInstance&)>& take) const {
  try {
    const std::unique_ptr<rosbag::View> messages = view(topics);
    for (const rosbag::MessageInstance& message : *messages) {
      if (!take(message)) return;
    }
  } catch (const ros::Exception& error) {
    throw damaged_bag(error);
  }
}

}  // namespace ribbon_mapper
