// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "modeler/ros/run/run_node.hpp"
#include "sim/ros/pacer.hpp"
#include "sim/ros/simulator_parameters.hpp"
#include "sim/ros/tour_publisher.hpp"

namespace ribbon_mapper::sim {
namespace {

/// Returns the first topic that lacks a subscriber; empty if there is none.
std::string topic_without_subscribers(const TourPublisher& publisher,
                                      const std::vector<std::string>& topics) {
  for (const std::string& topic : topics)
    if (!publisher.has_subscribers(topic)) return topic;
  return "";
}

/// Waits until all topics have their subscribers, because a line without a subscriber is lost;
/// starts without them after ~longest_wait.
void wait_for_subscribers(const TourPublisher& publisher, const SimulatorParameters& parameters) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(parameters.longest_wait_s);
  std::string missing;
  while (ros::ok()) {
    missing = topic_without_subscribers(publisher, parameters.wait_for);
    if (missing.empty() || ros::WallTime::now() > end) break;
    ros::WallDuration(0.05).sleep();
  }
  if (!missing.empty())
    ROS_WARN("%s lacks a subscriber after %g s (~longest_wait): starting without.", missing.c_str(),
             parameters.longest_wait_s);
}

void report_progress(const TourPublisher& publisher, const Tour& tour) {
  ROS_INFO("Tour: line %zu of %zu (%zu %%)", publisher.lines(), tour.line_count(),
           100 * publisher.lines() / std::max<std::size_t>(tour.line_count(), 1));
}

/// Reports whether tf has every position of the tilt.
void report_joints(const TourPublisher& publisher) {
  if (publisher.lost_joints() == 0) {
    ROS_INFO("Every joint state came back as tf.");
  } else {
    ROS_WARN("%zu joint states never came back as tf: does robot_state_publisher keep up?",
             publisher.lost_joints());
  }
}

/// Runs the simulation. Simulated time advances tick by tick; real time only decides when.
void run(TourPublisher& publisher, const Tour& tour, double rate) {
  Time now = TourPublisher::kFirstTick;
  // Before and after the tour at most at real time: other nodes need it to connect and to finish.
  for (Pacer pacer(std::min(rate, 1.0)); ros::ok() && now < TourPublisher::kStart;
       now += TourPublisher::kTick) {
    pacer.wait_until(now);
    publisher.tick(now);
  }
  Time next_report = now;
  for (Pacer pacer(rate); ros::ok() && !publisher.finished(now); now += TourPublisher::kTick) {
    pacer.wait_until(now);
    publisher.tick(now);
    if (const std::optional<double> reached = pacer.shortfall())
      ROS_WARN("This machine cannot hold rate %g: %.2f reached. No line is lost.", rate, *reached);
    if (now < next_report) continue;
    report_progress(publisher, tour);
    next_report = now + from_seconds(5.0 * rate);
  }
  bool is_over = false;
  const Time end = now + std::chrono::seconds(1);
  for (Pacer pacer(std::min(rate, 1.0)); ros::ok(); now += TourPublisher::kTick) {
    pacer.wait_until(now);
    publisher.tick(now);
    if (is_over || now < end) continue;
    report_progress(publisher, tour);
    report_joints(publisher);
    publisher.publish_truth();
    publisher.publish_finished(true);
    is_over = true;
  }
}

void simulate(const SimulatorParameters& parameters) {
  const World world =
      World::load(parameters.world, parameters.model_paths, parameters.caster, parameters.visuals);
  Tour tour(world, Route::load(parameters.route), parameters.tour);
  ROS_INFO("%s; %s", world.content().c_str(), tour.view().c_str());
  for (const std::string& warning : world.warnings())
    ROS_WARN("world %s: %s", parameters.world.c_str(), warning.c_str());
  ros::NodeHandle node;
  TourPublisher publisher(node, world, tour, parameters.frames, parameters.localisation);
  // Connections are made by callbacks; latched messages go out with them.
  ros::AsyncSpinner spinner(1);
  spinner.start();
  wait_for_subscribers(publisher, parameters);
  run(publisher, tour, parameters.rate);
}

}  // namespace
}  // namespace ribbon_mapper::sim

int main(int argc, char** argv) {
  const ribbon_mapper::NodeInfo info{"pr2_simulator", "drives a PR2 through a simulated world",
                                     "simulate.launch"};
  return ribbon_mapper::run_node(argc, argv, info, [] {
    ribbon_mapper::sim::simulate(ribbon_mapper::sim::SimulatorParameters::read());
    return 0;
  });
}
