// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace ribbon_mapper::bench {

struct Options {
  bool quick = false;              ///< a part of the tour, and the slow peers left out
  std::set<std::string> sections;  ///< which ones; empty: all
  std::filesystem::path output = "results/bench";
  std::string config = "config/pr2.yaml";
  double limit_s = 600.0;  ///< CPU time after which a peer is stopped
  int repetitions = 5;     ///< of our own whole pipelines
};

}  // namespace ribbon_mapper::bench
