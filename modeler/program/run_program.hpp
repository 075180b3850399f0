// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace ribbon_mapper {

/// Runs the work of a program and returns its exit code: that of `work`, or 1 after a message on
/// stderr. There is one if `work` throws, and if its standard output could not be written, for
/// example because the disk is full. Returns kInterruptedExitCode if `work` throws Interrupted.
int run_program(const char* name, const std::function<int()>& work);

}  // namespace ribbon_mapper
