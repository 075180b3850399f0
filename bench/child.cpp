// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/child.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

namespace ribbon_mapper::bench {
namespace {

double kernel_mb(const char* file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string word; stream >> word;) {
    if (word != key) continue;
    double kilobytes = 0.0;
    stream >> kilobytes;
    return kilobytes / 1024.0;
  }
  return 0.0;
}

void write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(file, text.data() + done, text.size() - done);
    if (count <= 0) _exit(3);
    done += static_cast<std::size_t>(count);
  }
}

std::string read_all(int file) {
  std::string text;
  char block[4096];
  for (ssize_t count = 0; (count = read(file, block, sizeof block)) > 0;) text.append(block, count);
  return text;
}

[[noreturn]] void run_as_child(const std::function<nlohmann::json()>& work, double limit_s,
                               int file) {
  const auto seconds = static_cast<rlim_t>(limit_s);
  const rlimit limit{seconds, seconds + 5};
  setrlimit(RLIMIT_CPU, &limit);
  nlohmann::json answer;
  try {
    reset_peak();
    const double before_mb = resident_mb();
    answer["value"] = work();
    answer["peak_mb"] = peak_resident_mb() - before_mb;
  } catch (const std::exception& error) {
    answer = {{"error", error.what()}};
  }
  write_all(file, answer.dump());
  std::fflush(stdout);
  _exit(0);
}

}  // namespace

double resident_mb() { return kernel_mb("/proc/self/status", "VmRSS:"); }
double peak_resident_mb() { return kernel_mb("/proc/self/status", "VmHWM:"); }
void reset_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }
double available_mb() { return kernel_mb("/proc/meminfo", "MemAvailable:"); }

std::optional<ChildResult> run_in_child(const std::function<nlohmann::json()>& work,
                                        double limit_s) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot create a pipe to a child process");
  std::fflush(stdout);
  malloc_trim(0);  // free memory that malloc keeps would hide the work's use
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot create a child process: is there enough memory?");
  if (child == 0) {
    close(ends[0]);
    run_as_child(work, limit_s, ends[1]);
  }
  close(ends[1]);
  const std::string text = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return std::nullopt;
  const auto answer = nlohmann::json::parse(text, nullptr, false);
  if (!answer.is_object()) {
    throw std::runtime_error("a measurement ended with status " + std::to_string(status));
  }
  if (answer.contains("error")) throw std::runtime_error(answer["error"].get<std::string>());
  return ChildResult{answer["value"], answer["peak_mb"]};
}

}  // namespace ribbon_mapper::bench
