// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ribbon_mapper {

/// A topic of one or several bags.
struct BagTopic {
  std::string name;
  std::string type;  ///< as recorded, such as sensor_msgs/LaserScan
  std::string md5;   ///< of its definition: what decides whether it can be read
  std::size_t messages = 0;
};

/// Bags that are read as one: their messages in order of the time that they were recorded at,
/// whatever the compression.
class BagSet {
 public:
  /// Throws std::runtime_error that names the file and says what to do, if one cannot be read, is
  /// no bag, is cut short or has no index.
  explicit BagSet(const std::vector<std::filesystem::path>& files);

  std::vector<BagTopic> topics() const;  ///< by name; one with two definitions is listed twice

  /// Calls `take` for each message of the topics, in order of time, until it returns false. Throws
  /// std::runtime_error if a bag turns out to be damaged on the way.
  void read(const std::vector<std::string>& topics,
            const std::function<bool(const rosbag::MessageInstance&)>& take) const;

  /// The same for a reader that comes and goes: a view and its position.
  std::unique_ptr<rosbag::View> view(const std::vector<std::string>& topics) const;

 private:
  std::vector<std::unique_ptr<rosbag::Bag>> bags_;
};

/// What to say of a bag that turned out to be damaged while it was read.
std::runtime_error damaged_bag(const std::exception& error);

}  // namespace ribbon_mapper
