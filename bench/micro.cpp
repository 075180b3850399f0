// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/micro.hpp"

#include <benchmark/benchmark.h>

#include <array>

#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

/// Collects the CPU time per iteration of each repetition.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      seconds[run.run_name.function_name].push_back(run.cpu_accumulated_time /
                                                    static_cast<double>(run.iterations));
    }
  }
  std::map<std::string, std::vector<double>> seconds;
};

void configure_library() {
  static const bool once = [] {
    std::array<char, 6> name{"bench"};
    std::array<char, 28> repetitions{"--benchmark_repetitions=7"};
    std::array<char, 48> interleaving{"--benchmark_enable_random_interleaving=true"};
    std::array<char, 28> time{"--benchmark_min_time=0.15"};
    std::array<char*, 4> arguments{name.data(), repetitions.data(), interleaving.data(),
                                   time.data()};
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    return true;
  }();
  (void)once;
}

}  // namespace

void MicroBenchmarks::add(const std::string& name, std::size_t items, std::function<void()> work) {
  works_.push_back({name, items, std::move(work)});
}

std::map<std::string, double> MicroBenchmarks::ns_per_item() const {
  configure_library();
  benchmark::ClearRegisteredBenchmarks();
  for (const Work& work : works_) {
    benchmark::RegisterBenchmark(work.name.c_str(), [&work](benchmark::State& state) {
      for ([[maybe_unused]] auto _ : state) work.run();
    });
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  std::map<std::string, double> result;
  for (const Work& work : works_) {
    result[work.name] =
        1e9 * median(collector.seconds.at(work.name)) / static_cast<double>(work.items);
  }
  return result;
}

}  // namespace ribbon_mapper::bench
