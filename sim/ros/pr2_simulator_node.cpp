// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "sim/ros/pacer.hpp"
#include "sim/ros/simulator_parameters.hpp"
#include "sim/ros/tour_publisher.hpp"

namespace ribbon_mapper::sim {
namespace {

std::string topic_without_subscriber(const TourPublisher& publisher,
                                     const std::vector<std::string>& topics) {
  for (const std::string& topic : topics)
    if (!publisher.has_subscriber(topic)) return topic;
  return "";
}

/// A line that nobody hears is lost. Waits until all listen; after a while, starts all the same.
void wait_for_listeners(const TourPublisher& publisher, const SimulatorParameters& parameters) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(parameters.longest_wait_s);
  std::string missing;
  while (ros::ok()) {
    missing = topic_without_subscriber(publisher, parameters.wait_for);
    if (missing.empty() || ros::WallTime::now() > end) break;
    ros::WallDuration(0.05).sleep();
  }
  if (!missing.empty())
    ROS_WARN("Nobody listens to %s after %g s (~longest_wait): starting without.", missing.c_str(),
             parameters.longest_wait_s);
}

void say_how_far(const TourPublisher& publisher, const Tour& tour) {
  ROS_INFO("Tour: line %zu of %zu (%zu %%)", publisher.lines(), tour.line_count(),
           100 * publisher.lines() / std::max<std::size_t>(tour.line_count(), 1));
}

/// One loop: simulated time goes on tick by tick, real time only tells when.
void run(TourPublisher& publisher, const Tour& tour, double rate) {
  Time now = TourPublisher::kFirstTick;
  // Before the tour and after it at most at real time: others need it to connect and to finish.
  for (Pacer pacer(std::min(rate, 1.0)); ros::ok() && now < TourPublisher::kStart;
       now += TourPublisher::kTick) {
    pacer.wait_until(now);
    publisher.tick(now);
  }
  Time next_word = now;
  for (Pacer pacer(rate); ros::ok() && !publisher.finished(now); now += TourPublisher::kTick) {
    pacer.wait_until(now);
    publisher.tick(now);
    if (const std::optional<double> reached = pacer.shortfall())
      ROS_WARN("This machine cannot hold rate %g: %.2f reached. No line is lost.", rate, *reached);
    if (now < next_word) continue;
    say_how_far(publisher, tour);
    next_word = now + from_seconds(5.0 * rate);
  }
  bool said = false;
  const Time end = now + std::chrono::seconds(1);
  for (Pacer pacer(std::min(rate, 1.0)); ros::ok(); now += TourPublisher::kTick) {
    pacer.wait_until(now);
    publisher.tick(now);
    if (said || now < end) continue;
    say_how_far(publisher, tour);
    publisher.publish_truth();
    publisher.publish_finished(true);
    said = true;
    if (publisher.lost_joints() > 0)
      ROS_WARN("%zu joint states never came back as tf: does robot_state_publisher keep up?",
               publisher.lost_joints());
  }
}

}  // namespace
}  // namespace ribbon_mapper::sim

int main(int argc, char** argv) {
  using namespace ribbon_mapper::sim;
  ros::init(argc, argv, "pr2_simulator");
  ros::NodeHandle node;  // out here: logging ends with the last one
  try {
    const SimulatorParameters parameters = SimulatorParameters::read();
    const World world = World::load(parameters.world, parameters.model_paths, parameters.caster);
    Tour tour(world, Route::load(parameters.route), parameters.tour);
    TourPublisher publisher(node, world, tour, parameters.frames);
    // Connections are made by callbacks; latched messages go out with them.
    ros::AsyncSpinner spinner(1);
    spinner.start();
    wait_for_listeners(publisher, parameters);
    run(publisher, tour, parameters.rate);
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
