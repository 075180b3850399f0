// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/installed_files.hpp"

#include <gtest/gtest.h>

namespace ribbon_mapper::eval {
namespace {

TEST(Share, HasTheScriptOfTheFigure) {
  EXPECT_TRUE(std::filesystem::exists(share_directory() / "eval/figures/before_after.py"));
}

TEST(Share, FindsWhatIsInThePackageAndLeavesOtherPathsAlone) {
  EXPECT_EQ(find_shared("worlds/apartment.sdf"), share_directory() / "worlds/apartment.sdf");
  EXPECT_EQ(find_shared("/proc/self/exe"), "/proc/self/exe");
  EXPECT_EQ(find_shared("no/such.sdf"), "no/such.sdf");
}

TEST(Share, NamesWithinThePackageAreTheSameOnEveryMachine) {
  EXPECT_EQ(shared_name(share_directory() / "worlds" / "apartment.sdf"), "worlds/apartment.sdf");
  EXPECT_EQ(shared_name("/elsewhere/flat.sdf"), "/elsewhere/flat.sdf");
  EXPECT_EQ(shared_name("my/flat.sdf"), "my/flat.sdf");
  EXPECT_EQ(shared_name(share_directory() / ".." / "flat.sdf"),
            share_directory() / ".." / "flat.sdf");
}

}  // namespace
}  // namespace ribbon_mapper::eval
