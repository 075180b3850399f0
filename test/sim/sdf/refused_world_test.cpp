// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What cannot be meant is refused, and the message names the place.
#include "test/sim/sdf/world_file.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string shape(const std::string& geometry) {
  return sdf_model("rack", "0 0 0 0 0 0", geometry);
}

class RefusedShape : public WorldFile,
                     public testing::WithParamInterface<std::pair<const char*, const char*>> {};
INSTANTIATE_TEST_SUITE_P(
    All, RefusedShape,
    testing::Values(
        std::pair("<box><siez>1 1 1</siez></box>", "'siez'"),
        std::pair("<box><size>1 1 1</size><Size>2 2 2</Size></box>", "'Size'"),
        std::pair("<cylinder><raduis>1</raduis><length>1</length></cylinder>", "'raduis'"),
        std::pair("<box/>", "without <size>"),
        std::pair("<cylinder><radius>1</radius></cylinder>", "without <length>"),
        std::pair("<mesh><scale>1 1 1</scale></mesh>", "without <uri>"),
        std::pair("<box><size>1 1 1</size><size>2 2 2</size></box>", "twice"),
        std::pair("<box><size>1 nan 1</size></box>", "'1 nan 1'"),
        std::pair("<box><size>1 1 inf</size></box>", "3 numbers"),
        std::pair("<box><size>1e30 1 1</size></box>", "'1e30 1 1'"),
        std::pair("<box><size>1 -1 1</size></box>", "'1 -1 1'"),
        std::pair("<box><size>1 0 1</size></box>", "'1 0 1'"),
        std::pair("<box><size>1 1</size></box>", "3 numbers"),
        std::pair("<box><size>1,1,1</size></box>", "'1,1,1'"),
        std::pair("<box><size>1 1 1 1</size></box>", "3 numbers"),
        std::pair("<sphere><radius>0</radius></sphere>", "<radius> '0'"),
        std::pair("<sphere><radius>one</radius></sphere>", "'one'"),
        std::pair("<cylinder><radius>1</radius><length>-2</length></cylinder>", "<length> '-2'"),
        std::pair("<plane><normal>0 0 0</normal></plane>", "<normal>"),
        std::pair("<plane><normal>0 0 up</normal></plane>", "'0 0 up'"),
        std::pair("<heightmap><uri>hills.png</uri></heightmap>", "export it as a mesh"),
        std::pair("<polyline><height>1</height></polyline>", "'polyline'"),
        std::pair("<bocks><size>1 1 1</size></bocks>", "'bocks'"),
        std::pair("<box><size>1 1 1</size></box><sphere><radius>1</radius></sphere>",
                  "two shapes")));

TEST_P(RefusedShape, NamesFileModelLinkAndElement) {
  const auto& [geometry, part] = GetParam();
  EXPECT_THAT(error_of_content(kBoxAhead + shape(geometry)),
              AllOf(HasSubstr("line 1"), HasSubstr("'rack::link::collision'"), HasSubstr(part)));
}

class RefusedPose : public WorldFile, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, RefusedPose,
                         testing::Values("0 0 nan 0 0 0", "0 0 0 inf 0 0", "1e30 0 0 0 0 0",
                                         "1 2 3", "1 2 3 0 0 0 0", "1,5 2 3 0 0 0", "here"));

TEST_P(RefusedPose, NamesFileAndModel) {
  EXPECT_THAT(error_of_content(sdf_model("rack", GetParam(), sdf_box("1 1 1"))),
              AllOf(HasSubstr("'rack'"), HasSubstr("<pose>"), HasSubstr("6 numbers")));
}

TEST_F(WorldFile, NearlyTheNameOfAnElementIsRefused) {
  const std::string box = "<geometry>" + sdf_box("1 1 1") + "</geometry>";
  const std::string collision = "<collision name='c'>" + box + "</collision>";
  for (const auto& [model, meant] : std::vector<std::pair<std::string, std::string>>{
           {"<modle name='m'><link name='l'>" + collision + "</link></modle>", "<model>"},
           {"<model name='m'><lnik name='l'>" + collision + "</lnik></model>", "<link>"},
           {"<model name='m'><poes>1 0 0 0 0 0</poes><link name='l'>" + collision +
                "</link></model>",
            "<pose>"},
           {"<model name='m'><link name='l'><colision name='c'>" + box +
                "</colision></link></model>",
            "<collision>"},
           {"<model name='m'><link name='l'><collision name='c'><geomtry/></collision></link>"
            "</model>",
            "<geometry>"},
           {"<include><ury>model://sun</ury></include>", "<uri>"}}) {
    EXPECT_THAT(error_of_content(kBoxAhead + model), HasSubstr("is " + meant + " meant?"));
  }
}

TEST_F(WorldFile, AShapeWhereNoneIsReadIsRefused) {
  const std::string link = "<link name='l'><collision name='c'><geometry>" + sdf_box("1 1 1") +
                           "</geometry></collision></link>";
  EXPECT_THAT(error_of_content(kBoxAhead + link), HasSubstr("'link'"));
  EXPECT_THAT(error_of_content(kBoxAhead + "<group>" + link + "</group>"), HasSubstr("'group'"));
  EXPECT_THAT(error_of_content(kBoxAhead + "<model name='m'><group>" + link + "</group></model>"),
              HasSubstr("'group'"));
}

TEST_F(WorldFile, AWorldInMillimetresIsRefused) {
  EXPECT_THAT(error_of_content(sdf_block("room", {0, 0, 0}, {8000, 6000, 2500})),
              AllOf(HasSubstr("8000 x 6000 x 2500 m"), HasSubstr("millimetres")));
  EXPECT_THAT(error_of_content(kBoxAhead + sdf_block("wall", {-4000, 3000, 0}, {4000, 3100, 2500})),
              HasSubstr("millimetres"));
  write("cupboard.obj", "v 0 0 0\nv 800 0 0\nv 0 600 2100\nf 1 2 3\n");
  EXPECT_THAT(error_of_content(kBoxAhead + shape(sdf_mesh("cupboard.obj"))),
              HasSubstr("<scale>0.001 0.001 0.001</scale>"));
  EXPECT_THAT(error_of_content(shape(sdf_box("0.008 0.006 0.0025"))), HasSubstr("metres"));
  EXPECT_THAT(error_of_content(sdf_model("far", "500000 0 0 0 0 0", sdf_box("1 1 1"))),
              HasSubstr("more than 10 km"));
}

TEST_F(WorldFile, AHighWorldIsAWarning) {
  EXPECT_THAT(load(kBoxAhead + sdf_block("wall", {-800, 0, 0}, {800, 0.1, 1900})).warnings(),
              testing::ElementsAre(HasSubstr("is a mesh in millimetres?")));
}

TEST_F(WorldFile, ALargeFlatWorldIsFine) {
  EXPECT_NEAR(range_ahead(load(kBoxAhead + sdf_block("ground", {-500, -500, -2}, {500, 500, -1}))),
              4.0, 1e-9);
}

}  // namespace
}  // namespace ribbon_mapper::sim
