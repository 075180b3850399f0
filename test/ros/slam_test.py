#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""slam_adapter publishes the corrected trajectory of SLAMs whose messages are not installed.

The messages are made from their definitions; genpy computes their checksums.
"""
import sys
import unittest

import genpy.dynamic
import rospy
import rostest
from geometry_msgs.msg import PoseStamped, TransformStamped
from nav_msgs.msg import Path
from tf2_msgs.msg import TFMessage

from waiting import Latest, eventually

SEPARATOR = '\n' + '=' * 80 + '\n'
HEADER = SEPARATOR + 'MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n'
POSE = (SEPARATOR + 'MSG: geometry_msgs/Pose\nPoint position\nQuaternion orientation\n' +
        SEPARATOR + 'MSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n' +
        SEPARATOR + 'MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n')
STATUS = SEPARATOR + 'MSG: cartographer_ros_msgs/StatusResponse\nuint8 code\nstring message\n'
STAMPED = SEPARATOR + 'MSG: geometry_msgs/PoseStamped\nHeader header\nPose pose\n'
NODE = SEPARATOR + 'MSG: rtabmap_msgs/Node\nint32 id\nfloat64 stamp\nstring label\nuint8[] image\n'
GRAPH = SEPARATOR + 'MSG: rtabmap_msgs/MapGraph\nHeader header\nint32[] posesId\ngeometry_msgs/Pose[] poses\n'


def message_class(name, text):
    return genpy.dynamic.generate_dynamic(name, text)[name]


class TrajectoryQuery:
    """Stands in for the generated class of cartographer_ros_msgs/TrajectoryQuery."""
    _type = 'cartographer_ros_msgs/TrajectoryQuery'
    _md5sum = '0123456789abcdef0123456789abcdef'
    _request_class = message_class('cartographer_ros_msgs/TrajectoryQueryRequest',
                                   'int32 trajectory_id\n')
    _response_class = message_class(
        'cartographer_ros_msgs/TrajectoryQueryResponse',
        'StatusResponse status\ngeometry_msgs/PoseStamped[] trajectory\n' + STATUS + STAMPED + HEADER +
        POSE)


def pose_stamped(seconds, x):
    pose = PoseStamped()
    pose.header.frame_id, pose.header.stamp = 'map', rospy.Time.from_sec(seconds)
    pose.pose.position.x, pose.pose.orientation.w = x, 1.0
    return pose


class Slam(unittest.TestCase):
    def expect(self, latest, expected):
        def found():
            return [(round(pose.header.stamp.to_sec(), 3), round(pose.pose.position.x, 6))
                    for path in latest.messages[-1:] for pose in path.poses]
        self.assertTrue(eventually(lambda: found() == expected), found())

    def test_cartographer(self):
        paths = Latest('cartographer_trajectory', Path)
        answer = TrajectoryQuery._response_class()
        answer.trajectory = [pose_stamped(10.0, 1.0), pose_stamped(11.0, 2.0)]
        service = rospy.Service('trajectory_query', TrajectoryQuery, lambda request: answer)
        self.expect(paths, [(10.0, 1.0), (11.0, 2.0)])
        answer.trajectory[1].pose.position.x = 2.5  # a loop was closed
        self.expect(paths, [(10.0, 1.0), (11.0, 2.5)])
        service.shutdown()

    def test_rtabmap(self):
        paths = Latest('rtabmap_trajectory', Path)
        kind = message_class('rtabmap_msgs/MapData',
                             'Header header\nMapGraph graph\nNode[] nodes\n' + HEADER + GRAPH + NODE +
                             POSE)
        data = rospy.Publisher('mapData', kind, queue_size=10)
        self.assertTrue(eventually(lambda: data.get_num_connections() > 0))
        message, node = kind(), genpy.dynamic.generate_dynamic(
            'rtabmap_msgs/Node', NODE.split('\n', 3)[3])['rtabmap_msgs/Node']
        for number, (stamp, x) in enumerate([(20.0, 1.0), (21.0, 2.0)]):
            message.graph.posesId.append(number + 1)
            message.graph.poses.append(pose_stamped(0.0, x).pose)
            message.nodes = [node(number + 1, stamp, 'kitchen', b'image')]
            data.publish(message)
        self.expect(paths, [(20.0, 1.0), (21.0, 2.0)])

    def test_tf(self):
        paths = Latest('tf_trajectory', Path)
        tf = rospy.Publisher('/tf', TFMessage, queue_size=100)
        self.assertTrue(eventually(lambda: tf.get_num_connections() > 0))

        def send(parent, child, seconds, x):
            message = TransformStamped()
            message.header.stamp = rospy.Time.from_sec(seconds)
            message.header.frame_id, message.child_frame_id = parent, child
            message.transform.translation.x, message.transform.rotation.w = x, 1.0
            tf.publish(TFMessage([message]))

        for tick in range(10):
            send('odom_combined', 'base_footprint', 30.0 + tick, float(tick))
            send('map', 'odom_combined', 30.0 + tick, 0.5 if tick >= 6 else 0.0)
        self.expect(paths, [(30.0, 0.0), (36.0, 6.5)])


if __name__ == '__main__':
    rospy.init_node('slam_test')
    rostest.rosrun('ribbon_mapper', 'slam', Slam, sys.argv)
