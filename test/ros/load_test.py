#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A modeler goes on from what it has saved: when asked to, and after it was killed."""
import os
import struct
import sys
import tempfile
import unittest

import rospkg
import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from ribbon_mapper.srv import GetModel, Load, Save
from std_srvs.srv import Trigger

from program import Program
from robot_before_a_wall import Robot
from waiting import eventually, reaches, service

CONFIG = os.path.join(rospkg.RosPack().get_path('ribbon_mapper'), 'config/pr2.yaml')
LINES = 100


def lines_in(file):
    """Returns the number of lines of a model file, or None if it is not there."""
    if not os.path.exists(file):
        return None
    with open(file, 'rb') as opened:
        head = opened.read(200)
    length = struct.unpack_from('<H', head, 44)[0]  # of the frame, in the first section
    return struct.unpack_from('<Q', head, 46 + length)[0]


class LoadTest(unittest.TestCase):
    starts = 0

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.robot = Robot()
        self.corrected = rospy.Publisher('corrected_trajectory', Path, queue_size=10)
        self.nodes = []

    def tearDown(self):
        for node in self.nodes:
            node.kill()
        self.folder.cleanup()

    def start(self, *arguments):
        """Starts a modeler under a name of its own, because parameters outlive their node."""
        LoadTest.starts += 1
        self.name = name = 'modeler_%d' % LoadTest.starts
        self.nodes.append(Program('modeler', name, 'scan:=tilt_scan', '_config:=' + CONFIG,
                                  '_output_dir:=' + self.folder.name, *arguments))
        self.get_model = service(name + '/get_model', GetModel)
        self.save = service(name + '/save', Save)
        self.load = service(name + '/load', Load)
        self.reset = service(name + '/reset', Trigger)
        return self.nodes[-1]

    def file(self, name):
        return os.path.join(self.folder.name, name + '.ribbons')

    def model(self):
        return self.get_model(which=0, as_built=False, cells=True)

    def planes(self):
        planes = self.model().planes
        return planes.revision, planes.planes

    def take_lines(self):
        """Takes the first lines of a run."""
        self.assertTrue(eventually(lambda: self.robot.reaches(self.name)))
        self.robot.take(LINES)
        self.assertTrue(eventually(lambda: self.model().lines == LINES), self.model().lines)
        self.assertTrue(eventually(lambda: self.model().ribbons > 50), self.model().ribbons)

    def go_on(self):
        """Takes lines until the model has grown."""
        ribbons = self.model().ribbons

        def grows():
            self.robot.take(1)
            return self.model().ribbons > ribbons
        self.assertTrue(eventually(grows), self.model())

    def correct(self, x):
        path = Path()
        path.header.frame_id = 'map'
        for line in (20, 60):
            pose = PoseStamped()
            pose.header.frame_id, pose.header.stamp = 'map', self.robot.stamp(line)
            pose.pose.position.x, pose.pose.orientation.w = x, 1.0
            path.poses.append(pose)
        revision = self.model().planes.revision
        self.assertTrue(eventually(lambda: reaches(self.corrected, self.name)))
        self.corrected.publish(path)
        self.assertTrue(eventually(lambda: self.model().planes.revision == revision + 1))

    def test_a_killed_modeler_goes_on_from_its_autosave(self):
        node = self.start('_autosave_period_s:=0.1', '_resume:=true')
        self.take_lines()
        self.correct(x=0.5)
        before = self.planes()
        ribbons = self.model().ribbons

        def is_saved():
            return lines_in(self.file('autosave')) == self.robot.line
        self.assertTrue(eventually(is_saved), lines_in(self.file('autosave')))
        node.kill()
        self.start('_autosave_period_s:=0.1', '_resume:=true')
        self.assertEqual(self.model().ribbons, ribbons)
        self.go_on()
        self.correct(x=0.5)
        self.assertEqual(self.planes()[0], before[0] + 1)
        self.assertEqual([plane.id for plane in self.planes()[1]], [plane.id for plane in before[1]])

    def test_a_modeler_that_ends_saves_the_last_line(self):
        self.start('_autosave_period_s:=1000')
        self.take_lines()
        before = self.planes()
        self.nodes[-1].interrupt()
        self.assertEqual(lines_in(self.file('autosave')), LINES)
        self.start('_autosave_period_s:=1000', '_resume:=true')
        self.assertEqual(self.planes(), before)

    def test_a_model_that_is_not_resumed_is_kept(self):
        self.start('_autosave_period_s:=1000')
        self.take_lines()
        self.nodes[-1].interrupt()
        self.start('_autosave_period_s:=1000')
        self.assertEqual(self.model().ribbons, 0)
        self.assertEqual(lines_in(self.file('autosave_before')), LINES)
        self.assertFalse(os.path.exists(self.file('autosave')))

    def test_a_saved_model_is_loaded_again(self):
        self.start()
        self.take_lines()
        self.correct(x=0.25)
        before = self.planes()
        answer = self.save('kitchen')
        self.assertTrue(answer.success, answer.message)
        self.assertIn(self.file('kitchen'), answer.message)
        self.assertTrue(self.reset().success)
        self.assertIn('the model is empty', self.save('kitchen').message)
        answer = self.load('kitchen')
        self.assertTrue(answer.success, answer.message)
        self.assertIn('1 corrections, 1 planes', answer.message)
        self.assertEqual(self.planes(), before)
        self.assertFalse(self.get_model(which=1, as_built=False, cells=False).success)
        self.go_on()
        answer = self.load('kitchen')  # over another one
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(self.planes(), before)
        self.assertGreater(lines_in(self.file('before_load')), LINES)
        self.nodes[-1].kill()
        self.start('_load:=kitchen')
        self.assertEqual(self.planes(), before)
        self.correct(x=0.25)

    def test_what_cannot_be_loaded_changes_nothing(self):
        self.start()
        self.take_lines()
        before = self.planes()
        self.assertTrue(self.save('kitchen').success)
        with open(self.file('kitchen'), 'rb') as file:
            good = file.read()
        spoilt = {'cut': good[:-7], 'damaged': good[:500] + b'\xff' + good[501:], 'text': b'hello',
                  'empty': b''}
        for name, content in spoilt.items():
            with open(self.file(name), 'wb') as file:
                file.write(content)
        for name in list(spoilt) + ['', 'none', '..', 'a/b', '/etc/passwd', 'x' * 100]:
            answer = self.load(name)
            self.assertFalse(answer.success, name)
            self.assertTrue(answer.message, name)
            self.assertEqual(self.planes(), before)
        self.assertIn('it is cut off', self.load('cut').message)
        self.assertIn('checksum', self.load('damaged').message)
        self.assertFalse(os.path.exists(self.file('before_load')))
        self.assertFalse(self.save('autosave').success)
        self.go_on()


if __name__ == '__main__':
    rospy.init_node('load_test')
    rostest.rosrun('ribbon_mapper', 'load', LoadTest, sys.argv)
