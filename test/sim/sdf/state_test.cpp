// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// <state>: Gazebo Classic shows models and links there, in the frame of the world.
#include "test/sim/sdf/world_file.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string state(const std::string& content) {
  return "<state world_name='test'>" + content + "</state>";
}

std::string pose(const std::string& values) { return "<pose>" + values + "</pose>"; }

std::string part(const std::string& kind, const std::string& name, const std::string& content) {
  return "<" + kind + " name='" + name + "'>" + content + "</" + kind + ">";
}

const std::string kBox = sdf_model("box", "0 2 0 0 0 0", sdf_box("1 1 1"));

TEST_F(WorldFile, StatePlacesModels) {
  EXPECT_NEAR(range_ahead(load(kBox + state(part("model", "box", pose("3.2 0 0 0 0 0"))))), 2.7,
              1e-9);
  EXPECT_NEAR(range_ahead(load(state(part("model", "box", pose("3.2 0 0 0 0 0"))) + kBox)), 2.7,
              1e-9)
      << "also before the model";
  EXPECT_NEAR(range_ahead(load(kBox + state(part("model", "box", pose("5 0 0 0 0 0.785398163")))),
                          {0, 0, 0}),
              5.0 - std::sqrt(0.5), 1e-6)
      << "turned";
  EXPECT_NEAR(
      range_ahead(load(kBox + state(part("model", "other", pose("3 0 0 0 0 0")))), {-5, 2, 0}), 4.5,
      1e-9)
      << "another model's";
}

TEST_F(WorldFile, StatePlacesLinksInTheWorldsFrame) {
  const std::string links = part("link", "link", pose("4 0 0 0 0 0"));
  EXPECT_NEAR(range_ahead(load(kBox + state(part("model", "box", pose("1 1 1 0 0 1") + links)))),
              3.5, 1e-9);
  EXPECT_NEAR(range_ahead(load(kBox + state(part("model", "box", links)))), 3.5, 1e-9);
}

TEST_F(WorldFile, StateFindsLinksOfNestedModelsByTheirLongNames) {
  const std::string nested =
      "<model name='a'><model name='b'><link name='l'><collision name='c'><geometry>" +
      sdf_box("1 1 1") + "</geometry></collision></link></model></model>";
  const std::string flat = "<model name='a'><link name='b::l'><collision name='c'><geometry>" +
                           sdf_box("1 1 1") + "</geometry></collision></link></model>";
  const std::string by_long_name = part("model", "a", part("link", "b::l", pose("4 0 0 0 0 0")));
  EXPECT_NEAR(range_ahead(load(nested + state(by_long_name))), 3.5, 1e-9);
  EXPECT_NEAR(range_ahead(load(flat + state(by_long_name))), 3.5, 1e-9);
  EXPECT_NEAR(range_ahead(load(nested +
                               state(part("model", "a", part("model", "b", pose("6 0 0 0 0 0")))))),
              5.5, 1e-9);
}

TEST_F(WorldFile, StateScalesInsertsAndDeletes) {
  EXPECT_NEAR(range_ahead(load(kBox + state(part("model", "box",
                                                 pose("4 0 0 0 0 0") + "<scale>2 1 1</scale>")))),
              3.0, 1e-9);
  EXPECT_NEAR(range_ahead(load(kBox + state("<insertions>" + kBoxAhead + "</insertions>"))), 4.0,
              1e-9);
  const World world = load(kBoxAhead + kBox + state("<deletions><name>box</name></deletions>") +
                           sdf_model("tree", "7 0 0 0 0 0", sdf_box("1 1 1")));
  EXPECT_NEAR(range_ahead(world), 6.5, 1e-9);
}

TEST_F(WorldFile, StateOfIncludedModelsCounts) {
  write("models/crate/model.sdf", "<sdf version='1.6'>" + kBox + "</sdf>");
  write("models/crate/model.config",
        "<model><name>crate</name><sdf version='1.6'>model.sdf</sdf></model>");
  EXPECT_NEAR(range_ahead(load("<include><uri>model://crate</uri><name>c1</name></include>" +
                                   state(part("model", "c1", pose("3 0 0 0 0 0"))),
                               {folder("models")})),
              2.5, 1e-9);
}

TEST_F(WorldFile, StateThatCannotBeReadIsRefused) {
  for (const char* values : {"3 0 0", "nan 0 0 0 0 0", "there"})
    EXPECT_THAT(error_of_content(kBox + state(part("model", "box", pose(values)))),
                AllOf(HasSubstr("'box'"), HasSubstr("<pose>")));
}

}  // namespace
}  // namespace ribbon_mapper::sim
