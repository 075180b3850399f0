// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/ros/tour_watch.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>

#include "eval/ros/received_planes.hpp"
#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr const char* kModelService = "modeler/get_model";
constexpr double kSettled_s = 20.0;  // after the tour, later corrections are not expected

std::vector<StampedPose> poses_from(const nav_msgs::Path::ConstPtr& path) {
  if (!path || path->poses.empty()) return {};
  return trajectory_of(*path, path->header.frame_id);
}

Eigen::Vector3d position_of(const geometry_msgs::PoseStamped& stamped) {
  const geometry_msgs::Point& at = stamped.pose.position;
  return {at.x, at.y, at.z};
}

/// Returns the seconds of tour per second of computing.
double modeler_speed(const std::vector<StampedPose>& trajectory, const GetModel::Response& state) {
  const double work_s = 1e-6 * state.us_per_line * static_cast<double>(state.lines);
  if (trajectory.empty() || work_s <= 0.0) return 0.0;
  return to_seconds(trajectory.back().stamp - trajectory.front().stamp) / work_s;
}

}  // namespace

TourWatch::TourWatch() {
  get_model_ = node_.serviceClient<GetModel>(kModelService);
  finished_topic_ = node_.subscribe<std_msgs::Bool>(
      "tour_finished", 2, [this](const auto& message) { finished_ = message->data; });
  corrected_topic_ = node_.subscribe<std_msgs::Bool>(
      "tour_corrected", 2, [this](const auto& message) { corrected_ = message->data; });
  correction_ = node_.subscribe("corrected_trajectory", 10, &TourWatch::on_correction, this);
  truth_planes_topic_ = node_.subscribe<PlaneArray>(
      "ground_truth/planes", 1, [this](const auto& message) { truth_planes_ = message; });
  truth_poses_ = node_.subscribe<nav_msgs::Odometry>(
      "base_pose_ground_truth", 10000, [this](const auto& message) {
        const auto pose = pose_of(message->pose.pose);
        if (pose) truth_.add({time_of(message->header.stamp), *pose});
      });
  trajectory_topic_ = node_.subscribe<nav_msgs::Path>(
      "modeler/trajectory", 1, [this](const auto& message) { trajectory_ = message; });
  trajectory_before_topic_ = node_.subscribe<nav_msgs::Path>(
      "modeler/trajectory_before", 1,
      [this](const auto& message) { trajectory_before_ = message; });
}

void TourWatch::on_correction(const nav_msgs::Path& path) {
  ++corrections_;
  if (!path.poses.empty()) corrected_until_ = path.poses.back();
}

void TourWatch::look() {
  GetModel request;
  request.request.which = GetModel::Request::CURRENT;
  request.request.as_built = true;
  if (!get_model_.call(request) || !request.response.success) return;
  const bool is_first_line = state_.lines == 0 && request.response.lines > 0;
  revision_is_new_ = request.response.planes.revision != state_.planes.revision;
  if (request.response.lines != state_.lines || revision_is_new_) {
    last_news_ = ros::WallTime::now();
    last_line_ = ros::Time::now();
  }
  if (is_first_line) {
    first_line_wall_ = last_news_;
    first_line_ = last_line_;
  }
  state_ = request.response;
}

double TourWatch::idle_s() const { return (ros::WallTime::now() - last_news_).toSec(); }

double TourWatch::speed() const {
  const double wall_s = (last_news_ - first_line_wall_).toSec();
  return wall_s > 0.0 ? (last_line_ - first_line_).toSec() / wall_s : 0.0;
}

std::string TourWatch::progress() const {
  if (state_.lines == 0) return "waiting for the first scan line";
  std::array<char, 160> text;
  std::snprintf(
      text.data(), text.size(),
      "%lu lines (%lu dropped), %lu ribbons, %zu planes; the tour runs at %.1f x real time",
      state_.lines, state_.dropped_lines, state_.ribbons, state_.planes.planes.size(), speed());
  return text.data();
}

// Messages of different topics arrive in any order, and the modeler may have left out corrections
// that were outdated when it came to them. Its trajectory tells which was the last one.
bool TourWatch::shows_latest_correction() const {
  constexpr double kSamePlace_m = 0.001;
  if (!trajectory_ || trajectory_->poses.empty()) return false;
  const geometry_msgs::PoseStamped& last = trajectory_->poses.back();
  if (corrected_until_.header.stamp < last.header.stamp) return false;
  const Eigen::Vector3d moved = position_of(last) - position_of(corrected_until_);
  return state_.planes.revision >= corrections_ ||
         (corrected_until_.header.stamp == last.header.stamp && moved.norm() < kSamePlace_m);
}

// True when the latest correction has been applied and no other is expected.
bool TourWatch::is_corrected() const {
  if (state_.planes.revision == 0 || revision_is_new_) return false;
  return (corrected_ && shows_latest_correction()) || idle_s() > kSettled_s;
}

std::string TourWatch::missing() const {
  if (state_.lines == 0)
    return "the modeler's first scan line (" + node_.resolveName(kModelService) + ")";
  if (!finished_) return "the end of the tour (" + finished_topic_.getTopic() + ")";
  if (!is_corrected()) return "the correction of the model (" + correction_.getTopic() + ")";
  if (!truth_planes_) return "the true planes (" + truth_planes_topic_.getTopic() + ")";
  if (truth_.empty()) return "the true poses (" + truth_poses_.getTopic() + ")";
  if (!trajectory_) return "the trajectory (" + trajectory_topic_.getTopic() + ")";
  if (!trajectory_before_) {
    return "the trajectory before the correction (" + trajectory_before_topic_.getTopic() + ")";
  }
  return "";
}

GetModel::Response TourWatch::model(bool before_correction, bool as_built, bool with_cells) {
  GetModel request;
  request.request.which =
      before_correction ? GetModel::Request::BEFORE_CORRECTION : GetModel::Request::CURRENT;
  request.request.as_built = as_built;
  request.request.cells = with_cells;
  if (!get_model_.call(request))
    throw std::runtime_error("no answer from " + get_model_.getService());
  if (!request.response.success) {
    throw std::runtime_error(get_model_.getService() + ": " + request.response.message);
  }
  return request.response;
}

Results TourWatch::results(const SurfaceConfig& surface) {
  const auto planes = [&](bool before_correction, bool as_built) {
    return planes_from(model(before_correction, as_built, true).planes);
  };
  const PlaneArray corrected = model(false, false, true).planes;
  Results results;
  results.surface = surface;
  results.models = {planes(true, true), planes(true, false), planes(false, true),
                    planes_from(corrected)};
  results.labels = labels_from(corrected);
  results.truth = patches_from(*truth_planes_);
  results.trajectory_before = poses_from(trajectory_before_);
  results.trajectory_after = poses_from(trajectory_);
  results.trajectory_truth = truth_.at_stamps_of(results.trajectory_before);
  results.rooms =
      rooms_of(results.models.corrected,
               semantics_of(results.models.corrected, positions_of(results.trajectory_after)),
               results.surface.stripe_gap_m);

  const GetModel::Response state = model(false, true, false);
  results.summary.lines = state.lines;
  results.summary.dropped_lines = state.dropped_lines;
  results.summary.ribbons = state.ribbons;
  results.summary.us_per_line = state.us_per_line;
  results.summary.correction_ms = state.correction_ms;
  results.summary.real_time_factor = modeler_speed(results.trajectory_before, state);
  return results;
}

}  // namespace ribbon_mapper::eval
