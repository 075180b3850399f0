// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of each format, as they were written once, are read for ever. That of a new format is
// written by: model_file_test --gtest_also_run_disabled_tests
// --gtest_filter='Golden.DISABLED_Write'
#include <gtest/gtest.h>

#include "modeler/model_file/model_file.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/model_file/small_model.hpp"
#include "test/modeler/plane_matchers.hpp"

namespace ribbon_mapper {
namespace {

std::filesystem::path golden(std::uint32_t format) {
  return std::filesystem::path(PROJECT_DIR "/test/data") /
         ("model_format_" + std::to_string(format) + ".ribbons");
}

TEST(Golden, DISABLED_Write) { save_model_file(small_model(), golden(kModelFormat)); }

TEST(Golden, EachFormatIsRead) {
  const Modeler expected = small_model();
  for (std::uint32_t format = 1; format <= kModelFormat; ++format) {
    ModelFile file = load_model_file(golden(format));
    EXPECT_EQ(0.4, file.config.ribbon.min_length_m);
    EXPECT_EQ("map", file.frame);
    const Modeler modeler(file.config, std::move(file.model));
    EXPECT_EQ(60u, modeler.statistics().lines);
    EXPECT_EQ(1u, modeler.statistics().revision);
    EXPECT_GT(modeler.planes().size(), 1u);
    mini_world::expect_same(expected.planes(), modeler.planes(), 1e-6);
    EXPECT_EQ(expected.next_plane_id(), modeler.next_plane_id());
  }
}

/// Returns a file of the model in a file, with all keys that a configuration has now.
std::string written_again(const std::string& bytes) {
  ModelFile file = from_model_file(bytes);
  return to_model_file(Modeler(file.config, std::move(file.model)));
}

TEST(Golden, IsWrittenAgainByteByByte) {
  const std::string bytes = content_of(golden(kModelFormat));
  EXPECT_LT(bytes.size(), 100'000u);
  const std::string once = written_again(bytes);
  EXPECT_EQ(once, written_again(once));
  EXPECT_GE(once.size(), bytes.size());  // keys of the configuration may have been added
  EXPECT_LT(once.size(), bytes.size() + 1'000u);
}

}  // namespace
}  // namespace ribbon_mapper
