// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>

namespace ribbon_mapper {

/// What this process has used so far.
struct ProcessCost {
  double cpu_s = 0.0;            ///< user and system time
  double peak_memory_mib = 0.0;  ///< resident
};

/// Returns what this process has used so far.
inline ProcessCost process_cost() {
  const auto seconds = [](const timeval& time) { return time.tv_sec + 1e-6 * time.tv_usec; };
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_maxrss / 1024.0};
}

}  // namespace ribbon_mapper
