// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "slam/node/live_estimate.hpp"

namespace ribbon_mapper::slam {

/// What an EstimateWorker has found out since it was asked last.
struct EstimateNews {
  std::vector<LineOutcome> outcomes;                 ///< one for each line taken
  std::optional<std::vector<StampedPose>> revision;  ///< the newest trajectory, if it was revised
  std::optional<PoseOfNow> now;                      ///< the newest pose, if there is a new one
  std::vector<Decision> decisions;                   ///< the new ones
  std::vector<std::string> refused_base_scans;       ///< why, for each of them
  EstimateStatus status;                             ///< the state of now
  bool is_closed = false;                            ///< close() is done; `revision` covers it
};

/// Estimates a trajectory in a thread of its own, so that no line is lost while it computes.
///
/// All methods return at once. Lines wait in a queue; what is found out is fetched by
/// take_news().
class EstimateWorker {
 public:
  /// Starts the thread. Throws std::invalid_argument as Modeler does.
  EstimateWorker(const ModelerConfig& config, const EstimateConfig& estimate,
                 bool with_base_laser = false);
  /// Ends the thread after the line in work.
  ~EstimateWorker();
  EstimateWorker(const EstimateWorker&) = delete;
  EstimateWorker& operator=(const EstimateWorker&) = delete;

  /// Adds a line to the queue.
  void add(ReadyLine line);
  /// Adds a scan of the base laser to the queue, see LiveEstimate::add_base_scan().
  void add_base_scan(ReadyLine scan);
  /// Adjusts the whole trajectory after the lines that are in the queue now.
  void close();
  /// Forgets all lines, those in the queue too. No news of them will come.
  void reset();

  /// Returns the number of lines that were added and are not in the estimate yet.
  std::size_t lines_behind() const;
  /// Returns the time between the oldest and the newest of these lines [s].
  double seconds_behind() const;
  /// Removes and returns what was found out. Throws what the estimate has thrown.
  EstimateNews take_news();

 private:
  /// What the thread is to do; with neither line nor scan: close.
  struct Task {
    std::optional<ReadyLine> line, base_scan;
    std::size_t run;  ///< the estimate belongs to one run
  };
  void push(Task task);
  void work();
  std::optional<Task> next_task();
  EstimateNews done(const Task& task);
  void deliver(EstimateNews news, std::size_t run);

  const ModelerConfig config_;
  const EstimateConfig estimate_config_;
  const bool with_base_laser_;
  // Of the thread.
  std::optional<LiveEstimate> estimate_;
  std::size_t run_of_estimate_ = 0;
  Time told_{0};  ///< stamp of the last pose that was told
  std::size_t told_decisions_ = 0;
  // Shared.
  mutable std::mutex mutex_;
  std::condition_variable has_task_;
  std::deque<Task> queue_;  ///< the first may be in work
  std::size_t lines_in_queue_ = 0, run_ = 0;
  bool is_ending_ = false;
  EstimateNews news_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace ribbon_mapper::slam
