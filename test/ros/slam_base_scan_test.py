#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node slam with a level laser: it goes on when that laser stops, and loses no line."""
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticStatus
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

from diagnostics import Diagnostics
from robot_before_a_wall import OdometryRobot
from waiting import eventually, service

LINES = 120  # 3 s, with a window
LEVEL_LINE = 20  # the tilt is 0


class SlamBaseScan(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock = rospy.Publisher('/clock', Clock, queue_size=10, latch=True)
        cls.base_scans = rospy.Publisher('base_scan', LaserScan, queue_size=1000)
        cls.close = service('slam/close', Trigger)
        cls.robot = RobotWithBaseLaser()
        cls.diagnostics = Diagnostics('slam')
        assert eventually(lambda: cls.robot.connected(nodes=2))
        assert eventually(cls.base_scans.get_num_connections)
        cls.clock.publish(Clock(cls.robot.stamp(0)))
        cls.lines = 0

    def play(self, with_base_laser):
        for _ in range(LINES):
            if with_base_laser:
                self.base_scans.publish(self.robot.base_scan(self.robot.line))
            self.robot.take(1)
        self.__class__.lines += LINES
        self.clock.publish(Clock(self.robot.stamp(self.robot.line)))
        self.diagnostics.wait_until_handled(self.lines)
        self.assertTrue(eventually(self.all_have_poses), self.diagnostics.reports()[-1:])
        self.assertEqual(self.diagnostics.value('lines dropped'), '0')

    def all_have_poses(self):
        """Three lines make a ribbon: the last ones wait for others."""
        poses = self.diagnostics.value('poses')
        return poses is not None and int(poses) >= self.lines - 3

    def state(self):
        return self.diagnostics.status('base laser')

    def test_it_goes_on_without_the_laser_and_with_it_again(self):
        self.play(True)
        self.assertTrue(eventually(lambda: self.state().message == 'refines the odometry'))
        self.assertGreater(int(self.diagnostics.value('scans matched')), 1)
        self.play(False)
        self.assertTrue(eventually(lambda: self.state().message ==
                                   'silent: the recorded odometry is used'))
        self.assertEqual(self.state().level, DiagnosticStatus.WARN)
        self.play(True)
        self.assertTrue(eventually(lambda: self.state().message == 'refines the odometry'))
        self.assertEqual(self.state().level, DiagnosticStatus.OK)
        answer = self.close()
        self.assertTrue(answer.success, answer.message)


class RobotWithBaseLaser(OdometryRobot):
    """With a level laser 0.3 m above the floor."""

    def publish_tf(self, line):
        is_new = line > self._newest_tf
        super().publish_tf(line)
        if is_new:
            self.tf.publish(TFMessage([
                self.transform('base_footprint', 'base_laser_link', line, height=0.3)]))

    def base_scan(self, line):
        """Returns a scan that is a little later than a line, which waits for it."""
        scan = self.scan(LEVEL_LINE)
        scan.header.frame_id = 'base_laser_link'
        scan.header.stamp = self.stamp(line + 0.1)
        return scan


if __name__ == '__main__':
    rospy.init_node('slam_base_scan_test')
    rostest.rosrun('ribbon_mapper', 'slam_base_scan', SlamBaseScan, sys.argv)
