// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/init.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>

namespace ribbon_mapper::slam {

/// What ~close returns.
struct CloseAnswer {
  bool success = false;  ///< the whole trajectory was adjusted and published
  std::string message;   ///< how, or why not
};

/// Hands the request of ~close from the thread of the service to that of the node.
class Closing {
 public:
  /// Asks the node, and waits for its answer, or for the end of the node.
  CloseAnswer ask() {
    std::unique_lock lock(mutex_);
    is_asked_ = true;
    answer_.reset();
    while (!answer_ && ros::ok()) answered_.wait_for(lock, std::chrono::milliseconds(100));
    is_asked_ = false;
    return answer_.value_or(CloseAnswer{false, "the node ends"});
  }

  /// Returns true while a request waits for its answer.
  bool is_asked() const {
    const std::lock_guard lock(mutex_);
    return is_asked_ && !answer_;
  }

  /// Answers the request.
  void answer(CloseAnswer answer) {
    {
      const std::lock_guard lock(mutex_);
      answer_ = std::move(answer);
    }
    answered_.notify_all();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable answered_;
  bool is_asked_ = false;
  std::optional<CloseAnswer> answer_;
};

}  // namespace ribbon_mapper::slam
