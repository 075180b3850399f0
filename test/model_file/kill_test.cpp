// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Kills a process while it saves: 40 times, or as often as RIBBON_MAPPER_KILLS says.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <set>

#include "modeler/io/save.hpp"
#include "modeler/model_file/model_file.hpp"
#include "test/io/environment_number.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/model_file/small_model.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

int number_of_kills() { return environment_number("RIBBON_MAPPER_KILLS", 40); }

/// Saves two models in turn, each as an autosave and as a set with meshes, until it is killed. Each
/// save is announced by a byte.
[[noreturn]] void save_for_ever(const Modeler (&models)[2], const fs::path& directory, int pipe) {
  const std::string bytes[2] = {to_model_file(models[0]), to_model_file(models[1])};
  const std::vector<Plane> planes[2] = {models[0].planes(), models[1].planes()};
  for (int i = 0;; i = 1 - i) {
    if (write(pipe, ".", 1) != 1) _exit(1);
    save_model_file(models[i], directory / "autosave.ribbons");
    save_model(planes[i], directory, "kitchen", 0.5, "map", {bytes[i], {}, {}});
  }
}

void save_and_kill(const Modeler (&models)[2], const fs::path& directory, std::mt19937& random) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) save_for_ever(models, directory, ends[1]);
  char byte = 0;
  for (auto begun = std::uniform_int_distribution(1, 3)(random); begun > 0; --begun) {
    ASSERT_EQ(read(ends[0], &byte, 1), 1);
  }
  usleep(std::uniform_int_distribution<useconds_t>(0, 20'000)(random));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(ends[0]), close(ends[1]);
}

TEST(Kill, DuringASaveLeavesTheOldOrTheNewModelWhole) {
  const TemporaryDirectory directory;
  const Modeler models[2] = {small_model(1), small_model(2)};
  const std::string bytes[2] = {to_model_file(models[0]), to_model_file(models[1])};
  ASSERT_NE(bytes[0], bytes[1]);
  save_model_file(models[0], directory.path() / "autosave.ribbons");
  save_model(models[0].planes(), directory.path(), "kitchen", 0.5, "map", {bytes[0], {}, {}});
  std::mt19937 random(1);
  std::set<std::string> seen;
  for (int i = 0; i < number_of_kills(); ++i) {
    save_and_kill(models, directory.path(), random);
    for (const char* name : {"autosave.ribbons", "kitchen.ribbons"}) {
      const std::string now = content_of(directory.path() / name);
      ASSERT_TRUE(now == bytes[0] || now == bytes[1]) << name << " after kill " << i;
      seen.insert(now);
    }
  }
  EXPECT_EQ(2u, seen.size()) << "no save was ever committed";
}

}  // namespace
}  // namespace ribbon_mapper
