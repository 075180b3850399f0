// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/figure.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <string>

#include "modeler/program/installed_files.hpp"

namespace ribbon_mapper {
namespace {

/// Runs a program without a shell and waits for it. Returns its exit code, or -1 if it did not
/// start or crashed.
int run(std::string program, std::string script, std::string argument) {
  const std::array<char*, 4> command{program.data(), script.data(), argument.data(), nullptr};
  pid_t child = -1;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, command.data(), environ) != 0) {
    return -1;
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

const char* name_of(Figure figure) {
  switch (figure) {
    case Figure::before_after:
      return "before_after";
    case Figure::dose_response:
      return "dose_response";
    case Figure::model_views:
      return "model_views";
    case Figure::level_map:
      return "level_map";
  }
  return "";
}

}  // namespace

bool draw_figure(Figure figure, const std::filesystem::path& directory,
                 const std::filesystem::path& later) {
  const std::string name = name_of(figure);
  const auto script = installed_directory() / "eval" / "figures" / (name + ".py");
  if (run(RIBBON_MAPPER_PYTHON, script.string(), directory.string()) == 0) return true;
  std::fprintf(stderr,
               "warning: %s.svg and .png were not drawn, for the reason above. To draw them later, "
               "run: %s %s %s\n",
               name.c_str(), RIBBON_MAPPER_PYTHON, script.c_str(),
               later.empty() ? directory.c_str() : later.c_str());
  return false;
}

}  // namespace ribbon_mapper
