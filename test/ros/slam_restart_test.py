#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node slam starts again on request and when a bag loops, and survives bad input."""
import sys
import unittest

import rospy
import rostest
from nav_msgs.msg import Path
from rosgraph_msgs.msg import Clock, Log
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

from diagnostics import Diagnostics
from robot_before_a_wall import OdometryRobot
from waiting import Latest, close_and_get_path, eventually, service

LINES = 200  # 5 s, with a window


class SlamRestart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.log = Latest('/rosout', Log)
        cls.tf = Latest('/tf', TFMessage)
        cls.paths = Latest('corrected_trajectory', Path)
        cls.clock = rospy.Publisher('/clock', Clock, queue_size=10)
        cls.close = service('slam/close', Trigger)
        cls.reset = service('slam/reset', Trigger)
        cls.robot = OdometryRobot()
        assert eventually(lambda: cls.robot.connected(nodes=2))
        assert eventually(lambda: cls.tf.publishers() > 1 and cls.paths.publishers())

    def setUp(self):
        self.reset()
        self.robot.start_again()
        self.set_clock(0)
        self.diagnostics = Diagnostics('slam')

    def corrections(self):
        return [t for m in list(self.tf.messages) for t in m.transforms
                if t.header.frame_id == 'map']

    def set_clock(self, line):
        """Sets the time, and waits until slam has noticed."""
        stamp = self.robot.stamp(line)

        def is_shown():
            self.clock.publish(Clock(stamp))
            shown = self.corrections()
            return shown and abs((shown[-1].header.stamp - stamp).to_sec() - 0.1) < 1e-6
        self.assertTrue(eventually(is_shown))

    def play(self):
        first = self.robot.line
        self.robot.take(LINES)
        self.set_clock(self.robot.line)
        self.diagnostics.wait_until_handled(LINES)
        return first

    def close_and_get(self):
        answer, path = close_and_get_path(self.close, self.paths)
        self.assertTrue(answer.success, answer.message)
        return path.poses

    def test_close_without_lines(self):
        answer = self.close()
        self.assertFalse(answer.success)
        self.assertIn('no pose yet', answer.message)

    def test_a_reset_forgets_the_lines(self):
        self.play()
        self.assertGreater(len(self.close_and_get()), LINES // 2)
        self.assertTrue(self.reset().success)
        self.assertTrue(eventually(lambda: self.diagnostics.value('poses') == '0'))
        self.assertFalse(self.close().success)
        first = self.play()
        poses = self.close_and_get()
        self.assertGreater(len(poses), LINES // 2)
        self.assertGreaterEqual(poses[0].header.stamp, self.robot.stamp(first))

    def test_a_loop_of_the_bag_starts_again(self):
        self.play()
        count = len(self.close_and_get())
        self.robot.start_again()
        self.set_clock(0)
        self.assertTrue(eventually(lambda: any(
            'went back: the estimate starts again' in entry.msg for entry in self.log.messages)))
        self.play()
        self.assertEqual(len(self.close_and_get()), count)

    def test_bad_scans_are_dropped(self):
        self.play()
        good = len(self.close_and_get())
        for spoil in (lambda scan: setattr(scan, 'ranges', []),
                      lambda scan: setattr(scan, 'angle_increment', float('nan')),
                      lambda scan: setattr(scan.header, 'frame_id', ''),
                      lambda scan: setattr(scan.header, 'stamp', rospy.Time(0)),
                      lambda scan: setattr(scan.header, 'stamp', self.robot.stamp(LINES - 20))):
            scan = self.robot.scan(self.robot.line)
            spoil(scan)
            self.robot.send(scan)
        self.assertTrue(eventually(lambda: self.diagnostics.value('lines dropped') == '5'),
                        self.diagnostics.reports()[-1:])
        self.assertEqual(len(self.close_and_get()), good)


if __name__ == '__main__':
    rospy.init_node('slam_restart_test')
    rostest.rosrun('ribbon_mapper', 'slam_restart', SlamRestart, sys.argv)
