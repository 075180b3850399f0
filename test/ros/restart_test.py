#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulated time stands still, or goes back because a bag starts again."""
import os
import sys
import unittest

import rospkg
import rospy
import rostest
from ribbon_mapper.srv import GetModel

from diagnostics import Diagnostics
from program import Program
from robot_before_a_wall import Robot
from waiting import SimulatedClock, eventually, service

CONFIG = os.path.join(rospkg.RosPack().get_path('ribbon_mapper'), 'config/pr2.yaml')
LINES = 100


class Modeler:
    """A modeler node with its service."""

    def __init__(self, name):
        self.name = name
        self.program = Program('modeler', name, 'scan:=tilt_scan', '_config:=' + CONFIG)
        self.get_model = service(name + '/get_model', GetModel)

    def model(self):
        return self.get_model(which=0, as_built=False, cells=False)

    def planes(self):
        return self.model().planes.planes


class Restart(unittest.TestCase):
    starts = 0

    def setUp(self):
        self.clock = SimulatedClock()
        self.robot = Robot()
        self.modelers = []
        self.old = self.start()
        self.play(self.take_lines)
        self.assertTrue(eventually(lambda: self.old.model().ribbons > 50), self.old.model())
        Diagnostics(self.old.name).wait_until_handled(LINES)
        self.first = self.old.model()

    def tearDown(self):
        for modeler in self.modelers:
            self.assertNotIn('TF_', modeler.program.stop())

    def start(self):
        """Starts a modeler under a name that no node had before."""
        Restart.starts += 1
        self.modelers.append(Modeler('modeler_%d' % Restart.starts))
        self.assertTrue(eventually(lambda: self.robot.reaches(self.modelers[-1].name)))
        return self.modelers[-1]

    def set_clock(self, line):
        self.clock.set(self.robot.stamp(line), *[modeler.get_model for modeler in self.modelers])

    def play(self, publish):
        """Publishes a run; its clock moves only at the begin and at the end."""
        self.robot.start_again()
        self.set_clock(0)
        publish()
        for modeler in self.modelers:
            self.assertTrue(eventually(lambda: modeler.model().lines == LINES), modeler.model())
        self.set_clock(LINES)

    def take_lines(self):
        self.robot.take(LINES)

    def scans_before_transforms(self):
        """Publishes transforms when every scan has arrived: until then only the old ones are there."""
        for line in range(LINES):
            self.robot.publish_scan(self.robot.scan(line))
        for modeler in self.modelers:
            self.assertTrue(eventually(lambda: modeler.model().lines == LINES), modeler.model())
        for line in range(LINES + 1):
            self.robot.publish_tf(line)
        self.robot.line = LINES

    def assert_like_the_first(self, modeler, shift):
        """The model is that of the first run, as far away as the robot has moved."""
        same = eventually(lambda: modeler.model().ribbons == self.first.ribbons)
        self.assertTrue(same, modeler.model())
        second = modeler.model()
        self.assertEqual((second.lines, second.dropped_lines), (LINES, 0))
        self.assertEqual(len(second.planes.planes), 1)
        self.assertAlmostEqual(second.planes.planes[0].centroid.x, 3.0 + shift, delta=0.01)

    def test_the_second_run_gives_the_model_of_a_fresh_node(self):
        self.robot.x = 1.0
        self.set_clock(0)
        fresh = self.start()
        self.play(self.scans_before_transforms)
        for modeler in (self.old, fresh):
            self.assert_like_the_first(modeler, shift=1.0)
        self.assertEqual(self.old.planes(), fresh.planes())

    def test_messages_may_overtake_the_clock(self):
        for repetition in range(1, 6):
            self.robot.x = 1.0 * repetition
            self.robot.start_again()
            self.robot.take(LINES)
            self.set_clock(0)
            self.assert_like_the_first(self.old, shift=self.robot.x)
            self.set_clock(LINES)

    def test_nothing_is_dropped_while_the_clock_stands_still(self):
        diagnostics = Diagnostics(self.old.name)
        line = self.robot.line
        self.robot.publish_scan(self.robot.scan(line + 1))

        def reports_of_waiting():
            return sum(report.get('lines waiting for tf') == '1'
                       for report in diagnostics.reports())
        # One report a second: more than the timeout of a transform.
        self.assertTrue(eventually(lambda: reports_of_waiting() >= 5))
        self.assertEqual(self.old.model().dropped_lines, 0)
        self.robot.publish_tf(line + 1)
        self.robot.publish_tf(line + 2)
        self.assertTrue(eventually(lambda: reports_of_waiting() and
                                   self.old.model().ribbons > self.first.ribbons))
        self.assertEqual((self.old.model().lines, self.old.model().dropped_lines), (LINES + 1, 0))


if __name__ == '__main__':
    rospy.init_node('restart_test')
    rostest.rosrun('ribbon_mapper', 'restart', Restart, sys.argv)
