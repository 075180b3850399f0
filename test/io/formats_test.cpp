// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <tuple>

#include "modeler/io/colour.hpp"
#include "modeler/io/octomap.hpp"
#include "modeler/io/planes_json.hpp"
#include "modeler/io/ply.hpp"
#include "modeler/surface/surface_config.hpp"
#include "test/io/small_plane.hpp"

namespace ribbon_mapper {
namespace {

TEST(PlanesJson, GoldenBytes) {
  EXPECT_EQ(planes_to_json({small_plane()}),
            "{\n\"frame\": \"map\",\n\"unit\": \"m\",\n\"planes\": [\n"
            "{\"id\":7,\"normal\":[0.0,0.0,1.0],\"d\":-0.5,\"area\":0.005,"
            "\"centroid\":[0.05,0.025,0.5],\"bbox\":[[0.0,0.0,0.5],[0.125,0.0625,0.5]],"
            "\"outlines\":[[[[0.0,0.0,0.5],[0.125,0.0,0.5],[0.125,0.0625,0.5],[0.0,0.0625,0.5]]]]}"
            "\n]\n}\n");
}

TEST(PlanesJson, NumbersComeBackExactly) {
  Plane plane = small_plane();
  plane.normal = Eigen::Vector3d(0.1, -1.0 / 3.0, 0.7).normalized();
  plane.d_m = 1.0 / 7.0;
  const auto json = nlohmann::json::parse(planes_to_json({plane, small_plane()}));
  ASSERT_EQ(json["planes"].size(), 2U);
  const auto& first = json["planes"][0];
  for (int i = 0; i < 3; ++i) EXPECT_EQ(first["normal"][i].get<double>(), plane.normal[i]);
  EXPECT_EQ(first["d"].get<double>(), plane.d_m);
}

TEST(PlanesJson, HaveLabels) {
  const auto json = nlohmann::json::parse(planes_to_json(
      {small_plane(), small_plane()}, {}, {{"wall", 0.75}, {"my \"desk\"", 1.0, "a \xff note"}}));
  EXPECT_EQ("wall", json["planes"][0]["label"]);
  EXPECT_EQ(0.75, json["planes"][0]["label_confidence"]);
  EXPECT_FALSE(json["planes"][0].contains("note"));
  EXPECT_EQ("my \"desk\"", json["planes"][1]["label"]);
  EXPECT_TRUE(json["planes"][1].contains("note"));
}

TEST(PlanesJson, NoPlanesAreValidJson) {
  EXPECT_TRUE(nlohmann::json::parse(planes_to_json({}))["planes"].empty());
}

TEST(PlanesJson, WithoutOutlineTheBoxIsThatOfTheCells) {
  Plane plane = small_plane();
  plane.outlines.clear();
  const Eigen::AlignedBox3d box = bounding_box(plane);
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(0.0, 0.0, 0.5)));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(0.1, 0.05, 0.5)));
  EXPECT_TRUE(bounding_box(Plane()).isEmpty());
}

/// Returns the bytes after the header of a PLY file.
std::string body_of(const std::string& ply) {
  const std::string end = "end_header\n";
  return ply.substr(ply.find(end) + end.size());
}

template <typename Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  Number number;
  std::memcpy(&number, bytes.data() + offset, sizeof(Number));
  return number;
}

TEST(Ply, CloudHasOnePointPerCell) {
  const std::string ply = planes_to_ply_cloud({small_plane()});
  EXPECT_NE(ply.find("element vertex 2\n"), std::string::npos);
  const std::string body = body_of(ply);
  constexpr std::size_t kPointSize = 6 * 4 + 3 + 4;
  ASSERT_EQ(body.size(), 2 * kPointSize);
  EXPECT_FLOAT_EQ(number_at<float>(body, kPointSize), 0.075F);
  EXPECT_FLOAT_EQ(number_at<float>(body, kPointSize + 8), 0.5F);
  EXPECT_EQ(number_at<std::uint8_t>(body, 24), plane_colour(7).red);
  EXPECT_EQ(number_at<std::int32_t>(body, 27), 7);
}

TEST(Ply, MeshCoversTheCellsAndFacesTheSeenSide) {
  const std::string ply = planes_to_ply_mesh({small_plane()}, SurfaceConfig{}.stripe_gap_m);
  ASSERT_NE(ply.find("element vertex 4\n"), std::string::npos);
  ASSERT_NE(ply.find("element face 2\n"), std::string::npos);
  const std::string body = body_of(ply);
  constexpr std::size_t kVertexSize = 6 * 4 + 3, kFaceSize = 1 + 3 * 4 + 4;
  ASSERT_EQ(body.size(), 4 * kVertexSize + 2 * kFaceSize);
  const auto corner = [&](std::size_t face, std::size_t i) {
    const auto at = 4 * kVertexSize + face * kFaceSize + 1 + 4 * i;
    const std::size_t vertex = number_at<std::uint32_t>(body, at) * kVertexSize;
    return Eigen::Vector3f(number_at<float>(body, vertex), number_at<float>(body, vertex + 4),
                           number_at<float>(body, vertex + 8));
  };
  float area_m2 = 0.0F;
  for (const std::size_t face : {0U, 1U}) {
    const Eigen::Vector3f cross =
        (corner(face, 1) - corner(face, 0)).cross(corner(face, 2) - corner(face, 0));
    EXPECT_GT(cross.z(), 0.0F);
    area_m2 += 0.5F * cross.norm();
  }
  EXPECT_NEAR(area_m2, 0.005F, 1e-6F);
}

TEST(OctoMap, CellsComeBackAsOccupiedVoxels) {
  Plane plane = small_plane();
  plane.origin.z() = 0.51;  // inside a voxel, not on the border of two
  std::stringstream stream(planes_to_octomap({plane}));
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary(stream));
  EXPECT_NEAR(tree.getResolution(), 0.05, 1e-9);
  EXPECT_EQ(tree.getNumLeafNodes(), 2U);
  for (const float x : {0.025F, 0.075F}) {
    const auto* node = tree.search(octomap::point3d(x, 0.025F, 0.51F));
    ASSERT_NE(node, nullptr);
    EXPECT_TRUE(tree.isNodeOccupied(node));
  }
}

TEST(OctoMap, SameModelSameBytes) {
  EXPECT_EQ(planes_to_octomap({small_plane()}), planes_to_octomap({small_plane()}));
  EXPECT_NO_THROW(planes_to_octomap({}));
}

/// Returns the small plane moved to a place in UTM, 32 T in Bavaria.
Plane plane_in_utm() {
  const Eigen::Vector3d shift(690'123.25, 5'334'567.75, 519.5);
  Plane plane = small_plane();
  plane.origin += shift;
  plane.centroid += shift;
  plane.d_m -= shift.z();
  for (Eigen::Vector3d& point : plane.outlines.front().outer) point += shift;
  return plane;
}

TEST(Origin, IsZeroWithinAKilometre) {
  EXPECT_EQ(origin_of({}), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(origin_of({small_plane()}), Eigen::Vector3d(0, 0, 0));
  Plane plane = small_plane();
  for (Eigen::Vector3d& point : plane.outlines.front().outer) point.x() -= 999.0;
  EXPECT_EQ(origin_of({plane}), Eigen::Vector3d(0, 0, 0));
}

TEST(Origin, IsInWholeKilometresNearPlanesFarAway) {
  EXPECT_EQ(origin_of({plane_in_utm()}), Eigen::Vector3d(690'000, 5'335'000, 0));
  Plane plane = small_plane();
  for (Eigen::Vector3d& point : plane.outlines.front().outer) point.y() -= 2'400'000.0;
  EXPECT_EQ(origin_of({plane}), Eigen::Vector3d(0, -2'400'000, 0));
}

TEST(Origin, IsSubtractedInPlyAndStated) {
  ModelLabel label;
  label.origin = origin_of({plane_in_utm()});
  for (const std::string& ply :
       {planes_to_ply_cloud({plane_in_utm()}, label),
        planes_to_ply_mesh({plane_in_utm()}, SurfaceConfig{}.stripe_gap_m, label)}) {
    EXPECT_NE(ply.find("\ncomment origin 690000 5335000 0\n"), std::string::npos);
    const float half_cell = ply.find("element face") == std::string::npos ? 0.025F : 0.0F;
    const std::string body = body_of(ply);
    EXPECT_NEAR(number_at<float>(body, 0), 123.25F + half_cell, 1e-4F);
    EXPECT_NEAR(number_at<float>(body, 4), -432.25F + half_cell, 1e-4F);
    EXPECT_NEAR(number_at<float>(body, 8), 520.0F, 1e-4F);
  }
}

TEST(Origin, IsStatedInJsonWhoseNumbersAreWhole) {
  ModelLabel label;
  label.origin = origin_of({plane_in_utm()});
  const auto json = nlohmann::json::parse(planes_to_json({plane_in_utm()}, label));
  EXPECT_EQ(json.at("origin"), nlohmann::json({690'000.0, 5'335'000.0, 0.0}));
  EXPECT_EQ(json.at("planes")[0].at("outlines")[0][0][0][1], 5'334'567.75);
}

TEST(Origin, LetsOctoMapsHoldPlanesFarAway) {
  ModelLabel label;
  label.origin = origin_of({plane_in_utm()});
  label.run = "0123456789abcdef";
  const std::string bytes = planes_to_octomap({plane_in_utm()}, label);
  EXPECT_NE(bytes.find("\n# run 0123456789abcdef\n# origin 690000 5335000 0\n"), std::string::npos);
  std::stringstream stream(bytes);
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary(stream));
  EXPECT_NE(tree.search(octomap::point3d(123.28F, -432.22F, 520.0F)), nullptr);
}

/// An OctoMap of 5 cm ends at 1638 m.
TEST(OctoMap, HoldsAModelThatIsLargerThanItsKeys) {
  Plane far = small_plane();
  far.origin.x() = 5000.0;
  for (Eigen::Vector3d& point : far.outlines.front().outer) point.x() += 5000.0;
  std::stringstream stream(planes_to_octomap({small_plane(), far}));
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary(stream));
  EXPECT_NEAR(tree.getResolution(), 0.2, 1e-9);
  EXPECT_NE(tree.search(octomap::point3d(0.05F, 0.02F, 0.5F)), nullptr);
  EXPECT_NE(tree.search(octomap::point3d(5000.05F, 0.02F, 0.5F)), nullptr);
}

TEST(Frame, OfAnyNameLeavesFilesWhole) {
  ModelLabel label;
  label.frame = "a \"map\"\nend_header\xff";
  const auto json = nlohmann::json::parse(planes_to_json({small_plane()}, label));
  EXPECT_EQ(json.at("frame").get<std::string>().substr(0, 8), "a \"map\"\n");
  const std::string ply = planes_to_ply_cloud({small_plane()}, label);
  EXPECT_NE(ply.find("a \"map\" end_header\xff frame, metres\n"), std::string::npos);
  EXPECT_EQ(ply.find("\nend_header\n"), ply.find("property int plane_id") + 21);
}

TEST(Colour, ColoursOfIdsDifferAndStandOut) {
  std::set<std::tuple<int, int, int>> seen;
  for (std::int64_t id = -3; id < 100; ++id) {
    const Colour c = plane_colour(id);
    seen.emplace(c.red, c.green, c.blue);
    const int brightest = std::max({c.red, c.green, c.blue});
    EXPECT_GT(brightest, 150) << id;
    EXPECT_GT(brightest - std::min({c.red, c.green, c.blue}), 80) << id;
  }
  EXPECT_EQ(seen.size(), 103U);
}

}  // namespace
}  // namespace ribbon_mapper
