// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/node/estimate_worker.hpp"

#include <algorithm>
#include <utility>

namespace ribbon_mapper::slam {
namespace {

// Between two poses of now, in time of the data: that of map -> odom hardly changes within it.
constexpr Time kPoseStep = std::chrono::milliseconds(100);

}  // namespace

EstimateWorker::EstimateWorker(const ModelerConfig& config, const EstimateConfig& estimate,
                               bool with_base_laser)
    : config_(config),
      estimate_config_(estimate),
      with_base_laser_(with_base_laser),
      estimate_(std::in_place, config, estimate, with_base_laser) {
  thread_ = std::thread([this] { work(); });
}

EstimateWorker::~EstimateWorker() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  has_task_.notify_one();
  thread_.join();
}

void EstimateWorker::add(ReadyLine line) { push({std::move(line), std::nullopt, 0}); }

void EstimateWorker::add_base_scan(ReadyLine scan) { push({std::nullopt, std::move(scan), 0}); }

void EstimateWorker::close() { push({std::nullopt, std::nullopt, 0}); }

void EstimateWorker::push(Task task) {
  {
    const std::lock_guard lock(mutex_);
    task.run = run_;
    if (task.line) ++lines_in_queue_;
    queue_.push_back(std::move(task));
  }
  has_task_.notify_one();
}

void EstimateWorker::reset() {
  const std::lock_guard lock(mutex_);
  ++run_;
  queue_.clear();
  lines_in_queue_ = 0;
  news_ = {};
}

std::size_t EstimateWorker::lines_behind() const {
  const std::lock_guard lock(mutex_);
  return lines_in_queue_;
}

double EstimateWorker::seconds_behind() const {
  const std::lock_guard lock(mutex_);
  const auto is_line = [](const Task& task) { return task.line.has_value(); };
  const auto oldest = std::find_if(queue_.begin(), queue_.end(), is_line);
  if (oldest == queue_.end()) return 0.0;
  const auto newest = std::find_if(queue_.rbegin(), queue_.rend(), is_line);
  return to_seconds(newest->line->beams.stamp - oldest->line->beams.stamp);
}

EstimateNews EstimateWorker::take_news() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  EstimateNews news = std::move(news_);
  news_ = {};
  news_.status = news.status;
  return news;
}

void EstimateWorker::work() {
  try {
    while (const std::optional<Task> task = next_task()) deliver(done(*task), task->run);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
}

/// Waits for a task. Returns nothing when the thread is to end.
std::optional<EstimateWorker::Task> EstimateWorker::next_task() {
  std::unique_lock lock(mutex_);
  has_task_.wait(lock, [this] { return is_ending_ || !queue_.empty(); });
  if (is_ending_) return std::nullopt;
  return queue_.front();
}

EstimateNews EstimateWorker::done(const Task& task) {
  if (task.run != run_of_estimate_) {
    estimate_.emplace(config_, estimate_config_, with_base_laser_);
    run_of_estimate_ = task.run;
    told_ = Time(0);
    told_decisions_ = 0;
  }
  EstimateNews news;
  if (task.line) {
    news.outcomes.push_back(estimate_->add(*task.line));
  } else if (task.base_scan) {
    const std::string defect = estimate_->add_base_scan(*task.base_scan);
    if (!defect.empty()) news.refused_base_scans.push_back(defect);
  } else {
    estimate_->finish();
    news.is_closed = true;
  }
  const bool is_revised = estimate_->take_is_revised();
  const bool has_moved = estimate_->newest() >= told_ + kPoseStep;
  news.status = estimate_->status();
  if ((is_revised || has_moved) && news.status.lines > 0) {
    news.now = estimate_->now();
    told_ = news.now->stamp;
    if (is_revised) news.revision = estimate_->trajectory();
  }
  const std::vector<Decision>& decisions = estimate_->decisions();
  for (; told_decisions_ < decisions.size(); ++told_decisions_)
    news.decisions.push_back(decisions[told_decisions_]);
  return news;
}

/// Adds to the news, and takes the task from the queue, unless it is of a run before.
void EstimateWorker::deliver(EstimateNews news, std::size_t run) {
  const std::lock_guard lock(mutex_);
  if (run != run_) return;
  if (queue_.front().line) --lines_in_queue_;
  queue_.pop_front();
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  append(news_.outcomes, news.outcomes);
  append(news_.decisions, news.decisions);
  append(news_.refused_base_scans, news.refused_base_scans);
  if (news.revision) news_.revision = std::move(news.revision);
  if (news.now) news_.now = news.now;
  news_.status = news.status;
  news_.is_closed = news_.is_closed || news.is_closed;
}

}  // namespace ribbon_mapper::slam
