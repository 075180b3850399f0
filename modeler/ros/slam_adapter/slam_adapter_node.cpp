// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <functional>
#include <stdexcept>

#include "modeler/ros/intake/clock_guard.hpp"
#include "modeler/ros/intake/tf_feed.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/node/strict_parameters.hpp"
#include "modeler/ros/run/run_node.hpp"
#include "modeler/ros/slam_adapter/rtabmap_graph.hpp"
#include "modeler/ros/slam_adapter/tf_history.hpp"
#include "modeler/ros/slam_adapter/trajectory_query.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kTfCache_s = 120.0;

/// Called before each message, so that a time jump is noticed before its data.
using CheckClock = std::function<void()>;

struct NodeParameters {
  std::string source;
  Frames frames;
  double period_s;
  int trajectory_id;

  static NodeParameters read() {
    StrictParameters from;
    NodeParameters p;
    p.source = from.required_text("source", "cartographer, rtabmap or tf");
    p.frames.map = from.frame("map_frame", p.frames.map);
    p.frames.odom = from.frame("odom_frame", p.frames.odom);
    p.frames.base = from.frame("base_frame", p.frames.base);
    p.period_s = from.number("period", 5.0, 0.1, 3600.0);
    p.trajectory_id = from.integer("trajectory_id", 0, 0, 1000000);
    from.refuse_unknown();
    return p;
  }
};

/// The corrected trajectory of a SLAM, as far as it is known.
class Source {
 public:
  virtual ~Source() = default;
  /// Returns all poses so far, stamps strictly increasing; empty if there are none yet.
  virtual std::vector<StampedPose> trajectory() = 0;
  /// Returns what must be published before there is a trajectory.
  virtual std::string waits_for() const = 0;
  /// Forgets what was received: simulated time was set back.
  virtual void start_next_run() = 0;
};

class TfSource : public Source {
 public:
  TfSource(ros::NodeHandle& node, const Frames& frames, CheckClock check_clock)
      : frames_(frames),
        history_(frames),
        tf_(kTfCache_s, {}, [this](const auto& transform) { take(transform); }),
        tf_feed_(node, tf_, std::move(check_clock)) {}

  std::vector<StampedPose> trajectory() override {
    history_.look_up(tf_.core());
    return history_.trajectory();
  }
  std::string waits_for() const override { return frames_.map + " -> " + frames_.odom + " on /tf"; }
  void start_next_run() override {
    history_ = TfHistory(frames_);
    tf_.start_next_run();
  }

 private:
  void take(const geometry_msgs::TransformStamped& transform) {
    if (without_slash(transform.header.frame_id) == frames_.map &&
        without_slash(transform.child_frame_id) == frames_.odom) {
      history_.take(time_of(transform.header.stamp), pose_of(transform.transform));
    }
    history_.look_up(tf_.core());
  }

  Frames frames_;
  TfHistory history_;
  TransformBuffer tf_;
  TfFeed tf_feed_;
};

class RtabmapSource : public Source {
 public:
  RtabmapSource(ros::NodeHandle& node, CheckClock check_clock)
      : check_clock_(std::move(check_clock)) {
    data_ = node.subscribe("mapData", 100, &RtabmapSource::on_message, this);
    graph_ = node.subscribe("mapGraph", 10, &RtabmapSource::on_message, this);
  }
  std::vector<StampedPose> trajectory() override { return slam_.trajectory(); }
  std::string waits_for() const override {
    return data_.getTopic() + " and " + graph_.getTopic() + " of RTAB-Map";
  }
  void start_next_run() override { slam_ = {}; }

 private:
  void on_message(const topic_tools::ShapeShifter::ConstPtr& message) {
    check_clock_();
    std::vector<std::uint8_t> bytes(message->size());
    ros::serialization::OStream stream(bytes.data(), message->size());
    message->write(stream);
    try {
      slam_.take(message->getMessageDefinition(), bytes.data(), bytes.size());
    } catch (const std::exception& error) {
      ROS_ERROR_THROTTLE(10.0, "A message of type %s is left out: %s",
                         message->getDataType().c_str(), error.what());
    }
  }

  CheckClock check_clock_;
  RtabmapGraph slam_;
  ros::Subscriber data_, graph_;
};

class CartographerSource : public Source {
 public:
  CartographerSource(ros::NodeHandle& node, const NodeParameters& parameters)
      : map_(parameters.frames.map), name_(node.resolveName("trajectory_query")) {
    request_.trajectory_id = parameters.trajectory_id;
    ros::ServiceClientOptions options(name_, kAnyDefinition, false, {});
    query_ = node.serviceClient(options);
  }
  std::vector<StampedPose> trajectory() override {
    TrajectoryQueryResponse response;
    if (!query_.call(request_, response, kAnyDefinition)) return {};
    if (response.status_code != 0) throw std::invalid_argument(response.status_message);
    if (response.trajectory.empty()) return {};
    nav_msgs::Path path;
    path.header.frame_id = map_;
    path.poses = response.trajectory;
    return trajectory_of(path, map_);
  }
  std::string waits_for() const override { return "service " + name_ + " of cartographer_node"; }
  void start_next_run() override {}  // keeps nothing

 private:
  std::string map_, name_;
  TrajectoryQueryRequest request_;
  ros::ServiceClient query_;
};

std::unique_ptr<Source> make_source(ros::NodeHandle& node, const NodeParameters& parameters,
                                    const CheckClock& check_clock) {
  if (parameters.source == "tf")
    return std::make_unique<TfSource>(node, parameters.frames, check_clock);
  if (parameters.source == "rtabmap") return std::make_unique<RtabmapSource>(node, check_clock);
  if (parameters.source == "cartographer")
    return std::make_unique<CartographerSource>(node, parameters);
  throw std::invalid_argument("parameter source is '" + parameters.source +
                              "', allowed are cartographer, rtabmap and tf");
}

bool differ(const std::vector<StampedPose>& a, const std::vector<StampedPose>& b) {
  if (a.size() != b.size()) return true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].stamp != b[i].stamp || !a[i].T_map_base.isApprox(b[i].T_map_base, 1e-6)) return true;
  }
  return false;
}

/// Publishes the whole corrected trajectory of a SLAM for the modeler whenever it changes.
class SlamAdapter {
 public:
  explicit SlamAdapter(const NodeParameters& parameters)
      : parameters_(parameters),
        source_(make_source(node_, parameters, [this] { check_clock(); })) {
    corrected_ = node_.advertise<nav_msgs::Path>("corrected_trajectory", 1, true);
    timer_ = node_.createWallTimer(ros::WallDuration(parameters.period_s),
                                   [this](const ros::WallTimerEvent&) { publish(); });
  }

 private:
  void check_clock() {
    if (!clock_.went_back()) return;
    source_->start_next_run();
    published_.clear();
    ROS_WARN("Simulated time went back: the trajectory starts again");
  }

  void publish() {
    check_clock();
    try {
      std::vector<StampedPose> trajectory = source_->trajectory();
      if (trajectory.empty()) {
        ROS_INFO("Waiting for %s", source_->waits_for().c_str());
      } else if (differ(trajectory, published_)) {
        published_ = std::move(trajectory);
        corrected_.publish(
            path_message(published_, parameters_.frames.map, published_.back().stamp));
      }
    } catch (const std::exception& error) {
      ROS_ERROR("No corrected trajectory from %s: %s", parameters_.source.c_str(), error.what());
    }
  }

  NodeParameters parameters_;
  ros::NodeHandle node_;
  ClockGuard clock_;
  std::unique_ptr<Source> source_;
  std::vector<StampedPose> published_;
  ros::Publisher corrected_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace ribbon_mapper

int main(int argc, char** argv) {
  const ribbon_mapper::NodeInfo info{
      "slam_adapter", "hands the trajectory of another SLAM to the modeler", nullptr};
  return ribbon_mapper::run_node(argc, argv, info, [] {
    ribbon_mapper::SlamAdapter node(ribbon_mapper::NodeParameters::read());
    ros::spin();
    return 0;
  });
}
