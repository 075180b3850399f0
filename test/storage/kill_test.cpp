// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Kills a process while it saves: 40 times, or as often as RIBBON_MAPPER_KILLS says.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "modeler/io/save.hpp"
#include "modeler/surface/surface_config.hpp"
#include "test/io/environment_number.hpp"
#include "test/io/small_plane.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kNames{"kitchen.json", "kitchen.ply", "kitchen_cells.ply",
                                      "kitchen.bt"};

int number_of_kills() { return environment_number("RIBBON_MAPPER_KILLS", 40); }

/// Returns a model whose run id depends on `number`.
std::vector<Plane> model(int number) {
  Plane plane = small_plane();
  plane.id = number;
  return {plane};
}

void save(int number, const fs::path& directory) {
  save_model(model(number), directory, "kitchen", SurfaceConfig{}.stripe_gap_m);
}

/// Saves one model after the other until it is killed. A save is announced by a byte to `pipe`.
[[noreturn]] void save_for_ever(int first, const fs::path& directory, int pipe) {
  for (int number = first;; ++number) {
    if (write(pipe, ".", 1) != 1) _exit(1);
    save(number, directory);
  }
}

/// Starts a process that saves, and kills it some time after its first, second or third save has
/// begun.
void save_and_kill(int first, const fs::path& directory, std::mt19937& random) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) save_for_ever(first, directory, ends[1]);
  char byte = 0;
  for (auto begun = std::uniform_int_distribution(1, 3)(random); begun > 0; --begun) {
    ASSERT_EQ(read(ends[0], &byte, 1), 1);
  }
  usleep(std::uniform_int_distribution<useconds_t>(0, 20'000)(random));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(ends[0]), close(ends[1]);
}

/// Returns the ids of the runs that the files are from; more than one if they do not belong
/// together, none before the first save was committed.
std::set<std::string> runs_in(const fs::path& directory) {
  std::set<std::string> runs;
  for (const std::string& name : kNames) {
    const std::string bytes = content_of(directory / name);
    if (bytes.empty()) {
      runs.insert("none");
      continue;
    }
    const std::string mark = name == "kitchen.json" ? "\"run\": \"" : "run ";
    const std::size_t at = bytes.find(mark);
    runs.insert(at == std::string::npos ? "unnamed" : bytes.substr(at + mark.size(), 16));
  }
  return runs;
}

std::size_t entries_below(const fs::path& directory) {
  return static_cast<std::size_t>(std::distance(fs::recursive_directory_iterator(directory),
                                                fs::recursive_directory_iterator()));
}

TEST(Kill, DuringASaveLeavesOneCompleteModel) {
  const TemporaryDirectory clean, directory;
  save(0, clean.path());
  // The files of an earlier version, which knew no sets.
  for (const std::string& name : kNames) {
    fs::copy_file(clean.path() / name, directory.path() / name);
  }
  std::mt19937 random(1);
  std::set<std::string> all_runs;
  for (int i = 0; i < number_of_kills(); ++i) {
    save_and_kill(1 + 1000 * i, directory.path(), random);
    const std::set<std::string> runs = runs_in(directory.path());
    ASSERT_EQ(runs.size(), 1U) << "after kill " << i;
    ASSERT_EQ(runs.count("none") + runs.count("unnamed"), 0U);
    all_runs.insert(runs.begin(), runs.end());
    ASSERT_TRUE(nlohmann::json::accept(content_of(directory.path() / "kitchen.json")));
  }
  EXPECT_GT(all_runs.size(), 1U) << "no save was ever committed";
  save(0, directory.path());
  EXPECT_EQ(entries_below(directory.path()), entries_below(clean.path())) << "there are leftovers";
  for (const std::string& name : kNames) {
    EXPECT_EQ(content_of(directory.path() / name), content_of(clean.path() / name)) << name;
  }
}

TEST(Kill, DuringTheFirstSaveLeavesAllFilesOrNone) {
  std::mt19937 random(2);
  for (int i = 0; i < number_of_kills() / 4; ++i) {
    const TemporaryDirectory directory;
    save_and_kill(1 + 1000 * i, directory.path(), random);
    ASSERT_EQ(runs_in(directory.path()).size(), 1U) << "after kill " << i;
  }
}

}  // namespace
}  // namespace ribbon_mapper
