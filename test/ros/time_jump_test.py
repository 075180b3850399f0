#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The modeler says what it waits for; with on_time_jump stop, a looping bag is modelled once."""
import sys
import unittest

import rospy
import rostest
from ribbon_mapper.msg import PlaneArray
from ribbon_mapper.srv import GetModel
from rosgraph_msgs.msg import Log
from std_srvs.srv import Trigger

from diagnostics import Diagnostics
from robot_before_a_wall import Robot
from waiting import Latest, SimulatedClock, eventually, service


class TimeJump(unittest.TestCase):
    def setUp(self):
        self.log = Latest('/rosout', Log)
        self.get_model = service('modeler/get_model', GetModel)
        self.reset = service('modeler/reset', Trigger)
        self.clock = SimulatedClock()
        self.robot = Robot()
        self.assertTrue(eventually(self.robot.connected))

    def model(self):
        return self.get_model(which=0, as_built=False, cells=False)

    def said(self, *words):
        return eventually(lambda: any(all(word in entry.msg for word in words)
                                      for entry in self.log.messages))

    def play(self):
        self.clock.set(self.robot.stamp(self.robot.line), self.get_model)
        self.robot.take(100)

    def test_a_loop_is_modelled_once(self):
        self.assertTrue(self.said('Waiting for scans on /tilt_scan', 'there is no /clock'))
        self.play()
        Diagnostics().wait_until_handled(100)
        before = self.model().ribbons
        self.assertGreater(before, 50)
        self.clock.set(self.robot.stamp(100), self.get_model)
        self.robot.start_again()
        self.play()
        self.assertTrue(self.said('went back', 'takes no lines until ~reset'))
        self.assertTrue(eventually(lambda: self.model().dropped_lines == 100), self.model())
        self.assertEqual(self.model().ribbons, before)
        self.assertTrue(self.reset().success)
        self.assertEqual(self.model().ribbons, 0)
        self.play()
        self.assertTrue(eventually(lambda: self.model().ribbons > 50), self.model())


    def test_the_end_of_time_does_not_end_the_node(self):
        end = rospy.Time(0xffffffff, 999999999)
        self.clock.set(end, self.get_model)
        planes = Latest('modeler/planes', PlaneArray)  # published by the next report
        self.assertTrue(eventually(lambda: planes.messages and planes.newest().header.stamp == end))
        self.clock.set(self.robot.stamp(0), self.get_model)
        diagnostics = Diagnostics()
        self.assertTrue(eventually(lambda: diagnostics.value('lines in')))


if __name__ == '__main__':
    rospy.init_node('time_jump_test')
    rostest.rosrun('ribbon_mapper', 'time_jump', TimeJump, sys.argv)
