// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/semantics/label_confusion.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "eval/experiment/run.hpp"
#include "eval/results/label_report.hpp"
#include "eval/results/run_log.hpp"
#include "eval/semantics/true_labels.hpp"
#include "test/modeler/semantics/rectangles.hpp"

namespace ribbon_mapper::eval {
namespace {

using namespace rectangles;
using Eigen::Vector3d;

std::vector<LabelledCell> labelled(const Plane& plane, Label label) {
  std::vector<LabelledCell> cells;
  for (const PlaneCell& cell : plane.cells) {
    cells.push_back({cell_centre(plane, cell), plane.normal, label});
  }
  return cells;
}

TEST(LabelConfusion, CountsTheAreaOfCells) {
  const Plane floor = level(0, 0, 0, 2, 1), table = level(0, 0, 0.7, 1, 1);
  std::vector<LabelledCell> truth = labelled(floor, Label::floor);
  for (const LabelledCell& cell : labelled(table, Label::top)) truth.push_back(cell);
  const Plane nowhere = level(5, 5, 5, 1, 1);
  const LabelConfusion confusion =
      label_confusion({floor, table, nowhere},
                      {{Label::floor, 1.0}, {Label::furniture, 1.0}, {Label::wall, 1.0}}, truth);
  EXPECT_NEAR(2.0, confusion.at(Label::floor, Label::floor), 1e-9);
  EXPECT_NEAR(1.0, confusion.at(Label::top, Label::furniture), 1e-9);
  EXPECT_NEAR(3.0, confusion.compared_m2(), 1e-9);
  EXPECT_NEAR(1.0, confusion.no_truth_m2, 1e-9);
  EXPECT_NEAR(2.0 / 3.0, confusion.right_share(), 1e-9);
}

TEST(LabelConfusion, KnowsTheSidesOfAWall) {
  const Plane front = upright(0, 0, 1, 0, 1);
  Plane back = front;
  back.normal = -front.normal;
  EXPECT_NEAR(1.0, label_confusion({back}, {{}}, labelled(front, Label::wall)).no_truth_m2, 1e-9);
}

TEST(LabelConfusion, ComesBackFromTheLineOfARun) {
  LabelConfusion confusion;
  confusion.area_m2[2][0] = 3.0;
  confusion.area_m2[4][4] = 7.0;
  confusion.no_truth_m2 = 0.5;
  Summary summary;
  summary.run.world = "w.sdf";
  summary.run.config = "c.yaml";
  summary.run.noise = "none";
  summary.run.tilt = "nav";
  summary.labels = confusion;
  const LoggedRun logged = parse_run_line(run_line(summary, ""));
  const LabelConfusion read = label_confusion_of(logged.figures, "labels.");
  EXPECT_EQ(confusion.area_m2, read.area_m2);
  EXPECT_EQ(0.5, read.no_truth_m2);
  EXPECT_EQ(0.7, logged.figures.at("labels.right"));
  EXPECT_NE(std::string::npos, label_table(read).find("70.00 %"));
}

TEST(TrueLabels, AreThoseOfTheWorld) {
  const sim::Face wall{"m::l::c/+x", Vector3d::UnitX(), 0.0, true, true, "wall"};
  EXPECT_EQ(Label::wall, true_label(wall, Vector3d::UnitX()));
  EXPECT_EQ(Label::wall, true_label(wall, Vector3d::UnitZ()));
  const sim::Face floor{"m::l::c/+z", Vector3d::UnitZ(), 0.0, true, true, "floor"};
  EXPECT_EQ(Label::floor, true_label(floor, Vector3d::UnitZ()));
  EXPECT_EQ(Label::furniture, true_label(floor, Vector3d::UnitX())) << "the edge of a platform";
  const sim::Face other{"m::l::c/+z", Vector3d::UnitZ(), 0.0, true, true, ""};
  EXPECT_EQ(Label::top, true_label(other, Vector3d::UnitZ()));
  EXPECT_EQ(Label::furniture, true_label(other, Vector3d::UnitX()));
  const sim::Face wrong{"m::l::c/+z", Vector3d::UnitZ(), 0.0, true, true, "flor"};
  EXPECT_THROW(true_label(wrong, Vector3d::UnitZ()), std::invalid_argument);
}

/// Labels are right over a flat and an attic, end to end.
TEST(Labels, AreRightInWorlds) {
  for (const std::string world : {"worlds/apartment.sdf", "worlds/slopes.sdf"}) {
    RunOptions run;
    run.world = world;
    const Results results = make_run(run, [](const Progress&) {});
    ASSERT_TRUE(results.summary.labels) << world;
    EXPECT_GE(results.summary.labels->right_share(), 0.97) << label_table(*results.summary.labels);
    EXPECT_EQ(0.0, results.summary.labels->at(Label::wall, Label::floor)) << world;
    EXPECT_EQ(results.models.corrected.size(), results.labels.size());
  }
}

}  // namespace
}  // namespace ribbon_mapper::eval
