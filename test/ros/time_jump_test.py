#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The modeler says what it waits for; with on_time_jump stop, a bag that loops is modelled once."""
import sys
import time
import unittest

import rospy
import rostest
from ribbon_mapper.srv import GetModel
from rosgraph_msgs.msg import Clock, Log
from std_srvs.srv import Trigger

from robot_before_a_wall import Robot
from waiting import Latest, eventually


class TimeJump(unittest.TestCase):
    def setUp(self):
        rospy.wait_for_service('modeler/get_model', 20.0)
        self.get_model = rospy.ServiceProxy('modeler/get_model', GetModel)
        self.reset = rospy.ServiceProxy('modeler/reset', Trigger)
        self.clock = rospy.Publisher('/clock', Clock, queue_size=10)
        self.log = Latest('/rosout', Log)
        self.robot = Robot()
        self.assertTrue(eventually(self.robot.connected))

    def ribbons(self):
        return self.get_model(which=0, merged=True, cells=False).ribbons

    def said(self, *words):
        return eventually(lambda: any(all(word in entry.msg for word in words)
                                      for entry in self.log.messages))

    def play(self, lines):
        self.clock.publish(Clock(self.robot.stamp(self.robot.line)))
        time.sleep(0.2)
        self.robot.take(lines)
        self.clock.publish(Clock(self.robot.stamp(self.robot.line)))
        time.sleep(0.2)

    def test_a_loop_is_modelled_once(self):
        self.assertTrue(self.said('Waiting for scans on /tilt_scan', 'there is no /clock'))
        self.play(100)
        self.assertTrue(eventually(lambda: self.ribbons() > 50))
        before = self.ribbons()
        self.robot.line, self.robot.told = 0, -1
        self.play(100)
        self.assertTrue(self.said('went back', 'takes no lines until ~reset'))
        time.sleep(0.5)
        self.assertEqual(self.ribbons(), before)
        self.assertTrue(self.reset().success)
        self.play(100)
        self.assertTrue(eventually(lambda: self.ribbons() > 50))


if __name__ == '__main__':
    rospy.init_node('time_jump_test')
    rostest.rosrun('ribbon_mapper', 'time_jump', TimeJump, sys.argv)
