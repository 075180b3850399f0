// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// World files that are broken, incomplete or divided into parts.
#include "test/sim/sdf/world_file.hpp"

namespace ribbon_mapper::sim {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using testing::AllOf;
using testing::HasSubstr;

TEST_F(WorldFile, MissingFileSaysWhatToGive) {
  EXPECT_THAT(
      error_of(directory_.path() / "none.sdf"),
      HasSubstr("give the path of an SDF world, or a shipped one such as worlds/apartment.sdf"));
  EXPECT_THAT(error_of(directory_.path()), HasSubstr("no such file")) << "a folder";
}

TEST_F(WorldFile, EmptyFile) {
  EXPECT_THAT(error_of(write("empty.sdf", "")), HasSubstr("ign sdf --check"));
}

TEST_F(WorldFile, BrokenFile) {
  const std::string whole = sdf_world(sdf_model("a", "0 0 0 0 0 0", sdf_box("1 1 1")));
  EXPECT_THAT(error_of(write("cut.sdf", whole.substr(0, whole.size() / 2))),
              HasSubstr("ign sdf --check"));
  EXPECT_THAT(error_of(write("text.sdf", "not a world at all")), HasSubstr("ign sdf --check"));
  EXPECT_THAT(error_of(write("other.sdf", "<html><body/></html>")), HasSubstr("ign sdf --check"));
}

TEST_F(WorldFile, WithoutACollision) {
  const std::string visual = "<model name='a'><link name='l'><visual name='v'><geometry>" +
                             sdf_box("1 1 1") + "</geometry></visual></link></model>";
  EXPECT_THAT(error_of(write("bare.sdf", sdf_world(visual))), HasSubstr("<collision>"));
  EXPECT_THAT(error_of(write("void.sdf", sdf_world(""))), HasSubstr("<collision>"));
}

TEST_F(WorldFile, MissingIncludeIsNamed) {
  const auto path = write("w.sdf", sdf_world("<include><uri>model://sofa</uri></include>"));
  EXPECT_THAT(error_of(path), AllOf(HasSubstr("model://sofa"), HasSubstr("model path")));
}

TEST_F(WorldFile, MissingMeshIsNamed) {
  const auto path =
      write("w.sdf", sdf_world(sdf_model("a", "0 0 0 0 0 0", sdf_mesh("model://lamp/lamp.dae"))));
  EXPECT_THAT(error_of(path), AllOf(HasSubstr("model://lamp/lamp.dae"), HasSubstr("a::link"),
                                    HasSubstr("--model-path")));
}

TEST_F(WorldFile, UnreadableMeshIsNamed) {
  write("lamp.obj", "this is no mesh");
  const auto path = write("w.sdf", sdf_world(sdf_model("a", "0 0 0 0 0 0", sdf_mesh("lamp.obj"))));
  try {
    World::load(path.string());
    FAIL() << "was loaded";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(folder("lamp.obj")));
  }
}

TEST_F(WorldFile, OtherGeometryIsNamed) {
  const std::string capsule = "<capsule><radius>0.2</radius><length>1</length></capsule>";
  const std::string sdf = "<sdf version='1.8'><world name='w'>" +
                          sdf_model("pill", "0 0 0 0 0 0", capsule) + "</world></sdf>";
  EXPECT_THAT(error_of(write("w.sdf", sdf)), AllOf(HasSubstr("pill"), HasSubstr("replace it")));
}

/// Composes poses of model, link and collision, each with a turn that affects the next offset.
TEST_F(WorldFile, PosesAreComposed) {
  const std::string model =
      "<model name='m'><pose>2 0 0 0 0 1.5707963267948966</pose>"
      "<link name='l'><pose>0 -1 0 0 0 -1.5707963267948966</pose>"
      "<collision name='c'><pose>0.5 0 0 0 0 0.7853981633974483</pose><geometry>" +
      sdf_box("1 1 1") + "</geometry></collision></link></model>";
  // The model is at x = 2 and faces +y. The link is 1 m to its right, at x = 3. The collision is at
  // x = 3.5, turned by 45 degrees: its edge lies half a diagonal before its centre.
  EXPECT_NEAR(range_ahead(World::load(write("w.sdf", sdf_world(model)).string())),
              3.5 - std::sqrt(0.5), 1e-9);
}

TEST_F(WorldFile, RollPitchYawAreAboutFixedAxes) {
  // A stick along x, pitched by 90 degrees, points down; a later yaw cannot move it.
  const World world = World::load(
      write("w.sdf",
            sdf_world(sdf_model("stick", "3 0 0 0 1.5707963267948966 0.7", sdf_box("4 0.2 0.2"))))
          .string());
  const auto below = world.cast({3, 0, -5}, Vector3d::UnitZ(), 50.0);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->range_m, 3.0, 1e-9);
  EXPECT_FALSE(world.cast({3.5, 0, -5}, Vector3d::UnitZ(), 50.0));
}

const char* const kModelOfABox =
    "<sdf version='1.6'><model name='box'><link name='l'><collision name='c'><geometry>"
    "<box><size>2 2 2</size></box></geometry></collision></link></model></sdf>";

TEST_F(WorldFile, IncludesAreFoundInTheModelPath) {
  write("models/box/model.sdf", kModelOfABox);
  write("models/box/model.config",
        "<model><name>box</name><sdf version='1.6'>model.sdf</sdf></model>");
  const auto path = write("w.sdf", sdf_world("<include><uri>model://box</uri>"
                                             "<pose>5 0 0 0 0 0</pose></include>"));
  EXPECT_NEAR(range_ahead(World::load(path.string(), {folder("nowhere"), folder("models")})), 4.0,
              1e-9);
  EXPECT_THAT(error_of(path, {folder("nowhere")}), HasSubstr("model://box"));
}

/// Returns a quad across the x axis at `x_m`.
std::string obj_wall(double x_m) {
  std::ostringstream text;
  for (const char* yz : {"-1 -1", "1 -1", "1 1", "-1 1"}) text << "v " << x_m << " " << yz << "\n";
  text << "f 1 2 3 4\n";
  return text.str();
}

TEST_F(WorldFile, MeshesAreFoundBesideTheFileThenInTheModelPathsInTheirOrder) {
  const auto path =
      write("w.sdf", sdf_world(sdf_model("a", "0 0 0 0 0 0", sdf_mesh("parts/wall.obj"))));
  write("late/parts/wall.obj", obj_wall(7));
  EXPECT_NEAR(range_ahead(World::load(path.string(), {folder("early"), folder("late")})), 7, 1e-6);
  write("early/parts/wall.obj", obj_wall(6));
  EXPECT_NEAR(range_ahead(World::load(path.string(), {folder("early"), folder("late")})), 6, 1e-6);
  write("parts/wall.obj", obj_wall(5));
  EXPECT_NEAR(range_ahead(World::load(path.string(), {folder("early"), folder("late")})), 5, 1e-6);
}

TEST_F(WorldFile, AMeshOfAnIncludedModelIsFoundBesideThatModel) {
  write("models/wall/meshes/wall.obj", obj_wall(4));
  write("models/wall/model.config",
        "<model><name>wall</name><sdf version='1.6'>model.sdf</sdf></model>");
  write("models/wall/model.sdf",
        "<sdf version='1.6'>" +
            sdf_model("wall", "0 0 0 0 0 0", sdf_mesh("model://wall/meshes/wall.obj")) + "</sdf>");
  const auto path = write("w.sdf", sdf_world("<include><uri>model://wall</uri></include>"));
  EXPECT_NEAR(range_ahead(World::load(path.string(), {folder("models")})), 4.0, 1e-6);
}

TEST_F(WorldFile, AModelAloneIsAWorldToo) {
  EXPECT_NEAR(range_ahead(World::load(write("box.sdf", kModelOfABox).string())), 1.0, 1e-9);
}

}  // namespace
}  // namespace ribbon_mapper::sim
