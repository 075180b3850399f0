// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/interrupt.hpp"

#include <signal.h>

#include <atomic>

namespace ribbon_mapper {
namespace {

std::atomic<bool> interrupted{false};  // asked for by all threads
static_assert(std::atomic<bool>::is_always_lock_free, "a handler of signals may not wait");

void on_signal(int /*signal*/) { interrupted = true; }

}  // namespace

void watch_interrupts() {
  interrupted = false;
  struct sigaction once = {};
  once.sa_handler = on_signal;
  once.sa_flags = SA_RESETHAND | SA_RESTART;
  sigaction(SIGINT, &once, nullptr);
  sigaction(SIGTERM, &once, nullptr);
}

void stop_if_interrupted() {
  if (interrupted) throw Interrupted("interrupted, nothing was written");
}

}  // namespace ribbon_mapper
