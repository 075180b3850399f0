// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ribbon_mapper::bench {

/// Short pieces of work, timed side by side by Google Benchmark: repetitions of all of them in
/// random order, so that a slow moment of the machine does not fall on one alone.
class MicroBenchmarks {
 public:
  /// `items`: how many points, rays, ... one call of `work` deals with.
  void add(const std::string& name, std::size_t items, std::function<void()> work);

  /// Median CPU time per item [ns], by name.
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
