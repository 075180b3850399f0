// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/series.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>

#include "modeler/program/interrupt.hpp"

namespace ribbon_mapper::eval {
namespace {

/// State that the threads of a series share.
class RunQueue {
 public:
  RunQueue(std::size_t count, ProgressBar& bar) : progress_(count), bar_(bar) {}

  /// Takes the next run and returns its index. Returns nothing after the last run or a failure.
  std::optional<std::size_t> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_ || next_ == progress_.size()) return std::nullopt;
    return next_++;
  }

  /// Shows the progress of the whole series, as if all runs were as long as run `index`.
  /// Throws Interrupted if the program was asked to end.
  void show(std::size_t index, const Progress& progress) {
    stop_if_interrupted();
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_[index] = progress;
    Progress all = std::accumulate(progress_.begin(), progress_.end(), Progress());
    all.lines = progress.lines * progress_.size();
    bar_.show(all);
  }

  void print(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    bar_.print(text);
  }

  void fail(const std::exception_ptr& failure) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!failure_) failure_ = failure;
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::vector<Progress> progress_;
  std::exception_ptr failure_;
  ProgressBar& bar_;
};

void work(RunQueue& queue, const std::vector<RunOptions>& runs, const MakeRun& make_run) {
  while (const std::optional<std::size_t> index = queue.take()) {
    try {
      queue.print(make_run(runs[*index], [&](const Progress& p) { queue.show(*index, p); }));
    } catch (...) {
      queue.fail(std::current_exception());
    }
  }
}

}  // namespace

void make_runs(const std::vector<RunOptions>& runs, std::size_t jobs, const MakeRun& make_run,
               ProgressBar& bar) {
  RunQueue queue(runs.size(), bar);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < std::min(jobs, runs.size()); ++i) {
    threads.emplace_back([&] { work(queue, runs, make_run); });
  }
  for (std::thread& thread : threads) thread.join();
  queue.rethrow();
}

}  // namespace ribbon_mapper::eval
