// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

namespace ribbon_mapper::bench {

/// What came out of work that ran in a process of its own.
struct ChildResult {
  nlohmann::json value;  ///< what the work returned
  double peak_mb = 0.0;  ///< of the memory, beyond what there was when the work began [MB]
};

/// Runs `work` in a forked process, so that its memory can be measured and what it leaves behind
/// does not slow others. Nothing if it took more than `limit_s` of CPU time. Throws
/// std::runtime_error with the reason if it fails otherwise.
std::optional<ChildResult> run_in_child(const std::function<nlohmann::json()>& work,
                                        double limit_s);

/// Resident memory of this process: now, and at its peak since reset_peak() [MB].
double resident_mb();
double peak_resident_mb();
void reset_peak();

/// What the machine has left for new work [MB].
double available_mb();

}  // namespace ribbon_mapper::bench
