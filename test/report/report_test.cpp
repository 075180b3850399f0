// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/report/report.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "modeler/report/model_history.hpp"
#include "modeler/report/packed_cells.hpp"
#include "test/report/sample_model.hpp"

namespace ribbon_mapper {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Report page(const std::vector<Plane>& planes, const ReportLimits& limits = {}) {
  Report report({"A room", "map", "", "", "", {}}, limits);
  report.add_trajectory("way", sample_path(10, 1.0));
  report.add_model({"now", &planes, {}, 0});
  return report;
}

TEST(Report, HoldsPlanesInMillimetresOnTheirAxes) {
  const json data = json::parse(page({sample_table()}).json());
  const json& plane = data.at("models").at(0).at("planes").at(0);
  EXPECT_EQ(plane.at("id"), 4);
  EXPECT_EQ(plane.at("origin"), json({3.0, 1.0, 0.7}));
  EXPECT_EQ(plane.at("rings").at(0).at(0), json({0, 0, 2000, 0, 2000, 1000, 0, 1000}));
  EXPECT_EQ(plane.at("rings").at(0).at(1), json({500, 250, 500, 750, 1500, 750, 1500, 250}));
  EXPECT_EQ(plane.at("points"), 1600);
}

TEST(Report, SaysWhatTheTruthSays) {
  const std::vector<Plane> planes{sample_floor(), sample_table()};
  Report report({"A room", "map", "", "", "", {}});
  report.add_model({"now",
                    &planes,
                    {{"floor", PlaneVerdict{PlaneVerdict::Kind::matched, 0, 0.5, -0.01}},
                     {"", PlaneVerdict{PlaneVerdict::Kind::extra, {}, {}, {}}}}});
  const json data = json::parse(report.json()).at("models").at(0).at("planes");
  EXPECT_EQ(data.at(0).at("label"), "floor");
  EXPECT_EQ(data.at(0).at("verdict"),
            json({{"kind", "matched"}, {"truth", 0}, {"angle_deg", 0.5}, {"offset_m", -0.01}}));
  EXPECT_EQ(data.at(1).at("verdict"), json({{"kind", "extra"}}));
  EXPECT_FALSE(data.at(1).contains("label"));
}

TEST(Report, NoTextEndsTheScriptOfTheData) {
  const std::string hostile = "</script><!--\xff\"'";
  Report report({hostile, hostile, hostile, hostile, hostile, {{{hostile, hostile, hostile}}}});
  report.add_trajectory(hostile, {});
  report.add_fact(hostile, hostile);
  report.add_table({hostile, {hostile}, {{hostile}}});
  report.add_room({hostile, 1.0, {}});
  EXPECT_THAT(report.json(), Not(HasSubstr("<")));
  EXPECT_EQ(json::parse(report.json()).at("title"), "</script><!--\xef\xbf\xbd\"'");
}

TEST(Report, ValuesThatAreNoNumbersAreLeftOut) {
  Plane plane = sample_table();
  plane.d_m = std::numeric_limits<double>::quiet_NaN();
  plane.outlines.front().outer.front().x() = std::numeric_limits<double>::infinity();
  plane.cells.front().mean_m = std::numeric_limits<float>::quiet_NaN();
  const json data = json::parse(page({plane}).json());
  EXPECT_TRUE(data.at("models").at(0).at("planes").at(0).at("d").is_null());
}

TEST(Report, KeepsTheFirstAndTheLastPoseOfALongWay) {
  Report report({"", "map", "", "", "", {}}, {0, 100});
  report.add_trajectory("way", sample_path(1234, 1.0));
  const json way = json::parse(report.json()).at("trajectories").at(0);
  const auto times = way.at("time_ms").get<std::vector<long>>();
  EXPECT_LE(times.size(), 100U);
  EXPECT_GE(times.size(), 50U);
  EXPECT_EQ(times.front(), 0);
  EXPECT_EQ(times.back(), 1'233'000);
  EXPECT_EQ(way.at("points_mm").size(), 3 * times.size());
}

TEST(Report, LeavesOutTheCellsOfSmallPlanesFirst) {
  const std::vector<Plane> planes{sample_table(), sample_floor(), sample_wall(2, 4.0)};
  const ReportLimits limits{sample_floor().cells.size() + sample_wall(2, 4.0).cells.size(), 100};
  const json data = json::parse(page(planes, limits).json()).at("models").at(0).at("planes");
  EXPECT_FALSE(data.at(0).contains("cells"));
  EXPECT_TRUE(data.at(1).contains("cells"));
  EXPECT_TRUE(data.at(2).contains("cells"));
  EXPECT_EQ(data.at(0).at("seen"), 800) << "how many there are is said nevertheless";
}

TEST(Report, TheSameAdditionsGiveTheSameBytes) {
  EXPECT_EQ(page({sample_table()}).html(), page({sample_table()}).html());
}

TEST(Report, AModelWithoutACorrectionIsShownAlone) {
  const std::vector<Plane> planes{sample_floor()};
  const ModelHistory history{"before", nullptr, {}, "now", &planes, sample_path(2, 0.0)};
  const json data = json::parse(report_of({"", "map", "", "", "", {}}, history).json());
  ASSERT_EQ(data.at("models").size(), 1U);
  EXPECT_EQ(data.at("models").at(0).at("name"), "now");
  EXPECT_EQ(data.at("trajectories").size(), 1U);
}

TEST(Report, OfAHistoryHasLabelsAndRooms) {
  const std::vector<Plane> planes{sample_floor()};
  ModelHistory history{"before", nullptr, {}, "now", &planes, sample_path(2, 0.0)};
  history.labels = {{"a person's floor", 1.0}};
  const Polygon square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}};
  history.rooms.rooms = {{4.0, {1.0, 1.0, 0.5}, {square}}};
  const json data = json::parse(report_of({"", "map", "", "", "", {}}, history).json());
  EXPECT_EQ(data.at("models").at(0).at("planes").at(0).at("label"), "a person's floor");
  const json& room = data.at("rooms").at(0);
  EXPECT_EQ(room.at("name"), "room A");
  EXPECT_EQ(room.at("area_m2"), 4.0);
  EXPECT_EQ(room.at("centre_mm"), json({1000, 1000, 500}));
  EXPECT_EQ(room.at("outlines_mm").at(0).at(0).at(5), 500) << "at the height of the centre";
}

TEST(PackedCells, AreRunsAndThenMeans) {
  Plane plane;
  plane.cells = {{-2, 5, 1, 0.001F, 0.0F}, {-1, 5, 1, -0.5F, 0.0F}, {200, 6, 1, 0.5F, 0.0F}};
  const PackedCells packed = packed_cells(plane);
  EXPECT_EQ(packed.u_begin, -2);
  EXPECT_EQ(packed.v_begin, 5);
  EXPECT_EQ(packed.columns, 203);
  EXPECT_EQ(packed.rows, 2);
  // Two runs: 2 cells after none, 1 cell after 403 - 0 * 128 = 0x93 0x03 in LEB128.
  std::vector<int> bytes;
  for (const char c : packed.bytes) bytes.push_back(static_cast<unsigned char>(c));
  EXPECT_THAT(bytes, ElementsAre(2, 0, 2, 0x93, 0x03, 1, 129, 1, 255));
}

TEST(PackedCells, Base64IsThatOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xff\xff"), "////");
}

TEST(ChangedKeys, AreThoseThatDifferFromTheDefaults) {
  EXPECT_TRUE(changed_keys({}).empty());
  ModelerConfig config;
  config.scan.max_range_m = 12.5;
  config.scan.deskew = !config.scan.deskew;
  const std::vector<ChangedKey> keys = changed_keys(config);
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].name, "scan.max_range_m");
  EXPECT_EQ(keys[0].value, "12.5");
  EXPECT_EQ(keys[1].name, "scan.deskew");
  EXPECT_NE(keys[1].value, keys[1].default_value);
}

}  // namespace
}  // namespace ribbon_mapper
