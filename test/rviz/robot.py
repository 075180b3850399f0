# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A PR2 that stands in the middle of a room, whose planes are received as markers."""
import collections
import threading

import roslib.packages
import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import JointState, LaserScan
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from waiting import eventually

RATE_HZ = 10.0
FRAMES = [('map', 'odom_combined'), ('odom_combined', 'base_footprint')]


class Robot:
    """Publishes transforms, joints and scans until the process ends."""

    def __init__(self, description, scan_topics):
        rospy.init_node('robot', disable_signals=True)
        rospy.set_param('/robot_description', description)
        self._tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        self._joints = rospy.Publisher('/joint_states', JointState, queue_size=10)
        self._scans = [rospy.Publisher(topic, LaserScan, queue_size=10) for topic in scan_topics]
        self._markers = collections.defaultdict(dict)  # by the namespace of the modeler and the id
        self._subscribers = {}
        threading.Thread(target=self._run, daemon=True).start()

    @staticmethod
    def state_publisher():
        """Returns the command that makes transforms of the joints."""
        return [roslib.packages.find_node('robot_state_publisher', 'robot_state_publisher')[0]]

    def _run(self):
        while not rospy.is_shutdown():
            stamp = rospy.Time.now()
            self._tf.publish(TFMessage([transform(stamp, *frames) for frames in FRAMES]))
            joints = JointState(name=['torso_lift_joint', 'laser_tilt_mount_joint'],
                                position=[0.0115, 0.0])
            joints.header.stamp = stamp
            self._joints.publish(joints)
            for publisher in self._scans:
                publisher.publish(scan(stamp))
            rospy.sleep(1.0 / RATE_HZ)

    def colours(self, namespace):
        """Returns the colours of the planes of a modeler, each as red, green and blue to 255."""
        if namespace not in self._subscribers:
            self._subscribers[namespace] = rospy.Subscriber(
                namespace.rstrip('/') + '/modeler/markers', MarkerArray,
                lambda array: self._take(namespace, array))
        assert eventually(lambda: len(self._markers[namespace]) >= 3), 'the modeler is silent'
        return [tuple(round(255 * value) for value in (colour.r, colour.g, colour.b))
                for colour in list(self._markers[namespace].values())]

    def _take(self, namespace, array):
        for marker in array.markers:
            if marker.ns == 'planes' and marker.action == Marker.ADD:
                self._markers[namespace][marker.id] = marker.colors[0]


def transform(stamp, parent, child):
    message = TransformStamped(child_frame_id=child)
    message.header.stamp = stamp
    message.header.frame_id = parent
    message.transform.rotation.w = 1.0
    return message


def scan(stamp):
    """Returns a scan of something round, 1.5 m away."""
    message = LaserScan(angle_min=-1.0, angle_max=1.0, angle_increment=0.02, range_min=0.1,
                        range_max=30.0, ranges=[1.5] * 101)
    message.header.stamp = stamp
    message.header.frame_id = 'laser_tilt_link'
    return message
