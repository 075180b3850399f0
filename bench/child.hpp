// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

namespace ribbon_mapper::bench {

/// Result of work in a child process.
struct ChildResult {
  nlohmann::json value;  ///< value returned by the work
  double peak_mb = 0.0;  ///< peak of resident memory above that at the beginning of the work [MB]
};

/// Runs `work` in a forked process, so that its memory can be measured and is released afterwards.
/// Returns nothing if it exceeds `limit_s` of CPU time. Throws std::runtime_error with the reason
/// if it fails otherwise.
std::optional<ChildResult> run_in_child(const std::function<nlohmann::json()>& work,
                                        double limit_s);

/// Returns the resident memory of this process [MB].
double resident_mb();

/// Returns the peak of the resident memory since reset_peak() [MB].
double peak_resident_mb();

/// Resets the peak of the resident memory to its current value.
void reset_peak();

/// Returns the memory that is available on this machine [MB].
double available_mb();

}  // namespace ribbon_mapper::bench
