// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names that Gazebo takes, and where included models are found.
#include "test/sim/sdf/world_file.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string link(const std::string& name, const std::string& pose,
                 const std::string& collisions =
                     "<collision name='c'><geometry><box>"
                     "<size>1 1 1</size></box></geometry></collision>") {
  return "<link name='" + name + "'><pose>" + pose + "</pose>" + collisions + "</link>";
}

std::string model(const std::string& name, const std::string& content) {
  return "<model name='" + name + "'>" + content + "</model>";
}

TEST_F(WorldFile, ModelsOfEqualNamesAreRenamedAsGazeboDoes) {
  const World world = load(sdf_model("chair", "3 0 0 0 0 0", sdf_box("1 1 1")) +
                           sdf_model("chair", "0 4 0 0 0 0", sdf_box("1 1 1")) +
                           sdf_model("chair", "0 8 0 0 0 0", sdf_box("1 1 1")));
  EXPECT_EQ(world.faces().size(), 18U);
  EXPECT_THAT(world.faces()[6].name, HasSubstr("chair_0::"));
  EXPECT_THAT(world.faces()[12].name, HasSubstr("chair_1::"));
  EXPECT_THAT(world.warnings(), testing::ElementsAre(HasSubstr("2 elements")));
}

TEST_F(WorldFile, LinksAndCollisionsOfEqualNamesAreRenamed) {
  const std::string collision =
      "<collision name='c'><geometry>" + sdf_box("1 1 1") + "</geometry></collision>";
  EXPECT_EQ(load(model("m", link("l", "3 0 0 0 0 0") + link("l", "6 0 0 0 0 0"))).faces().size(),
            12U);
  EXPECT_EQ(load(model("m", link("l", "3 0 0 0 0 0", collision + collision))).faces().size(), 12U);
  EXPECT_EQ(load(model("m", link("m", "3 0 0 0 0 0") + model("m", link("m", "6 0 0 0 0 0"))))
                .faces()
                .size(),
            12U);
}

TEST_F(WorldFile, NamesThatLibsdformatRefusesAreTaken) {
  for (const std::string name : {"window::link_2", "a::b::c", "::", "__x__", "world", "", "a:b"}) {
    EXPECT_NEAR(range_ahead(load(model("m", link(name, "3 0 0 0 0 0")))), 2.5, 1e-9) << name;
    EXPECT_NEAR(range_ahead(load(model(name, link("l", "3 0 0 0 0 0")))), 2.5, 1e-9) << name;
  }
  EXPECT_NEAR(range_ahead(load("<model><link><collision><pose>3 0 0 0 0 0</pose><geometry>" +
                               sdf_box("1 1 1") + "</geometry></collision></link></model>")),
              2.5, 1e-9)
      << "no names at all";
}

TEST_F(WorldFile, PosesMayReferToLinksFramesAndJoints) {
  const auto at = [&](const std::string& frame, const std::string& version) {
    return load("<sdf version='" + version + "'><world name='w'>" +
                model("m", link("a", "1 0 0 0 0 0", "") +
                               "<frame name='f' attached_to='a'><pose>0.5 0 0 0 0 0</pose></frame>"
                               "<joint name='j' type='fixed'><parent>world</parent><child>a</child>"
                               "<pose>0.25 0 0 0 0 0</pose></joint>"
                               "<link name='b'><pose relative_to='" +
                               frame + "'>3 0 0 0 0 0</pose><collision name='c'><geometry>" +
                               sdf_box("1 1 1") + "</geometry></collision></link>") +
                "</world></sdf>");
  };
  for (const std::string version : {"1.7", "1.8", "1.9", "1.10"}) {
    EXPECT_NEAR(range_ahead(at("__model__", version)), 2.5, 1e-9);
    EXPECT_NEAR(range_ahead(at("a", version)), 3.5, 1e-9);
    EXPECT_NEAR(range_ahead(at("f", version)), 4.0 - 0.5 + 0.5, 1e-9);
    EXPECT_NEAR(range_ahead(at("j", version)), 3.75, 1e-9);
  }
}

TEST_F(WorldFile, GazebosSunAndGroundPlaneNeedNoFolder) {
  for (const std::string uri : {"model://sun", "model:///sun", "model://sun/"})
    EXPECT_NEAR(range_ahead(load(kBoxAhead + "<include><uri>" + uri + "</uri></include>")), 4.0,
                1e-9);
  for (const std::string uri : {"model://ground_plane", "model:///ground_plane"}) {
    const World world =
        load("<include><uri>" + uri + "</uri><pose>0 0 -2 0 0 0</pose></include>" + kBoxAhead);
    const auto below = world.cast({0, 0, 0}, -Eigen::Vector3d::UnitZ(), 30.0);
    ASSERT_TRUE(below);
    EXPECT_NEAR(below->range_m, 2.0, 1e-9);
  }
}

class Included : public WorldFile {
 protected:
  void write_model(const std::string& name, const std::string& content) const {
    write("models/" + name + "/model.config",
          "<model><name>" + name + "</name><sdf version='1.6'>model.sdf</sdf></model>");
    write("models/" + name + "/model.sdf", "<sdf version='1.6'>" + content + "</sdf>");
  }
  std::vector<std::string> models() const { return {folder("models")}; }
  static std::string include(const std::string& uri, const std::string& more = "") {
    return "<include><uri>" + uri + "</uri>" + more + "</include>";
  }
};

TEST_F(Included, UrisOfThreeSlashesNameAModelToo) {
  write_model("box", model("box", link("l", "3 0 0 0 0 0")));
  EXPECT_NEAR(range_ahead(load(include("model:///box"), models())), 2.5, 1e-9);
  EXPECT_NEAR(range_ahead(load(include("model://box/model.sdf"), models())), 2.5, 1e-9);
  EXPECT_NEAR(range_ahead(load(include(" model://box\n"), models())), 2.5, 1e-9);
}

TEST_F(Included, TheIncludePlacesAndNamesTheModel) {
  write_model("box", model("box", "<pose>9 9 9 0 0 0</pose>" + link("l", "3 0 0 0 0 0")));
  const World world =
      load(include("model://box", "<name>crate</name><pose>1 0 0 0 0 0</pose>"), models());
  EXPECT_NEAR(range_ahead(world), 3.5, 1e-9);
  EXPECT_THAT(world.faces()[0].name, HasSubstr("crate::l::c"));
}

TEST_F(Included, ModelsOfModelsAreFoundAndEachCounts) {
  write_model("box", model("box", link("l", "0 0 0 0 0 0")));
  write_model("row", model("row", include("model://box", "<pose>3 0 0 0 0 0</pose>") +
                                      include("model://box", "<pose>6 0 0 0 0 0</pose>")));
  EXPECT_EQ(
      load(include("model://row") + include("model://row", "<pose>0 5 0 0 0 0</pose>"), models())
          .faces()
          .size(),
      24U);
}

TEST_F(Included, WhatALaserNeverSeesDoesNotMatterThereEither) {
  write_model("lamp", model("lamp",
                            "<link name='l'><inertial><mass>-1</mass></inertial>"
                            "<visual name='v'><material><script/></material></visual>"
                            "<collision name='c'><pose>3 0 0 0 0 0</pose><geometry>" +
                                sdf_box("1 1 1") + "</geometry></collision></link>"));
  EXPECT_NEAR(range_ahead(load(include("model://lamp"), models())), 2.5, 1e-9);
}

TEST_F(Included, ErrorsNameTheModelsFile) {
  write_model("box", model("box",
                           "<link name='l'><collision name='c'><geometry><box><size>0 1 1"
                           "</size></box></geometry></collision></link>"));
  EXPECT_THAT(error_of(write("w.sdf", sdf_world(include("model://box"))), models()),
              AllOf(HasSubstr("models/box/model.sdf"), HasSubstr("'box::l::c'")));
  write("models/box/model.sdf", "<sdf version='1.6'><model");
  EXPECT_THAT(error_of(write("w.sdf", sdf_world(include("model://box"))), models()),
              AllOf(HasSubstr("models/box/model.sdf"), HasSubstr("XML")));
}

TEST_F(Included, AModelThatIncludesItselfIsRefused) {
  write_model("snake", model("snake", include("model://snake")));
  EXPECT_THAT(error_of(write("w.sdf", sdf_world(include("model://snake"))), models()),
              HasSubstr("include itself"));
  write_model("hydra", model("hydra", include("model://a") + include("model://a")));
  write_model("a", model("a", include("model://hydra") + include("model://hydra")));
  EXPECT_THAT(error_of(write("w.sdf", sdf_world(include("model://hydra"))), models()),
              HasSubstr("include itself"));
}

}  // namespace
}  // namespace ribbon_mapper::sim
