// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace ribbon_mapper {

/// Ends the work of a program that was asked to end, by Ctrl-C for example. run_program() prints
/// its text and exits with kInterruptedExitCode.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// As shells have it for SIGINT.
constexpr int kInterruptedExitCode = 130;

/// Makes SIGINT (Ctrl-C) and SIGTERM a request that stop_if_interrupted() answers. A second signal
/// ends the program at once.
void watch_interrupts();

/// Throws Interrupted if the program was asked to end since watch_interrupts().
void stop_if_interrupted();

}  // namespace ribbon_mapper
