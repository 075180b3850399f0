// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ribbon_mapper::bench {

/// Micro-benchmarks timed with Google Benchmark. Repetitions of all of them run in random order, so
/// that a temporary slowdown of the machine affects all alike.
class MicroBenchmarks {
 public:
  /// Adds a benchmark; one call of `work` processes `items` points, rays or the like.
  void add(const std::string& name, std::size_t items, std::function<void()> work);

  /// Runs all benchmarks and returns the median CPU time per item [ns] by name.
  std::map<std::string, double> ns_per_item() const;

 private:
  struct Work {
    std::string name;
    std::size_t items;
    std::function<void()> run;
  };
  std::vector<Work> works_;
};

}  // namespace ribbon_mapper::bench
