// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "modeler/model_file/model_file.hpp"
#include "test/model_file/small_model.hpp"
#include "test/mutation/mutator.hpp"

namespace ribbon_mapper::mutation {
namespace {

/// Goes on from a file as a session does.
void go_on_from(const std::string& bytes) {
  ModelFile file = from_model_file(bytes);
  Modeler modeler(file.config, std::move(file.model));
  modeler.planes();
  const std::vector<StampedPose> trajectory = modeler.trajectory();
  if (!trajectory.empty()) modeler.correct(trajectory);
  modeler.planes_as_built();
  from_model_file(to_model_file(modeler));
}

TEST(ModelFileMutations, AreReadOrRefused) {
  expect_read_or_refused(Mutator({to_model_file(small_model())}, {"RIBS", "TRAJ"}), "ribbons",
                         go_on_from);
}

/// Behind the checksums: each part is damaged, and then sealed as if that were right.
TEST(ModelFileMutations, WithRightChecksumsAreReadOrRefused) {
  const std::string good = to_model_file(small_model());
  const std::vector<SectionView> sections = split_sections(good);
  const std::string zeros(8, '\0'), ones(8, '\xff'), infinity("\0\0\x80\x7f", 4);
  for (const SectionView& damaged : sections) {
    const auto sealed = [&](std::string part) {
      part.resize(damaged.bytes.size());  // or hardly any would be read to its end
      std::vector<Section> all;
      for (const SectionView& each : sections) {
        all.push_back({each.name, each.name == damaged.name ? part : std::string(each.bytes)});
      }
      go_on_from(join_sections(all));
    };
    expect_read_or_refused(Mutator({std::string(damaged.bytes)}, {zeros, ones, infinity}),
                           "ribbons." + damaged.name, sealed);
  }
}

}  // namespace
}  // namespace ribbon_mapper::mutation
