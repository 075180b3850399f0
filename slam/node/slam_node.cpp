// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include <optional>
#include <utility>

#include "modeler/ros/intake/clock_guard.hpp"
#include "modeler/ros/intake/tf_feed.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/run/run_node.hpp"
#include "slam/node/closing.hpp"
#include "slam/node/slam_diagnostics.hpp"
#include "slam/node/slam_publisher.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr const char* kStopped = "time went back, ~reset is awaited";
// Lines beyond these wait in the intake, which drops the oldest with a reason: memory is bounded.
constexpr std::size_t kMaxLinesBehind = 5000;

std::optional<BaseLaserInput> base_laser(const SlamParameters& parameters,
                                         const ros::NodeHandle& node) {
  if (parameters.base_scan.empty()) return std::nullopt;
  return std::optional<BaseLaserInput>(std::in_place, parameters.lines.options,
                                       node.resolveName(parameters.base_scan));
}

/// Runs the estimate of the trajectory on ROS. One thread serves all callbacks but ~close, and none
/// of them blocks; another one computes.
class SlamNode {
 public:
  explicit SlamNode(const SlamParameters& parameters);

 private:
  enum class Close { none, awaits_lines, adjusts };

  void subscribe();
  void on_scan(const sensor_msgs::LaserScan& scan);
  void on_base_scan(const sensor_msgs::LaserScan& scan);
  bool on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool on_close(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  void advertise_close();
  void tick();
  void check_clock();
  void on_time_jump();
  void start_again(const char* why);
  void restart_intake(const char* why);
  void take_lines();
  void hand_held_over();
  void take_news();
  void advance_close();
  void answer_close(const EstimateNews& news);
  void report();

  SlamParameters parameters_;
  ros::NodeHandle node_, private_node_{"~"};
  LineLog log_;
  LineIntake intake_;
  std::optional<BaseLaserInput> base_laser_;
  std::optional<ReadyLine> held_;  ///< the oldest line, which waits for the base laser
  ClockGuard clock_;
  AttentiveClock wait_clock_;
  TransformBuffer tf_;
  TfFeed tf_feed_;
  EstimateWorker worker_;
  SlamPublisher publisher_;
  LineReport line_report_;
  SlamDiagnostics diagnostics_;
  EstimateStatus status_;
  bool stopped_ = false;  ///< by a time jump, until ~reset
  Time newest_received_{0};
  std::size_t reports_ = 0, reported_lines_ = 0;
  Close close_ = Close::none;
  ros::WallTime close_deadline_;
  Closing closing_;
  ros::CallbackQueue close_queue_;
  ros::ServiceServer reset_, close_service_;
  ros::Subscriber scan_, base_scan_;
  ros::WallTimer line_timer_, report_timer_;
  ros::AsyncSpinner close_spinner_{1, &close_queue_};
};

SlamNode::SlamNode(const SlamParameters& parameters)
    : parameters_(parameters),
      intake_(parameters.lines.options, log_),
      base_laser_(base_laser(parameters, node_)),
      tf_(parameters.tf_cache_s, parameters.lines.tf_drop_frames),
      tf_feed_(node_, tf_, [this] { check_clock(); }),
      worker_(parameters.config, parameters.estimate, !parameters.base_scan.empty()),
      publisher_(node_, private_node_, parameters),
      line_report_(log_, intake_, tf_, node_.resolveName("scan")),
      diagnostics_(worker_, parameters.estimate.window_s, line_report_,
                   base_laser_ ? &*base_laser_ : nullptr) {
  reset_ = private_node_.advertiseService("reset", &SlamNode::on_reset, this);
  advertise_close();
  subscribe();
  line_timer_ = node_.createWallTimer(ros::WallDuration(0.02),
                                      [this](const ros::WallTimerEvent&) { tick(); });
  report_timer_ = node_.createWallTimer(ros::WallDuration(1.0),
                                        [this](const ros::WallTimerEvent&) { report(); });
}

/// Subscribes to the lasers. Is called when everything is ready for the first line.
void SlamNode::subscribe() {
  if (base_laser_) {
    base_scan_ = node_.subscribe(parameters_.base_scan, 5000, &SlamNode::on_base_scan, this);
  }
  scan_ = node_.subscribe("scan", 5000, &SlamNode::on_scan, this);
}

/// Serves ~close in a thread of its own: it waits until all is computed.
void SlamNode::advertise_close() {
  auto options = ros::AdvertiseServiceOptions::create<std_srvs::Trigger>(
      "close", [this](auto& request, auto& response) { return on_close(request, response); },
      ros::VoidPtr(), &close_queue_);
  close_service_ = private_node_.advertiseService(options);
  close_spinner_.start();
}

void SlamNode::on_scan(const sensor_msgs::LaserScan& scan) {
  check_clock();
  line_report_.saw(scan);
  intake_.add(scan, wait_clock_.now());
  newest_received_ =
      time_of(scan.header.stamp) + from_seconds(parameters_.lines.options.scan_time_offset_s);
  if (stopped_) restart_intake(kStopped);
  take_lines();
}

void SlamNode::on_base_scan(const sensor_msgs::LaserScan& scan) {
  check_clock();
  base_laser_->add(scan, wait_clock_.now());
  if (stopped_) base_laser_->restart(kStopped);
  take_lines();
}

void SlamNode::restart_intake(const char* why) {
  intake_.restart(why);
  if (base_laser_) base_laser_->restart(why);
  if (std::exchange(held_, std::nullopt)) log_.dropped(why);
}

void SlamNode::tick() {
  take_lines();
  advance_close();
  take_news();
  publisher_.publish_transform();
}

void SlamNode::take_lines() {
  check_clock();
  const Moment now = wait_clock_.now();
  if (base_laser_ && worker_.lines_behind() < kMaxLinesBehind)
    base_laser_->hand_over(tf_.core(), now, worker_);
  while (worker_.lines_behind() < kMaxLinesBehind) {
    if (!held_) held_ = intake_.take_next(tf_.core(), now);
    if (!held_ || (base_laser_ && !base_laser_->lets_pass(middle_of(held_->beams), now))) return;
    hand_held_over();
  }
}

void SlamNode::hand_held_over() {
  if (held_) worker_.add(std::move(*held_));
  held_.reset();
}

void SlamNode::take_news() {
  const EstimateNews news = worker_.take_news();
  for (const LineOutcome& outcome : news.outcomes) {
    const bool is_refused =
        outcome.result == LineResult::malformed || outcome.result == LineResult::out_of_order;
    if (is_refused) {
      log_.dropped(to_string(outcome.result), outcome.defect);
    } else {
      log_.handled(to_string(outcome.result), outcome.seconds);
    }
  }
  if (base_laser_) base_laser_->refused(news.refused_base_scans);
  for (const Decision& decision : news.decisions)
    ROS_INFO("%s: %s", name_of(decision.kind).c_str(), decision.reason.c_str());
  if (std::exchange(status_, news.status).is_lost != news.status.is_lost) {
    ROS_WARN("%s", news.status.is_lost ? "The robot is lost: its pose may be wrong"
                                       : "The robot is no longer lost");
  }
  diagnostics_.saw(news.status);
  publisher_.publish(news);
  answer_close(news);
}

bool SlamNode::on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  restart_intake("reset");
  start_again("reset");
  stopped_ = false;
  response.success = true;
  response.message = "the estimate starts again";
  return true;
}

bool SlamNode::on_close(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  CloseAnswer answer = closing_.ask();
  response.success = answer.success;
  response.message = std::move(answer.message);
  return true;
}

/// Closes once all lines that came before are handed over, or once their wait is over.
void SlamNode::advance_close() {
  if (close_ == Close::none && closing_.is_asked()) {
    close_ = Close::awaits_lines;
    close_deadline_ =
        ros::WallTime::now() + ros::WallDuration(parameters_.lines.options.transform_timeout_s);
  }
  if (close_ != Close::awaits_lines) return;
  const bool has_all = !held_ && (intake_.waiting() == 0 || intake_.done() >= newest_received_);
  if (!has_all && ros::WallTime::now() < close_deadline_) return;
  hand_held_over();
  worker_.close();
  close_ = Close::adjusts;
}

void SlamNode::answer_close(const EstimateNews& news) {
  if (!news.is_closed || close_ != Close::adjusts) return;
  close_ = Close::none;
  CloseAnswer answer{news.status.lines > 0, "there is no pose yet: no line was taken"};
  if (answer.success) {
    answer.message = std::to_string(news.status.lines) + " poses adjusted in " +
                     std::to_string(static_cast<int>(1e3 * news.status.adjustment_s)) +
                     " ms, published on " + publisher_.trajectory_topic();
    ROS_INFO("%s", answer.message.c_str());
  }
  closing_.answer(std::move(answer));
}

void SlamNode::check_clock() {
  if (clock_.went_back()) on_time_jump();
}

/// Separates the runs: lines and transforms of before and after do not fit one trajectory.
void SlamNode::on_time_jump() {
  tf_.start_next_run();
  if (std::exchange(held_, std::nullopt)) log_.dropped("the clock was set back");
  intake_.start_next_run("the clock was set back");
  if (base_laser_) base_laser_->start_next_run("the clock was set back");
  newest_received_ = Time(0);
  if (parameters_.on_time_jump == OnTimeJump::reset) start_again("the clock was set back");
  publisher_.forget_clock();
  stopped_ = parameters_.on_time_jump == OnTimeJump::stop;
  if (stopped_) restart_intake(kStopped);
  ROS_WARN("Simulated time went back: %s", consequence_of(parameters_.on_time_jump));
}

void SlamNode::start_again(const char* why) {
  worker_.reset();
  publisher_.reset();
  log_ = {};
  if (base_laser_) base_laser_->reset_counts();
  line_report_.restart();
  status_ = {};
  diagnostics_.saw(status_);
  reported_lines_ = 0;
  if (std::exchange(close_, Close::none) != Close::none)
    closing_.answer({false, std::string("not closed: ") + why});
}

void SlamNode::report() {
  diagnostics_.publish();
  if (++reports_ % 5 != 0) return;  // counted, not throttled: simulated time may stand still
  line_report_.warn();
  if (base_laser_ && base_laser_->is_silent())
    ROS_WARN("The base laser is silent: the recorded odometry is used");
  const std::string complaint = line_report_.complaint();
  if (!complaint.empty()) {
    ROS_WARN("%s", complaint.c_str());
  } else if (std::exchange(reported_lines_, log_.lines()) != log_.lines()) {
    ROS_INFO("%zu lines (%zu dropped), %zu poses, %zu windows, %zu lines behind", log_.lines(),
             log_.dropped_lines(), status_.lines, status_.windows, worker_.lines_behind());
  }
}

}  // namespace
}  // namespace ribbon_mapper::slam

int main(int argc, char** argv) {
  const ribbon_mapper::NodeInfo info{"slam", "estimates the trajectory from odometry and planes",
                                     "slam.launch"};
  return ribbon_mapper::run_node(argc, argv, info, [] {
    ribbon_mapper::slam::SlamNode node(ribbon_mapper::slam::SlamParameters::read());
    ros::spin();
    return 0;
  });
}
