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
  std::string name;          ///< as recorded, such as /tilt_scan
  std::string type;          ///< as recorded, such as sensor_msgs/LaserScan
  std::string md5;           ///< of its definition, which decides whether it can be read
  std::size_t messages = 0;  ///< in all bags
};

/// Several bags that are read as one, in the order in which their messages were recorded.
class BagSet {
 public:
  /// Opens the bags. Throws std::runtime_error that names the file and says what to do if a file
  /// cannot be read, is no bag, is cut short or has no index.
  explicit BagSet(const std::vector<std::filesystem::path>& files);

  /// Returns the topics in the order of their names. A topic with two definitions is listed twice.
  std::vector<BagTopic> topics() const;

  /// Calls `take` for each message of the topics, in order of time, until it returns false. Throws
  /// std::runtime_error if a bag is damaged.
  void read(const std::vector<std::string>& topics,
            const std::function<bool(const rosbag::MessageInstance&)>& take) const;

  /// Returns a view of the topics, for a reader that keeps its position.
  std::unique_ptr<rosbag::View> view(const std::vector<std::string>& topics) const;

 private:
  std::vector<std::unique_ptr<rosbag::Bag>> bags_;
};

/// Returns the error for a bag that turned out to be damaged while it was read.
std::runtime_error damaged_bag(const std::exception& error);

}  // namespace ribbon_mapper
