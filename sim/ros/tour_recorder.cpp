// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/tour_recorder.hpp"

#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modeler/ros/messages/message_conversions.hpp"
#include "sim/robot/pr2.hpp"
#include "sim/ros/robot_messages.hpp"

namespace ribbon_mapper::sim {
namespace {

constexpr double kMapRate_hz = 30.0;
constexpr Time kTick = std::chrono::milliseconds(10);
constexpr const char* kMount = "laser_tilt_mount_link";
const Pose kMountToLaser = Pose(Eigen::Translation3d(0.0, 0.0, 0.03));  // laser_tilt_joint

/// Writes messages into a bag at times of the tour.
class Recorder {
 public:
  explicit Recorder(const std::filesystem::path& file)
      : bag_(file.string(), rosbag::bagmode::Write) {
    bag_.setCompression(rosbag::compression::LZ4);
  }

  template <typename Message>
  void write(const char* topic, Time at, const Message& message) {
    bag_.write(topic, stamp_of(kTourStart + at), message);
  }

  void write_transform(const char* topic, Time at, const char* parent, const char* child,
                       const Pose& pose) {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(stamped_transform(parent, child, pose, stamp_of(kTourStart + at)));
    write(topic, at, message);
  }

 private:
  rosbag::Bag bag_;
};

Time end_of(const Scan& scan) {
  return scan.stamp +
         from_seconds((static_cast<double>(scan.ranges_m.size()) - 1.0) * scan.time_increment_s);
}

void record_transforms(const Tour& tour, Time at, std::size_t& map_ticks, Recorder& recorder) {
  const Time in_tour = std::min(at, tour.duration());
  recorder.write_transform("/tf", at, "odom_combined", "base_footprint", tour.T_odom_base(in_tour));
  recorder.write_transform("/tf", at, "base_footprint", kMount,
                           tour.T_base_laser(at) * kMountToLaser.inverse());
  const auto map_stamp = [&] { return from_seconds(static_cast<double>(map_ticks) / kMapRate_hz); };
  for (; map_stamp() <= at; ++map_ticks) {
    const Time stamp = map_stamp();
    recorder.write_transform("/tf", stamp, "map", "odom_combined",
                             tour.T_map_odom(std::min(stamp, tour.duration())));
  }
}

/// Records the lines of the base laser from `line` on that end by `now`.
void record_base_scans(const Tour& tour, Time now, std::size_t& line, Recorder& recorder) {
  for (; line < tour.base_line_count() && tour.base_scan_end(line) <= now; ++line) {
    const Scan scan = tour.base_scan(line);
    recorder.write("/base_scan", now,
                   scan_message(scan, kBaseLaserFrame, stamp_of(kTourStart + scan.stamp)));
  }
}

std::vector<StampedPose> record(Tour& tour, const RecorderOptions& options,
                                const std::function<void(std::size_t)>& on_line,
                                Recorder& recorder) {
  std::vector<StampedPose> truth;
  recorder.write_transform("/tf_static", Time(0), kMount, kTiltLaserFrame, kMountToLaser);
  if (options.base_laser)
    recorder.write_transform("/tf_static", Time(0), "base_footprint", kBaseLaserFrame,
                             pr2::T_base_base_laser());
  const Time end = std::min(tour.duration(), from_seconds(std::min(options.longest_s, 1e6)));
  std::size_t map_ticks = 0, base_line = 0;
  std::optional<Scan> scan = tour.next_scan();
  for (Time now(0); now <= end + 10 * kTick; now += kTick) {
    record_transforms(tour, now, map_ticks, recorder);
    for (; scan && end_of(*scan) <= std::min(now, end); scan = tour.next_scan()) {
      const Time stamp = kTourStart + scan->stamp;
      truth.push_back({stamp, tour.true_T_map_base(scan->stamp)});
      recorder.write("/tilt_scan", now,
                     scan_message(*scan, kTiltLaserFrame,
                                  stamp_of(stamp + from_seconds(options.stamp_error_s))));
      if (on_line) on_line(truth.size());
    }
    if (options.base_laser) record_base_scans(tour, std::min(now, end), base_line, recorder);
  }
  return truth;
}

}  // namespace

std::vector<StampedPose> record_tour(Tour& tour, const RecorderOptions& options,
                                     const std::filesystem::path& bag,
                                     const std::function<void(std::size_t)>& on_line) {
  try {
    Recorder recorder(bag);
    return record(tour, options, on_line, recorder);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error("cannot write " + bag.string() + ": " + error.what());
  }
}

std::vector<StampedPose> keyframes(const std::vector<StampedPose>& trajectory, double step_m) {
  std::vector<StampedPose> kept;
  double travel_m = 0.0;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (i > 0) {
      travel_m +=
          (trajectory[i].T_map_base.translation() - trajectory[i - 1].T_map_base.translation())
              .norm();
    }
    if (i > 0 && i + 1 < trajectory.size() && travel_m < step_m) continue;
    kept.push_back(trajectory[i]);
    travel_m = 0.0;
  }
  return kept;
}

}  // namespace ribbon_mapper::sim
