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
#include "modeler/program/progress_bar.hpp"

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
    case Figure::floor_plan:
      return "floor_plan";
    case Figure::floor_plan_dxf:
      return "floor_plan_dxf";
  }
  return "";
}

/// Returns what files a figure has, for a message.
std::string files_of(Figure figure) {
  if (figure == Figure::floor_plan_dxf) return "floor_plan.dxf was";
  return std::string(name_of(figure)) + ".svg and .png were";
}

}  // namespace

bool draw_figure(Figure figure, const std::filesystem::path& directory,
                 const std::filesystem::path& later) {
  const std::string name = name_of(figure);
  tell_terminal("drawing " + name);
  const auto script = installed_directory() / "eval" / "figures" / (name + ".py");
  if (run(RIBBON_MAPPER_PYTHON, script.string(), directory.string()) == 0) return true;
  std::fprintf(stderr,
               "warning: %s not drawn, for the reason above. To draw this later, run: %s %s %s\n",
               files_of(figure).c_str(), RIBBON_MAPPER_PYTHON, script.c_str(),
               later.empty() ? directory.c_str() : later.c_str());
  return false;
}

bool draw_floor_plan(const std::filesystem::path& directory, const std::filesystem::path& later) {
  const bool has_picture = draw_figure(Figure::floor_plan, directory, later);
  return draw_figure(Figure::floor_plan_dxf, directory, later) && has_picture;
}

}  // namespace ribbon_mapper
