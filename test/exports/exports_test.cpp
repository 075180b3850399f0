// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/exports/exports.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "modeler/exports/floor_plan_geojson.hpp"
#include "modeler/semantics/rooms.hpp"
#include "modeler/surface/outline.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/modeler/semantics/rectangles.hpp"

namespace ribbon_mapper {
namespace {

using nlohmann::json;
using rectangles::level;
using rectangles::upright;

/// Returns a floor and a wall before which it ends.
std::vector<Plane> planes() {
  std::vector<Plane> planes{level(0, 0, 0, 4, 3, 1), upright(0, 3, 4, 0, 2.6, 2)};
  for (Plane& plane : planes) plane.outlines = outlines_of(plane, {});
  return planes;
}

FloorPlan plan_of(const std::vector<Plane>& planes) {
  const Semantics semantics = semantics_of(planes, {});
  return floor_plan_of(planes, semantics,
                       rooms_of(planes, semantics, SurfaceConfig{}.stripe_gap_m));
}

TEST(MeshFormats, AreThoseOfAList) {
  const auto glb_and_stl = std::vector<MeshFormat>{MeshFormat::gltf, MeshFormat::stl};
  EXPECT_EQ(glb_and_stl, mesh_formats_from("glb,stl"));
  EXPECT_EQ(glb_and_stl, mesh_formats_from("glb, stl,glb"));
  EXPECT_TRUE(mesh_formats_from("").empty());
  EXPECT_TRUE(mesh_formats_from("none").empty());
}

TEST(MeshFormats, OthersAreRefusedWithTheList) {
  for (const char* list : {"fbx", "glb,fbx", "GLB", ",", "glb;obj", "glb,none"}) {
    EXPECT_THAT([&] { mesh_formats_from(list); }, testing::ThrowsMessage<std::invalid_argument>(
                                                      testing::HasSubstr("glb, obj and stl")))
        << list;
  }
}

TEST(Exports, MeshesBelongToTheSetAndHaveLabels) {
  const TemporaryDirectory directory;
  FileSet files(directory.path(), "kitchen");
  const std::vector<MeshFormat> all{MeshFormat::gltf, MeshFormat::obj, MeshFormat::stl};
  add_meshes(planes(), {}, {{"floor", 1.0}, {"east w\xff\"ll", 1.0}}, all, "kitchen", files);
  files.commit();
  for (const char* name : {"kitchen.glb", "kitchen.obj", "kitchen.mtl", "kitchen.stl"}) {
    EXPECT_FALSE(content_of(directory.path() / name).empty()) << name;
  }
  const std::string glb = content_of(directory.path() / "kitchen.glb");
  EXPECT_NE(glb.find("plane 1 floor"), std::string::npos);
  const std::size_t begin = glb.find('{'), end = glb.rfind('}');
  EXPECT_TRUE(json::accept(glb.substr(begin, end - begin + 1))) << "bytes that are no UTF-8";
}

TEST(Exports, WithoutFormatsOrPlanesThereAreNoMeshes) {
  const TemporaryDirectory directory;
  FileSet files(directory.path(), "kitchen");
  add_meshes(planes(), {}, {}, {}, "kitchen", files);
  add_meshes({}, {}, {}, {MeshFormat::gltf}, "kitchen", files);
  EXPECT_TRUE(files.commit().empty());
}

TEST(FloorPlanGeoJson, HasWallsAndRoomsInMetres) {
  ModelLabel label;
  label.frame = "robot1/map";
  label.run = "0123";
  const json plan = json::parse(floor_plan_to_geojson(plan_of(planes()), label));
  EXPECT_EQ("FeatureCollection", plan["type"]);
  EXPECT_THAT(plan["coordinate_system"], testing::HasSubstr("metres in the frame robot1/map"));
  EXPECT_THAT(plan["crs"]["properties"]["name"], testing::StartsWith("ENGCRS[\"robot1/map\""));
  EXPECT_EQ("0123", plan["run"]);
  ASSERT_EQ(2u, plan["features"].size());
  const json& room = plan["features"][0];
  EXPECT_EQ("room", room["properties"]["kind"]);
  EXPECT_EQ("A", room["properties"]["name"]);
  EXPECT_NEAR(12.0, room["properties"]["area_m2"], 0.5);
  const json& ring = room["geometry"]["coordinates"][0];
  EXPECT_EQ(ring.front(), ring.back()) << "closed";
  const json& wall = plan["features"][1];
  EXPECT_EQ("wall", wall["properties"]["kind"]);
  EXPECT_EQ(1, wall["properties"]["faces"]);
  EXPECT_TRUE(wall["properties"]["thickness_m"].is_null());
  EXPECT_EQ("LineString", wall["geometry"]["type"]);
  EXPECT_EQ(json({2}), wall["properties"]["planes"]);
}

TEST(FloorPlanGeoJson, OfAnEmptyModelHasNoFeatures) {
  const json plan = json::parse(floor_plan_to_geojson(plan_of({})));
  EXPECT_TRUE(plan["features"].empty());
}

TEST(FloorPlanGeoJson, HasTheSameBytesAgain) {
  EXPECT_EQ(floor_plan_to_geojson(plan_of(planes())), floor_plan_to_geojson(plan_of(planes())));
}

}  // namespace
}  // namespace ribbon_mapper
