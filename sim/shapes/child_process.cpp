// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/shapes/child_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

namespace ribbon_mapper::sim {
namespace {

constexpr char kResult = 'R', kError = 'E';

void write_all(int file, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t count = write(file, bytes.data() + at, bytes.size() - at);
    if (count < 0 && errno != EINTR) _exit(1);
    if (count > 0) at += static_cast<std::size_t>(count);
  }
}

std::string read_all(int file) {
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = read(file, buffer.data(), buffer.size());
    if (count == 0 || (count < 0 && errno != EINTR)) return bytes;
    if (count > 0) bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

/// Does the work of the child, silently and without a core dump.
[[noreturn]] void run_child(const std::function<std::string()>& work, unsigned most_cpu_s,
                            int result) {
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGXCPU}) std::signal(signal, SIG_DFL);
  const rlimit cpu{most_cpu_s, most_cpu_s}, no_core{0, 0};
  setrlimit(RLIMIT_CPU, &cpu);
  setrlimit(RLIMIT_CORE, &no_core);
  const int silence = open("/dev/null", O_WRONLY);
  dup2(silence, STDOUT_FILENO);
  dup2(silence, STDERR_FILENO);
  try {
    write_all(result, kResult + work());
  } catch (const std::exception& error) {
    write_all(result, kError + std::string(error.what()));
  }
  _exit(0);
}

}  // namespace

std::string result_of_child(const std::function<std::string()>& work, unsigned most_cpu_s) {
  std::array<int, 2> ends;
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child == 0) run_child(work, most_cpu_s, ends[1]);
  close(ends[1]);
  const std::string bytes = child < 0 ? "" : read_all(ends[0]);
  close(ends[0]);
  if (child < 0) throw std::runtime_error(std::string("no process: ") + std::strerror(errno));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status))
    throw std::runtime_error(std::string("the library ends by the signal ") +
                             strsignal(WTERMSIG(status)));
  if (bytes.empty()) throw std::runtime_error("the library ends the process");
  if (bytes[0] == kError) throw std::runtime_error(bytes.substr(1));
  return bytes.substr(1);
}

}  // namespace ribbon_mapper::sim
