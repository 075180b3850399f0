#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""loop_closure.launch as users run it: the corrected model has each plane of the world once.

~corrections: their number; ~drift: that of the localisation; ~output: folder of the report.
"""
import json
import math
import os
import sys
import unittest

import rospy
import rostest
from nav_msgs.msg import Odometry, Path
from ribbon_mapper.msg import PlaneArray
from ribbon_mapper.srv import GetModel, GetModelRequest
from std_msgs.msg import Bool
from tf2_msgs.msg import TFMessage

from plane_matching import compare
from waiting import Latest, eventually, service

PLANES = 5  # of the bare room


def product(a, b):
    """Returns the pose b in the frame of the pose a: x, y and yaw."""
    cosine, sine = math.cos(a[2]), math.sin(a[2])
    return (a[0] + cosine * b[0] - sine * b[1], a[1] + sine * b[0] + cosine * b[1], a[2] + b[2])


class LoopClosure(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.drift = rospy.get_param('~drift')
        cls.corrections = rospy.get_param('~corrections')
        cls.truth = Latest('ground_truth/planes', PlaneArray)
        cls.planes = Latest('modeler/planes', PlaneArray)
        cls.trajectory = Latest('modeler/trajectory', Path)
        cls.before = Latest('modeler/trajectory_before', Path)
        cls.finished = Latest('tour_finished', Bool)
        cls.corrected = Latest('corrected_trajectory', Path)
        cls.tf = Latest('/tf', TFMessage)
        cls.true_pose = Latest('base_pose_ground_truth', Odometry)
        cls.get_model = service('modeler/get_model', GetModel)
        assert eventually(cls.corrected.publishers)
        # The tour starts with this subscriber.
        cls.odometry = Latest('base_odometry/odom', Odometry)
        assert eventually(lambda: cls.finished.messages and cls.finished.newest().data), 'tour'
        assert eventually(lambda: cls.model().planes.revision == cls.corrections), 'correction'
        assert eventually(lambda: cls.planes.messages and
                          cls.planes.newest().revision == cls.corrections), 'planes'

    @classmethod
    def model(cls, which=GetModelRequest.CURRENT, cells=False):
        return cls.get_model(which=which, as_built=False, cells=cells)

    def counts(self, **which):
        return compare(self.model(cells=True, **which).planes.planes, self.truth.wait().planes)

    def test_the_corrected_model_is_the_world(self):
        self.assertEqual(len(self.truth.wait().planes), PLANES)
        counts = self.counts()
        self.assertEqual(counts.key(), (PLANES, 0, 0, 0), counts)

    def test_what_is_published_is_what_the_service_gives(self):
        published = {p.id: p for p in self.planes.newest().planes}
        given = {p.id: p for p in self.model().planes.planes}
        self.assertEqual(sorted(published), sorted(given))
        for i, plane in given.items():
            self.assertEqual(published[i].normal, plane.normal)
            self.assertEqual(published[i].d, plane.d)

    def test_the_noisy_model_has_copies_exactly_if_there_is_drift(self):
        """The control is merged and filtered like the corrected model."""
        counts = self.counts(which=GetModelRequest.BEFORE_CORRECTION)
        if self.drift == 0.0:
            self.assertEqual(counts.key(), (PLANES, 0, 0, 0), counts)
        elif self.corrections == 1:
            self.assertGreater(counts.extra + counts.duplicates, 0, counts)

    def test_without_drift_nothing_changes(self):
        if self.drift > 0.0:
            return
        before = self.model(which=GetModelRequest.BEFORE_CORRECTION).planes.planes
        after = {plane.id: plane for plane in self.model().planes.planes}
        self.assertEqual({plane.id for plane in before}, set(after))
        for old in before:
            new = after[old.id]
            for axis in ('x', 'y', 'z'):  # the gates of corrected poses are narrower: other ribbons
                self.assertAlmostEqual(getattr(old.normal, axis), getattr(new.normal, axis),
                                       delta=0.001)
            self.assertAlmostEqual(old.d, new.d, delta=0.002)
        def poses(paths):
            return paths.newest().poses if paths.newest() else []
        self.assertTrue(eventually(lambda: len(poses(self.before)) > 600 and
                                   len(poses(self.before)) == len(poses(self.trajectory))))
        for old, new in zip(poses(self.before), poses(self.trajectory)):
            self.assertEqual(old.header.stamp, new.header.stamp)
            self.assertAlmostEqual(old.pose.position.x, new.pose.position.x, 6)
            self.assertAlmostEqual(old.pose.position.y, new.pose.position.y, 6)

    def test_the_first_of_two_corrections_came_on_the_way(self):
        if self.corrections < 2:
            return
        self.assertTrue(eventually(lambda: len(self.corrected.messages) == 2))
        first, last = (len(path.poses) for path in self.corrected.messages)
        self.assertGreater(first, 100)
        self.assertLess(first, 0.9 * last)

    def test_the_robot_jumps_to_its_corrected_pose(self):
        """tf follows the correction at the end of the tour; the rest is odometry of one line."""
        def error_m():
            truth = self.true_pose.wait().pose.pose.position
            x, y = product(self.newest_pose('map'), self.newest_pose('odom_combined'))[:2]
            return math.hypot(x - truth.x, y - truth.y)
        self.assertTrue(eventually(lambda: error_m() < 0.02), error_m())
        publishers = {message._connection_header['callerid'] for message in list(self.tf.messages)
                      if message.transforms[0].header.frame_id == 'map'}
        self.assertEqual(publishers, {'/pr2_simulator'})

    def newest_pose(self, parent):
        """Returns x, y and yaw of the newest transform below a frame."""
        messages = list(self.tf.messages)
        transform = next(t.transform for m in reversed(messages) for t in m.transforms
                         if t.header.frame_id == parent)
        at, turned = transform.translation, transform.rotation
        return at.x, at.y, 2.0 * math.atan2(turned.z, turned.w)

    def test_the_report_says_the_same(self):
        path = os.path.join(rospy.get_param('~output'), 'summary.json')
        self.assertTrue(eventually(lambda: os.path.exists(path)), 'no report in ' + path)
        with open(path) as file:
            report = json.load(file)['four_models']
        cells = (('corrected', self.counts()),
                 ('noisy', self.counts(which=GetModelRequest.BEFORE_CORRECTION)))
        for cell, counts in cells:
            figures = tuple(report[cell][key] for key in ('matched', 'missed', 'extra',
                                                          'duplicates'))
            self.assertEqual(figures, counts.key(), cell)


if __name__ == '__main__':
    rospy.init_node('loop_closure_test')
    rostest.rosrun('ribbon_mapper', rospy.get_name().strip('/'), LoopClosure, sys.argv)
