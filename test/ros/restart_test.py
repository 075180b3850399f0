#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulated time stands still, or goes back because a bag starts again."""
import sys
import time
import unittest

import rospy
import rostest
from ribbon_mapper.srv import GetModel
from rosgraph_msgs.msg import Clock, Log

from robot_before_a_wall import Robot
from waiting import Latest, eventually


class Restart(unittest.TestCase):
    def setUp(self):
        rospy.wait_for_service('modeler/get_model', 20.0)
        self.get_model = rospy.ServiceProxy('modeler/get_model', GetModel)
        self.clock = rospy.Publisher('/clock', Clock, queue_size=10)
        self.log = Latest('/rosout', Log)
        self.robot = Robot()
        self.assertTrue(eventually(self.robot.connected))
        self.assertTrue(eventually(lambda: self.clock.get_num_connections() > 1))

    def model(self):
        return self.get_model(which=0, merged=True, cells=False)

    def tick(self):
        """It is the time of the next line."""
        self.clock.publish(Clock(self.robot.stamp(self.robot.line)))
        time.sleep(0.2)

    def play(self, lines):
        self.tick()
        self.robot.take(lines)
        self.tick()

    def test_a_bag_played_twice_is_modelled_twice(self):
        self.play(100)
        self.assertTrue(eventually(lambda: self.model().ribbons > 50))
        first = self.model()
        self.robot.line, self.robot.told = 0, -1
        self.play(100)
        self.assertTrue(any('went back' in entry.msg for entry in self.log.messages))
        self.assertTrue(eventually(lambda: self.model().ribbons == first.ribbons), self.model())
        second = self.model()
        self.assertEqual((second.lines, second.dropped_lines), (100, 0))
        self.assertEqual(len(second.planes.planes), len(first.planes.planes))
        self.wait_in_a_pause()

    def wait_in_a_pause(self):
        """Nothing is dropped while the clock stands still, however long its transform takes."""
        line = self.robot.line
        self.robot.scans.publish(self.robot.scan(line + 1))
        time.sleep(3.0)
        self.assertEqual(self.model().dropped_lines, 0)
        self.robot.publish_tf(line + 1)
        self.robot.publish_tf(line + 2)
        self.assertTrue(eventually(lambda: self.model().lines == 101))
        self.assertEqual(self.model().dropped_lines, 0)


if __name__ == '__main__':
    rospy.init_node('restart_test')
    rostest.rosrun('ribbon_mapper', 'restart', Restart, sys.argv)
