// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <set>
#include <string>

#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/transform_entry.hpp"
#include "modeler/ros/node/strict_parameters.hpp"
#include "modeler/ros/run/run_node.hpp"

namespace ribbon_mapper {
namespace {

/// Forwards the transforms of a bag from `tf_recorded` to `/tf` without leading slashes. Leaves out
/// those that a localisation provides during the replay. Keeps nothing, so a time jump does not
/// matter to it.
class TfFilterNode {
 public:
  explicit TfFilterNode(std::set<std::string> drop_frames) : drop_frames_(std::move(drop_frames)) {
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 10000);
    recorded_ = node_.subscribe("tf_recorded", 10000, &TfFilterNode::on_tf, this,
                                ros::TransportHints().tcpNoDelay());
  }

 private:
  void on_tf(const tf2_msgs::TFMessage& message) {
    tf2_msgs::TFMessage kept;
    for (geometry_msgs::TransformStamped transform : message.transforms) {
      transform.header.frame_id = without_slash(transform.header.frame_id);
      transform.child_frame_id = without_slash(transform.child_frame_id);
      if (drop_frames_.count(transform.header.frame_id) == 0) kept.transforms.push_back(transform);
    }
    if (!kept.transforms.empty()) tf_.publish(kept);
  }

  std::set<std::string> drop_frames_;
  ros::NodeHandle node_;
  ros::Publisher tf_;
  ros::Subscriber recorded_;
};

}  // namespace
}  // namespace ribbon_mapper

int main(int argc, char** argv) {
  const ribbon_mapper::NodeInfo info{
      "tf_filter", "forwards the transforms of a bag, without those of some frames",
      "pr2_replay.launch"};
  return ribbon_mapper::run_node(argc, argv, info, [] {
    ribbon_mapper::StrictParameters from;
    const auto drop_frames = ribbon_mapper::frames_from(from.text("drop_frames", ""));
    from.refuse_unknown();
    const ribbon_mapper::TfFilterNode node(drop_frames);
    ros::spin();
    return 0;
  });
}
