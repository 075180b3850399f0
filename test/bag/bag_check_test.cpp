// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/bag_check.hpp"

#include <gmock/gmock.h>
#include <rosbag/bag.h>
#include <std_msgs/Header.h>

#include <cstdlib>
#include <fstream>
#include <limits>

#include "test/bag/wall_bag.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class BagCheck : public testing::Test {
 protected:
  BagCheck() { ros::Time::init(); }

  BagReport check(const WallBag& bag, const BagOptions& options = {}) {
    bag.write(file_);
    return check_bags({file_}, options);
  }
  static void expect_words(const BagReport& report, Finding::Weight weight,
                           const std::string& words) {
    for (const Finding& finding : report.findings()) {
      if (finding.weight == weight && finding.text.find(words) != std::string::npos) return;
    }
    ADD_FAILURE() << "'" << words << "' is not found in\n" << report.text();
  }
  void finds_fault(const BagReport& report, const std::string& words) {
    EXPECT_FALSE(report.can_be_mapped()) << report.text();
    expect_words(report, Finding::Weight::fault, words);
  }
  void finds_warning(const BagReport& report, const std::string& words) {
    EXPECT_TRUE(report.can_be_mapped()) << report.text();
    expect_words(report, Finding::Weight::warning, words);
  }
  /// Returns the exit code of bag_check.
  int exit_code() const {
    return WEXITSTATUS(
        std::system((std::string(BAG_CHECK) + " " + file_.string() + " > /dev/null 2>&1").c_str()));
  }

  TemporaryDirectory directory_;
  fs::path file_ = directory_.path() / "wall.bag";
  WallBag bag_;
};

TEST_F(BagCheck, PassesAGoodBagWithoutAWarning) {
  const BagReport report = check(bag_);
  EXPECT_TRUE(report.can_be_mapped());
  EXPECT_EQ(report.count(Finding::Weight::warning), 0u) << report.text();
  EXPECT_THAT(report.text(), HasSubstr("200 scans of 201 beams at 40.0 Hz"));
  EXPECT_THAT(report.text(), HasSubstr("+-17.2 degrees, period 2.00 s"));
  EXPECT_EQ(exit_code(), 0);
}

TEST_F(BagCheck, PassesSlashesAndSaysSo) {
  bag_.slash = "/";
  bag_.laser_frame = "/laser_tilt_link";
  const BagReport report = check(bag_);
  EXPECT_TRUE(report.can_be_mapped()) << report.text();
  EXPECT_THAT(report.text(), HasSubstr("leading slash; it is stripped"));
}

TEST_F(BagCheck, NoScan) {
  bag_.lines = 0;
  finds_fault(check(bag_), "no topic with sensor_msgs/LaserScan");
  EXPECT_EQ(exit_code(), 1);
}

TEST_F(BagCheck, AnotherTypeOnTheTopic) {
  {
    rosbag::Bag bag(file_.string(), rosbag::bagmode::Write);
    bag.write("/tilt_scan", ros::Time(1.0), std_msgs::Header());
  }
  BagOptions options;
  options.scan_topic = "tilt_scan";
  finds_fault(check_bags({file_}, options), "carries std_msgs/Header");
}

TEST_F(BagCheck, CutShort) {
  bag_.write(file_);
  fs::resize_file(file_, fs::file_size(file_) / 2);
  finds_fault(check_bags({file_}, {}), "cut short");
}

TEST_F(BagCheck, WithoutAnIndex) {
  bag_.write(file_);
  std::fstream stream(file_, std::ios::in | std::ios::out | std::ios::binary);
  std::string head(4096, '\0');
  stream.read(head.data(), 4096);
  const std::size_t place = head.find("index_pos=");
  ASSERT_NE(place, std::string::npos);
  stream.seekp(static_cast<std::streamoff>(place) + 10);
  stream.write("\0\0\0\0\0\0\0\0", 8);
  stream.close();
  finds_fault(check_bags({file_}, {}), "rosbag reindex");
}

TEST_F(BagCheck, NoTransforms) {
  bag_.with_tf = bag_.with_static = false;
  finds_fault(check(bag_), "there is no /tf");
}

TEST_F(BagCheck, NoStaticTransforms) {
  bag_.with_static = false;
  finds_fault(check(bag_), "no transform connects laser_tilt_link and base_footprint");
}

TEST_F(BagCheck, NoMapFrame) {
  bag_.with_map = false;
  finds_warning(check(bag_), "--map-frame odom_combined is taken");
  BagOptions options;
  options.named_frames.map = true;
  finds_fault(check(bag_, options), "frame map is not in tf");
  expect_words(check(bag_, options), Finding::Weight::warning, "or leave out those that you have");
}

TEST_F(BagCheck, AnUnknownLaserFrame) {
  bag_.laser_frame = "tilt_laser";
  finds_fault(check(bag_), "frame tilt_laser is not in tf");
}

TEST_F(BagCheck, StampsThatGoBack) {
  bag_.spoil_scan = [](int line, sensor_msgs::LaserScan& scan) {
    if (line % 20 == 19) scan.header.stamp -= ros::Duration(0.1);
    return true;
  };
  finds_warning(check(bag_), "go backwards or stand still 10 times");
  bag_.spoil_scan = [](int, sensor_msgs::LaserScan& scan) {
    scan.header.stamp = ros::Time(1001.0);
    return true;
  };
  finds_fault(check(bag_), "go backwards or stand still");
}

TEST_F(BagCheck, NoStamps) {
  bag_.spoil_scan = [](int, sensor_msgs::LaserScan& scan) {
    scan.header.stamp = ros::Time();
    return true;
  };
  finds_fault(check(bag_), "no stamp");
}

TEST_F(BagCheck, AnotherClock) {
  bag_.first_stamp_s = 5000.0;
  finds_warning(check(bag_), "two clocks");
}

TEST_F(BagCheck, AGapInTransforms) {
  bag_.tf_gap_begin_s = 2.0, bag_.tf_gap_end_s = 3.0;
  finds_warning(check(bag_), "tf has a gap of 1.0");
}

TEST_F(BagCheck, AGapInScans) {
  bag_.spoil_scan = [](int line, sensor_msgs::LaserScan&) { return line < 80 || line > 160; };
  finds_warning(check(bag_), "no scans for 2.0");
}

TEST_F(BagCheck, ATiltThatStandsStill) {
  bag_.tilt_rad = 0.0;
  finds_fault(check(bag_), "the tilt does not move");
}

TEST_F(BagCheck, NoUsableRange) {
  bag_.spoil_scan = [](int, sensor_msgs::LaserScan& scan) {
    std::fill(scan.ranges.begin(), scan.ranges.end(), std::numeric_limits<float>::quiet_NaN());
    return true;
  };
  finds_fault(check(bag_), "not one range is usable");
}

TEST_F(BagCheck, ScansThatDoNotFitTheirAngles) {
  bag_.spoil_scan = [](int, sensor_msgs::LaserScan& scan) {
    scan.ranges.resize(7);
    return true;
  };
  finds_fault(check(bag_), "number of ranges does not fit the angles");
}

TEST_F(BagCheck, TransformsInALoop) {
  bag_.spoil_tf = [](tf2_msgs::TFMessage& message) {
    message.transforms[1].header.frame_id = "laser_tilt_link";  // whose ancestors end at the base
  };
  finds_fault(check(bag_), "would be dropped");
}

TEST_F(BagCheck, TransformsThatAreNoNumbers) {
  bag_.spoil_tf = [](tf2_msgs::TFMessage& message) {
    message.transforms[2].transform.rotation.w = std::numeric_limits<double>::quiet_NaN();
  };
  finds_fault(check(bag_), "would be dropped");
}

TEST_F(BagCheck, LinesCloserThanTheNoise) {
  bag_.tilt_rad = 0.02;
  finds_warning(check(bag_), "closer than the noise");
}

TEST_F(BagCheck, NoFile) {
  finds_fault(check_bags({directory_.path() / "none.bag"}, {}), "there is no such file");
  finds_fault(check_bags({directory_.path()}, {}), "is no file");
}

TEST(BagCheckProgram, WrongUsage) {
  EXPECT_EQ(WEXITSTATUS(std::system(BAG_CHECK " > /dev/null 2>&1")), 2);
}

}  // namespace
}  // namespace ribbon_mapper
