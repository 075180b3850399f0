// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace ribbon_mapper::sim {

/// Returns the bytes that `work` returns in a child process, so that a library that crashes or
/// hangs ends only that. Throws std::runtime_error with the message of an exception of `work`, or
/// the signal by which the child ended. SIGXCPU is that of `most_cpu_s` seconds of computing.
std::string result_of_child(const std::function<std::string()>& work, unsigned most_cpu_s);

}  // namespace ribbon_mapper::sim
