# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot that stands 3 m before a wall and tilts its laser; stamps are explicit, no clock runs."""
import math

import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

BEAMS = 101
HALF_ANGLE = 0.5
PERIOD = 0.025


class Robot:
    def __init__(self):
        self.tf = rospy.Publisher('/tf', TFMessage, queue_size=1000)
        self.scans = rospy.Publisher('tilt_scan', LaserScan, queue_size=1000)
        self.line = 0
        self.told = -1  # tf was published up to this line

    def connected(self):
        return self.tf.get_num_connections() > 0 and self.scans.get_num_connections() > 0

    @staticmethod
    def stamp(line):
        return rospy.Time.from_sec(1000.0 + PERIOD * line)

    @staticmethod
    def tilt(line):
        """Up and down between -0.3 and 0.3 rad in 80 lines."""
        return 0.3 - 0.015 * abs(line % 80 - 40)

    def scan(self, line):
        message = LaserScan()
        message.header.stamp = self.stamp(line)
        message.header.frame_id = 'laser_tilt_link'
        message.angle_min, message.angle_max = -HALF_ANGLE, HALF_ANGLE
        message.angle_increment = 2.0 * HALF_ANGLE / (BEAMS - 1)
        message.time_increment = PERIOD / 1440.0
        message.range_min, message.range_max = 0.1, 30.0
        message.ranges = [3.0 / (math.cos(self.tilt(line)) * math.cos(angle)) for angle in (
            -HALF_ANGLE + i * message.angle_increment for i in range(BEAMS))]
        return message

    def publish_tf(self, line):
        if line <= self.told:
            return
        self.told = line
        turn = 0.5 * self.tilt(line)
        self.tf.publish(TFMessage([
            self.transform('map', 'odom_combined', line),
            self.transform('odom_combined', 'base_footprint', line),
            self.transform('base_footprint', 'laser_tilt_link', line, 1.0, turn)]))

    def transform(self, parent, child, line, height=0.0, half_turn=0.0):
        message = TransformStamped()
        message.header.stamp = self.stamp(line)
        message.header.frame_id, message.child_frame_id = parent, child
        message.transform.translation.z = height
        message.transform.rotation.y = math.sin(half_turn)
        message.transform.rotation.w = math.cos(half_turn)
        return message

    def take(self, count):
        """So many good lines, with their transforms."""
        for _ in range(count):
            self.send(self.scan(self.line))

    def send(self, scan):
        """Any scan, with the transforms of the next line."""
        self.publish_tf(self.line)
        self.publish_tf(self.line + 1)
        self.scans.publish(scan)
        self.line += 1
