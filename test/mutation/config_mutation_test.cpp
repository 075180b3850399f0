// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "modeler/io/config_file.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/mutation/mutator.hpp"

namespace ribbon_mapper::mutation {
namespace {

/// Returns the presets that are shipped, and one with aliases.
std::vector<std::string> presets() {
  std::vector<std::string> texts{"association: &a {slam: &g {angle_deg: 5}, corrected: *g}\n"};
  for (const auto& entry : std::filesystem::directory_iterator(PROJECT_DIR "/config")) {
    if (entry.path().extension() == ".yaml") texts.push_back(content_of(entry.path()));
  }
  return texts;
}

/// What was read can be written, and read again.
TEST(ConfigMutations, AreReadOrRefused) {
  const TemporaryDirectory directory;
  const std::string path = directory.path() / "preset.yaml";
  const std::vector<std::string> words{"&a ", "*a",   "scan: *a\n", "&b {x: *b}", "[",     "]",
                                       "{",   "}",    "<<: ",       "? ",         "- ",    "!!map ",
                                       "|",   ">",    ": ",         "\n",         "---\n", "%TAG",
                                       "\t",  "true", "~",          "'",          "\""};
  expect_read_or_refused(Mutator(presets(), words), "config", [&](const std::string& text) {
    write_content(path, text);
    const ModelerConfig config = load_config(path);
    write_content(path, config_to_yaml(config));
    EXPECT_EQ(config_to_yaml(config), config_to_yaml(load_config(path)));
  });
}

}  // namespace
}  // namespace ribbon_mapper::mutation
