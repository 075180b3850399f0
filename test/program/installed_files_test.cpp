// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/installed_files.hpp"

#include <gtest/gtest.h>

namespace ribbon_mapper {
namespace {

TEST(InstalledFiles, IncludeTheScriptOfTheFigure) {
  EXPECT_TRUE(std::filesystem::exists(installed_directory() / "eval/figures/before_after.py"));
}

TEST(InstalledFiles, AreFoundAndOtherPathsAreLeftUnchanged) {
  EXPECT_EQ(find_installed_file("worlds/apartment.sdf"),
            installed_directory() / "worlds/apartment.sdf");
  EXPECT_EQ(find_installed_file("/proc/self/exe"), "/proc/self/exe");
  EXPECT_EQ(find_installed_file("no/such.sdf"), "no/such.sdf");
}

TEST(InstalledFiles, HaveTheSameNameOnEveryMachine) {
  EXPECT_EQ(portable_name(installed_directory() / "worlds" / "apartment.sdf"),
            "worlds/apartment.sdf");
  EXPECT_EQ(portable_name("/elsewhere/flat.sdf"), "/elsewhere/flat.sdf");
  EXPECT_EQ(portable_name("my/flat.sdf"), "my/flat.sdf");
  EXPECT_EQ(portable_name(installed_directory() / ".." / "flat.sdf"),
            installed_directory() / ".." / "flat.sdf");
}

}  // namespace
}  // namespace ribbon_mapper
