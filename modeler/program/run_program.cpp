// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/run_program.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>

#include "modeler/program/interrupt.hpp"

namespace ribbon_mapper {
namespace {

/// Returns whether all that was printed has been written; the reason is in errno.
bool flush_output() {
  const bool is_good = std::cout.flush().good();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && is_good;
}

}  // namespace

int run_program(const char* name, const std::function<int()>& work) {
  try {
    const int exit_code = work();
    errno = 0;
    if (flush_output()) return exit_code;
    const char* reason = errno != 0 ? std::strerror(errno) : "an earlier write failed";
    std::fprintf(stderr, "%s: the standard output cannot be written: %s; send it elsewhere\n", name,
                 reason);
  } catch (const Interrupted& interrupted) {
    flush_output();
    std::fprintf(stderr, "%s: %s\n", name, interrupted.what());
    return kInterruptedExitCode;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
  }
  return 1;
}

}  // namespace ribbon_mapper
