// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What laser drivers report that is not as sensor_msgs/LaserScan has it.
#include <gmock/gmock.h>

#include <fstream>
#include <limits>

#include "modeler/io/config_file.hpp"
#include "modeler/ros/bag_check/bag_check.hpp"
#include "modeler/ros/bag_check/preset_proposal.hpp"
#include "modeler/ros/intake/model_doubts.hpp"
#include "test/bag/wall_bag.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Lasers : public testing::Test {
 protected:
  Lasers() { ros::Time::init(); }

  /// Returns the report on the bag with changed scans.
  std::string check(const std::function<void(int line, sensor_msgs::LaserScan& scan)>& change,
                    const ModelerConfig& preset = {}) {
    bag_.spoil_scan = [&](int line, sensor_msgs::LaserScan& scan) {
      change(line, scan);
      return true;
    };
    bag_.write(file_);
    return check_bags({file_}, {}, preset).text();
  }

  TemporaryDirectory directory_;
  fs::path file_ = directory_.path() / "wall.bag";
  WallBag bag_;
};

/// Replaces the ranges of the outer beams.
void without_return(sensor_msgs::LaserScan& scan, float value) {
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (i < 40 || i >= 160) scan.ranges[i] = value;
  }
}

TEST_F(Lasers, NoReturnReportedAsADistanceIsAWarningWithItsShare) {
  for (const float value : {30.0F, 29.99F, 12.5F}) {
    const std::string text =
        check([&](int, sensor_msgs::LaserScan& scan) { without_return(scan, value); });
    EXPECT_THAT(text, HasSubstr(" % of the ranges have one value, "));
    EXPECT_THAT(text, HasSubstr("and 1 plane with the poses as recorded\n"));
    EXPECT_THAT(text, HasSubstr("can be mapped, but see 1 warning"));
  }
}

TEST_F(Lasers, NoReturnAsRep117HasItIsNoWarning) {
  for (const float value : {INFINITY, -INFINITY, NAN, 0.0F}) {
    const std::string text =
        check([&](int, sensor_msgs::LaserScan& scan) { without_return(scan, value); });
    EXPECT_THAT(text, HasSubstr("and 1 plane with the poses as recorded\n"));
    EXPECT_THAT(text, HasSubstr("VERDICT  this can be mapped\n"));
  }
}

TEST_F(Lasers, WithoutARangeMaxAreTaken) {
  const std::string text = check([](int, sensor_msgs::LaserScan& scan) { scan.range_max = 0.0F; });
  EXPECT_THAT(text, HasSubstr("range_max is not set"));
  EXPECT_THAT(text, HasSubstr("ranges: 100.0 % usable"));
  EXPECT_THAT(text, HasSubstr("VERDICT  this can be mapped\n"));
}

TEST_F(Lasers, WithAngleMaxBeyondTheLastBeamAreTakenWithAWarning) {
  const std::string text = check([](int, sensor_msgs::LaserScan& scan) { scan.angle_max += 0.1F; });
  EXPECT_THAT(text, HasSubstr("angle_max counts 20 beams more than there are ranges"));
  EXPECT_THAT(text, HasSubstr("can be mapped, but see 1 warning"));
}

TEST_F(Lasers, OfAnyNumberOfBeamsMakeThePlane) {
  const std::string text = check([](int line, sensor_msgs::LaserScan& scan) {
    const std::size_t count = 201U - static_cast<std::size_t>(line % 17);
    scan.ranges.resize(count);
    scan.angle_max = scan.angle_min + static_cast<float>(count - 1) * scan.angle_increment;
  });
  EXPECT_THAT(text, HasSubstr("200 scans of 185 to 201 beams"));
  EXPECT_THAT(text, HasSubstr("and 1 plane with the poses as recorded\n"));
  EXPECT_THAT(text, HasSubstr("VERDICT  this can be mapped\n"));
}

TEST_F(Lasers, ATimeIncrementThatDoesNotFitThePeriodIsNamed) {
  for (const float factor : {0.05F, 0.34F, 8.0F}) {
    const std::string text = check([&](int, sensor_msgs::LaserScan& scan) {
      scan.time_increment = factor * 19.89e-6F;
      scan.scan_time = 0.025F;
    });
    for (const char* words : {"WARNING  time_increment is ", "scan_time is 25.0 ms",
                              "lines come every 25.0 ms", "19.89 us"}) {
      EXPECT_THAT(text, HasSubstr(words)) << factor;
    }
    EXPECT_EQ(factor > 6.0F, text.find("longer than their period") != std::string::npos);
  }
}

TEST_F(Lasers, ATimeIncrementThatFitsIsNoWarning) {
  for (const float factor : {0.0F, 1.0F, 6.2F}) {
    const std::string text =
        check([&](int, sensor_msgs::LaserScan& scan) { scan.time_increment = factor * 19.89e-6F; });
    EXPECT_THAT(text, Not(HasSubstr("WARNING  time_increment"))) << factor;
  }
}

TEST_F(Lasers, TurnsThatAreLeftOutAreNoWarning) {
  const std::string text = check([](int, sensor_msgs::LaserScan& scan) {
    scan.time_increment = 19.89e-6F / 3.0F;
    scan.scan_time = 0.025F / 3.0F;
  });
  EXPECT_THAT(text, HasSubstr("the laser leaves turns out"));
  EXPECT_THAT(text, Not(HasSubstr("WARNING")));
}

TEST_F(Lasers, ScansThatAreSkippedAreNoWarning) {
  const std::string text = check([](int, sensor_msgs::LaserScan& scan) {
    scan.time_increment = 19.89e-6F / 2.0F;
    scan.scan_time = 0.025F;
  });
  EXPECT_THAT(text, HasSubstr("the laser leaves turns out"));
  EXPECT_THAT(text, Not(HasSubstr("WARNING")));
}

TEST_F(Lasers, WithTooFewBeamsForARibbonCannotBeMapped) {
  const std::string text = check([](int, sensor_msgs::LaserScan& scan) {
    std::fill(scan.ranges.begin() + 4, scan.ranges.end(), NAN);
  });
  EXPECT_THAT(text, HasSubstr("FAULT    no plane: no line gives a ribbon ("));
  EXPECT_THAT(text, HasSubstr(" x no ribbons"));
  EXPECT_THAT(text, HasSubstr("ribbon.min_points"));
  EXPECT_THAT(text, Not(HasSubstr("x modelled")));
}

/// What can be modelled can be mapped, whatever share of it is lost.
TEST_F(Lasers, ThatLoseMostLinesCanBeMappedIfTheRestMakesPlanes) {
  const std::string text = check([](int line, sensor_msgs::LaserScan& scan) {
    if (line % 5 > 1) scan.header.frame_id = "elsewhere";
  });
  EXPECT_THAT(text, HasSubstr("WARNING  120 lines of 200 would be dropped"));
  EXPECT_THAT(text, HasSubstr("the last of these lines: frame elsewhere is not in tf"));
  EXPECT_THAT(text, HasSubstr("VERDICT  this can be mapped"));
}

TEST_F(Lasers, CoarserOrNoisierThanThePresetAreAWarningWithTheKeys) {
  ModelerConfig fine;
  fine.surface.cell_size_m = 0.01;
  EXPECT_THAT(check([](int, sensor_msgs::LaserScan&) {}, fine),
              HasSubstr("Cells of surface.cell_size_m (10 mm) stay empty"));
  ModelerConfig precise;
  precise.scan.range_sigma_m = 0.001;
  EXPECT_THAT(check([](int, sensor_msgs::LaserScan&) {}, precise),
              HasSubstr("but scan.range_sigma_m is 1 mm"));
}

TEST_F(Lasers, TheProposedPresetIsReadAndLeavesNoWarning) {
  ModelerConfig preset;
  preset.surface.cell_size_m = 0.01, preset.scan.range_sigma_m = 0.003;
  EXPECT_THAT(check([](int, sensor_msgs::LaserScan&) {}, preset), HasSubstr("2 warnings"));
  const fs::path file = directory_.path() / "proposed.yaml";
  const std::string text = proposed_preset({file_}, {}, preset);
  EXPECT_THAT(text, HasSubstr("\n#   scan.range_sigma_m: "));
  EXPECT_THAT(text, HasSubstr(" (default 0.018)\n"));
  std::ofstream(file) << text;
  const ModelerConfig proposed = load_config(file.string());
  EXPECT_GE(proposed.scan.range_sigma_m, 0.004);
  EXPECT_THAT(check_bags({file_}, {}, proposed).text(), HasSubstr("this can be mapped\n"));
}

LineLog log_of(const std::map<LineResult, int>& results) {
  LineLog log;
  for (const auto& [result, count] : results) {
    for (int i = 0; i < count; ++i) {
      log.received();
      log.handled(to_string(result), 0.0);
    }
  }
  return log;
}

TEST(BarrenLines, AreNamedAfterAFew) {
  BarrenLines barren;
  EXPECT_EQ("", barren.complaint(log_of({{LineResult::no_ribbons, 5}})));
  EXPECT_THAT(barren.complaint(log_of({{LineResult::no_ribbons, 25}})),
              HasSubstr("20 lines are taken, but none gives a ribbon (20 x no ribbons): "));
  EXPECT_EQ("",
            barren.complaint(log_of({{LineResult::no_ribbons, 25}, {LineResult::modelled, 1}})));
  EXPECT_NE("",
            barren.complaint(log_of({{LineResult::no_ribbons, 65}, {LineResult::modelled, 1}})));
}

TEST(BarrenLines, TheCauseIsThatOfTheNewLines) {
  BarrenLines barren;
  barren.complaint(log_of({{LineResult::modelled, 500}, {LineResult::no_ribbons, 50}}));
  const std::string text = barren.complaint(log_of(
      {{LineResult::modelled, 500}, {LineResult::no_ribbons, 51}, {LineResult::no_returns, 40}}));
  EXPECT_THAT(text, HasSubstr("(40 x no returns, 1 x no ribbons): no range lies within"));
}

TEST(BarrenLines, OfALaserAtRestAreNoFaultOnceThereIsAModel) {
  BarrenLines barren;
  EXPECT_THAT(barren.complaint(log_of({{LineResult::waiting, 1}, {LineResult::too_close, 99}})),
              HasSubstr("does it tilt"));
  barren.complaint(log_of({{LineResult::modelled, 50}, {LineResult::too_close, 99}}));
  EXPECT_EQ("",
            barren.complaint(log_of({{LineResult::modelled, 50}, {LineResult::too_close, 999}})));
}

TEST(WhyNoPlanes, NamesTheCause) {
  EXPECT_EQ("there is no scan", why_no_planes({}, {}, {}));
  LineLog dropped;
  dropped.received();
  dropped.dropped("frame map is not in tf");
  EXPECT_EQ("no line can be used: 1 x frame map is not in tf", why_no_planes(dropped, {}, {}));
  EXPECT_THAT(why_no_planes(log_of({{LineResult::no_returns, 9}}), {}, {}),
              HasSubstr("scan.max_range_m"));
  ModelStatistics statistics;
  statistics.ribbons = 5;
  EXPECT_THAT(why_no_planes(log_of({{LineResult::modelled, 9}}), statistics, {}),
              HasSubstr("5 ribbons, but they make no plane of assembly.min_ribbons (10)"));
}

}  // namespace
}  // namespace ribbon_mapper
