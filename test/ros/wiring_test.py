#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The nodes find each other: a tour through a bare room ends with its five planes, corrected."""
import math
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from nav_msgs.msg import Odometry, Path
from ribbon_mapper.msg import PlaneArray
from ribbon_mapper.srv import GetModel, GetModelRequest
from sensor_msgs.msg import LaserScan, PointCloud2
from std_msgs.msg import Bool
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from waiting import Latest, eventually


class Wiring(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tf = Latest('/tf', TFMessage)
        cls.odometry = Latest('base_odometry/odom', Odometry)
        cls.scans = Latest('tilt_scan', LaserScan)
        cls.truth = Latest('ground_truth/planes', PlaneArray)
        cls.planes = Latest('modeler/planes', PlaneArray)
        cls.markers = Latest('modeler/markers', MarkerArray)
        cls.before = Latest('modeler/markers_before', MarkerArray)
        cls.cloud = Latest('modeler/cloud', PointCloud2)
        cls.trajectory = Latest('modeler/trajectory', Path)
        cls.corrected = Latest('corrected_trajectory', Path)
        cls.finished = Latest('tour_finished', Bool)
        cls.diagnostics = Latest('/diagnostics', DiagnosticArray)
        rospy.wait_for_service('modeler/get_model', 20.0)
        cls.get_model = rospy.ServiceProxy('modeler/get_model', GetModel)
        over = eventually(lambda: cls.finished.messages and cls.finished.messages[-1].data, 60.0)
        assert over, 'the tour does not end'
        corrected = eventually(lambda: cls.model().planes.revision == 1)
        assert corrected, 'the correction does not come'

    @classmethod
    def model(cls, which=GetModelRequest.CURRENT, merged=True):
        return cls.get_model(which=which, merged=merged, cells=False)

    def test_every_line_arrives(self):
        model = self.model()
        self.assertGreater(model.lines, 600)
        self.assertEqual(model.lines, len(self.scans.messages))
        self.assertEqual(model.dropped_lines, 0)
        steps = {b.header.stamp.to_nsec() - a.header.stamp.to_nsec()
                 for a, b in zip(self.scans.messages, self.scans.messages[1:])}
        self.assertEqual(steps, {25000000})

    def test_planes_are_those_of_the_room(self):
        eventually(lambda: self.planes.messages[-1].revision == 1)
        self.assertEqual(len(self.truth.wait().planes), 5)
        self.assertEqual(len(self.model().planes.planes), 5)
        self.assertEqual(len(self.planes.messages[-1].planes), 5)
        self.assertTrue(all(plane.outline.points for plane in self.model().planes.planes))
        self.assertTrue(self.model(GetModelRequest.BEFORE_CORRECTION).success)

    def test_true_poses_at_the_acquisition_stamps(self):
        corrected = self.corrected.wait()
        trajectory = self.trajectory.wait()
        self.assertEqual([pose.header.stamp for pose in corrected.poses],
                         [pose.header.stamp for pose in trajectory.poses])

    def test_tf_chain_is_the_robots(self):
        """URDF, joint states and sim/robot/pr2.cpp agree: the laser's axis is 1.017675 m high, plus the
        torso's rest."""
        height = 0.0
        for child in ('base_link', 'torso_lift_link', 'laser_tilt_mount_link'):
            height += self.transform_to(child).translation.z
        self.assertAlmostEqual(height, 1.017675 + 0.0115, 6)
        self.assertAlmostEqual(self.transform_to('laser_tilt_link').translation.z, 0.03, 9)

    def transform_to(self, child):
        static = Latest('/tf_static', TFMessage)
        found = eventually(lambda: [t.transform for m in self.tf.messages + static.messages
                                    for t in m.transforms if t.child_frame_id == child])
        self.assertTrue(found, child)
        return found[-1]

    def test_tf_has_every_tilt(self):
        """robot_state_publisher drops joint states at high speed unless they wait for it."""
        stamps = [t.header.stamp.to_nsec() for m in self.tf.messages for t in m.transforms
                  if t.child_frame_id == 'laser_tilt_mount_link']
        gaps = [b - a for a, b in zip(stamps, stamps[1:])]
        self.assertLessEqual(max(gaps), 10000000)

    def test_rviz_gets_triangles(self):
        eventually(lambda: len(self.shown_markers()) == 5)
        self.assertEqual(len(self.shown_markers()), 5)
        for marker in self.shown_markers().values():
            self.assertEqual(marker.type, Marker.TRIANGLE_LIST)
            self.assertEqual(len(marker.points) % 6, 0)
            self.assertEqual(3 * len(marker.colors), len(marker.points))
        white = self.before.messages[-1].markers[0].colors[0]
        self.assertEqual((white.r, white.g), (white.b, white.b))
        self.assertGreater(self.cloud.wait().width, 1000)

    def shown_markers(self):
        shown = {}
        for array in self.markers.messages:
            for marker in array.markers:
                shown[marker.id] = marker
        return {i: m for i, m in shown.items() if m.action == Marker.ADD}

    def test_diagnostics_count(self):
        values = {v.key: v.value for s in self.diagnostics.wait().status for v in s.values}
        eventually(lambda: values.update(
            {v.key: v.value for s in self.diagnostics.messages[-1].status for v in s.values})
            or values.get('lines in') == str(len(self.scans.messages)), 5.0)
        self.assertEqual(values['lines in'], str(len(self.scans.messages)))
        self.assertEqual(values['lines dropped'], '0')
        self.assertGreater(float(values['real-time factor']), 1.0)
        self.assertGreater(float(values['process [MB]']), 1.0)

    def test_odometry_drifts_but_moves_alike(self):
        self.assertEqual(self.odometry.wait().header.frame_id, 'odom_combined')
        self.assertTrue(math.isfinite(self.odometry.wait().pose.pose.position.x))


if __name__ == '__main__':
    rospy.init_node('wiring_test')
    rostest.rosrun('ribbon_mapper', 'wiring', Wiring, sys.argv)
