# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot that stands 3 m before a wall and tilts its laser. Its stamps do not follow any clock."""
import math

import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

from waiting import reaches

BEAMS = 101
HALF_ANGLE = 0.5
PERIOD = 0.025


class Robot:
    def __init__(self):
        self.tf = rospy.Publisher('/tf', TFMessage, queue_size=1000)
        self.scans = rospy.Publisher('tilt_scan', LaserScan, queue_size=1000)
        self.x = 0.0  # of the robot in map, so that the wall is at x + 3
        self.sent = 0  # scans since a test has set it to zero
        self.start_again()

    def start_again(self):
        """Goes back to the first line."""
        self.line = 0
        self._newest_tf = -1

    def connected(self, nodes=1):
        """Returns whether so many nodes receive transforms and scans."""
        return all(publisher.get_num_connections() >= nodes for publisher in (self.tf, self.scans))

    def reaches(self, node):
        """Returns whether a node receives transforms and scans, by its name in the graph."""
        return all(reaches(publisher, node) for publisher in (self.tf, self.scans))

    @staticmethod
    def stamp(line):
        return rospy.Time.from_sec(1000.0 + PERIOD * line)

    @staticmethod
    def tilt(line):
        """Returns the tilt, which goes up and down between -0.3 and 0.3 rad in 80 lines."""
        return 0.3 - 0.015 * abs(line % 80 - 40)

    def scan(self, line):
        message = LaserScan()
        message.header.stamp = self.stamp(line)
        message.header.frame_id = 'laser_tilt_link'
        message.angle_min, message.angle_max = -HALF_ANGLE, HALF_ANGLE
        message.angle_increment = 2.0 * HALF_ANGLE / (BEAMS - 1)
        message.time_increment = PERIOD * message.angle_increment / (2.0 * math.pi)
        message.range_min, message.range_max = 0.1, 30.0
        message.ranges = [3.0 / (math.cos(self.tilt(line)) * math.cos(angle)) for angle in (
            -HALF_ANGLE + i * message.angle_increment for i in range(BEAMS))]
        return message

    def publish_scan(self, scan):
        self.scans.publish(scan)
        self.sent += 1

    def publish_tf(self, line):
        """Publishes the transforms at a line, unless that was done already."""
        if line <= self._newest_tf:
            return
        self._newest_tf = line
        self.tf.publish(TFMessage([
            self.transform('map', 'odom_combined', line, x=self.x),
            self.transform('odom_combined', 'base_footprint', line),
            self.transform('base_footprint', 'laser_tilt_link', line, height=1.0,
                           tilt=self.tilt(line))]))

    def transform(self, parent, child, line, x=0.0, height=0.0, tilt=0.0):
        message = TransformStamped()
        message.header.stamp = self.stamp(line)
        message.header.frame_id, message.child_frame_id = parent, child
        message.transform.translation.x = x
        message.transform.translation.z = height
        message.transform.rotation.y = math.sin(0.5 * tilt)
        message.transform.rotation.w = math.cos(0.5 * tilt)
        return message

    def take(self, count):
        """Publishes so many good lines with their transforms."""
        for _ in range(count):
            self.send(self.scan(self.line))

    def send(self, scan):
        """Publishes any scan with the transforms of the next line."""
        self.publish_tf(self.line)
        self.publish_tf(self.line + 1)
        self.publish_scan(scan)
        self.line += 1


class OdometryRobot(Robot):
    """Without localisation: slam is the one who publishes map -> odom."""

    def publish_tf(self, line):
        if line <= self._newest_tf:
            return
        self._newest_tf = line
        self.tf.publish(TFMessage([
            self.transform('odom_combined', 'base_footprint', line),
            self.transform('base_footprint', 'laser_tilt_link', line, height=1.0,
                           tilt=self.tilt(line))]))
