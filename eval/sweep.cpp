// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/sweep.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>

#include "eval/spread.hpp"

namespace ribbon_mapper::eval {
namespace {

/// What the threads share. The runs themselves share nothing.
class Board {
 public:
  Board(std::size_t count, ProgressBar& bar) : progress_(count), summaries_(count), bar_(bar) {}

  /// Index of a run that nobody has begun.
  std::optional<std::size_t> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_ || next_ == summaries_.size()) return std::nullopt;
    return next_++;
  }

  /// Runs that have not begun are as long as the one that reports.
  void show(std::size_t index, const Progress& progress) {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_[index] = progress;
    Progress all = std::accumulate(progress_.begin(), progress_.end(), Progress());
    all.lines = progress.lines * progress_.size();
    bar_.show(all);
  }

  void finish(std::size_t index, const Summary& summary) {
    const std::lock_guard<std::mutex> lock(mutex_);
    summaries_[index] = summary;
    bar_.print(spread_row(summary));
  }

  void fail(const std::exception_ptr& failure) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!failure_) failure_ = failure;
  }

  std::vector<Summary> summaries() const {
    if (failure_) std::rethrow_exception(failure_);
    return summaries_;
  }

 private:
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::vector<Progress> progress_;
  std::vector<Summary> summaries_;
  std::exception_ptr failure_;
  ProgressBar& bar_;
};

void work(Board& board, const std::vector<std::uint64_t>& seeds, const SeedRun& run) {
  while (const std::optional<std::size_t> index = board.take()) {
    try {
      board.finish(*index, run(seeds[*index], [&](const Progress& p) { board.show(*index, p); }));
    } catch (...) {
      board.fail(std::current_exception());
    }
  }
}

}  // namespace

std::vector<Summary> run_seeds(const std::vector<std::uint64_t>& seeds, std::size_t jobs,
                               const SeedRun& run, ProgressBar& bar) {
  Board board(seeds.size(), bar);
  bar.print(spread_head());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < std::min(jobs, seeds.size()); ++i) {
    threads.emplace_back([&] { work(board, seeds, run); });
  }
  for (std::thread& thread : threads) thread.join();
  return board.summaries();
}

}  // namespace ribbon_mapper::eval
