// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/save.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "modeler/surface/surface_config.hpp"
#include "test/io/small_plane.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const double kStripeGap_m = SurfaceConfig{}.stripe_gap_m;

TEST(Save, WritesFourFiles) {
  const TemporaryDirectory directory;
  const auto paths =
      save_model({small_plane()}, directory.path() / "models", "kitchen", kStripeGap_m);
  ASSERT_EQ(paths.size(), 4U);
  for (const auto& path : paths) EXPECT_GT(std::filesystem::file_size(path), 0U) << path;
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "models" / "kitchen.json"));
}

TEST(Save, AnEmptyModelCanBeSaved) {
  const TemporaryDirectory directory;
  EXPECT_NO_THROW(save_model({}, directory.path(), "empty", kStripeGap_m));
}

class BadName : public testing::TestWithParam<std::string> {};

TEST_P(BadName, IsRefusedAndNothingIsWritten) {
  const TemporaryDirectory directory;
  EXPECT_THAT([&] { save_model({}, directory.path() / "models", GetParam(), kStripeGap_m); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("a name, not a path")));
  EXPECT_EQ(directory.file_count(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Save, BadName,
                         testing::Values("", "a/b", "/etc/passwd", "..", "a..b", ".hidden", "-rf",
                                         "a b", "a\nb", "a\\b", "caf\xc3\xa9",
                                         std::string("a\0b", 3), std::string(65, 'x')));

TEST(Save, GoodNamesAreTaken) {
  for (const char* name : {"a", "_", "Kitchen-2.1", "0"}) EXPECT_NO_THROW(check_save_name(name));
  EXPECT_NO_THROW(check_save_name(std::string(64, 'x')));
}

TEST(Save, AFullDiskLeavesTheEarlierSaveWhole) {
  const TemporaryDirectory directory;
  save_model({small_plane()}, directory.path(), "kitchen", kStripeGap_m);
  const std::string json = content_of(directory.path() / "kitchen.json");

  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{600, before.rlim_max};  // enough for the JSON, too little for the mesh
  setrlimit(RLIMIT_FSIZE, &full);
  Plane other = small_plane();
  other.id = 8;
  EXPECT_THROW(save_model({other, small_plane()}, directory.path(), "kitchen", kStripeGap_m),
               std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &before);

  EXPECT_EQ(content_of(directory.path() / "kitchen.json"), json);
  EXPECT_EQ(directory.file_count(), 4U);
}

}  // namespace
}  // namespace ribbon_mapper
