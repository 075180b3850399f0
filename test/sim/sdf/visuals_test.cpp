// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Models without collision, and the worlds that came from the field.
#include "test/sim/sdf/world_file.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string model(const std::string& name, const std::string& content) {
  return "<model name='" + name + "'><link name='l'>" + content + "</link></model>";
}

std::string part(const std::string& kind, const std::string& pose, const std::string& size) {
  return "<" + kind + " name='" + kind + "'><pose>" + pose + "</pose><geometry>" + sdf_box(size) +
         "</geometry></" + kind + ">";
}

class Visuals : public WorldFile {
 protected:
  World with_visuals(const std::string& content) const {
    return World::load(write("w.sdf", sdf_world(content)).string(), {}, RayCasterKind::bullet,
                       true);
  }
};

TEST_F(Visuals, AreTakenWhereAModelHasNoCollision) {
  const std::string sofa = model("sofa", part("visual", "3 0 0 0 0 0", "1 1 1"));
  EXPECT_NEAR(range_ahead(with_visuals(sofa + kBoxAhead)), 2.5, 1e-9);
  EXPECT_NEAR(range_ahead(load(sofa + kBoxAhead)), 4.0, 1e-9);
  const std::string both = model(
      "chair", part("visual", "3 0 0 0 0 0", "1 1 1") + part("collision", "6 0 0 0 0 0", "1 1 1"));
  EXPECT_NEAR(range_ahead(with_visuals(both)), 5.5, 1e-9) << "its collision is what a laser sees";
}

TEST_F(Visuals, OfAModelWithColoursAndEqualNames) {
  const std::string visual =
      "<visual name='v'><transparency>x</transparency><material><script/></material><geometry>" +
      sdf_box("1 1 1") + "</geometry></visual>";
  EXPECT_EQ(with_visuals(model("sofa", visual + visual)).faces().size(), 12U);
}

TEST_F(Visuals, ThatCannotBeReadAreRefused) {
  EXPECT_THAT([&] { with_visuals(model("sofa", part("visual", "3 0 0 0 0 0", "1 0 1"))); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("'sofa::l::visual'")));
}

TEST_F(Visuals, AloneAreNamed) {
  const std::string sofa = model("sofa", part("visual", "3 0 0 0 0 0", "1 1 1"));
  EXPECT_THAT(load(sofa + kBoxAhead).content(),
              AllOf(HasSubstr("1 model without collision (sofa;"), HasSubstr("--visuals")));
  EXPECT_THAT(error_of_content(sofa), AllOf(HasSubstr("<collision>"), HasSubstr("--visuals")));
}

std::string field(const std::string& name) {
  return PROJECT_DIR "/test/data/field/" + name + ".world";
}

TEST(FieldWorlds, Load) {
  EXPECT_EQ(World::load(field("sdf_visual_script_without_uri")).faces().size(), 36U);
  EXPECT_EQ(World::load(field("sdf_invalid_inertia")).faces().size(), 36U);
  EXPECT_EQ(World::load(field("sdf_link_name_colons")).faces().size(), 12U);
}

TEST(FieldWorlds, StateIsWhatGazeboShows) {
  const World world = World::load(field("sdf_state_ignored"));
  EXPECT_NEAR(range_ahead(world, {0, 0, 0.5}), 2.7, 1e-9);
  EXPECT_NEAR(range_ahead(world, {0, 2, 0.5}), 3.95, 1e-9) << "nothing is left there";
}

}  // namespace
}  // namespace ribbon_mapper::sim
