#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The nodes are connected: a tour through a bare room gives its five planes, corrected."""
import math
import sys
import unittest

import rospy
import rostest
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from nav_msgs.srv import GetMap
from ribbon_mapper.msg import FloorRooms, PlaneArray
from ribbon_mapper.srv import Annotate, GetModel, GetModelRequest, Save
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import LaserScan, PointCloud2
from std_msgs.msg import Bool
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from diagnostics import Diagnostics
from waiting import Latest, eventually, service


class Wiring(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tf = Latest('/tf', TFMessage)
        cls.scans = Latest('tilt_scan', LaserScan)
        cls.base_scans = Latest('base_scan', LaserScan)
        cls.truth = Latest('ground_truth/planes', PlaneArray)
        cls.planes = Latest('modeler/planes', PlaneArray)
        cls.markers = Latest('modeler/markers', MarkerArray)
        cls.before = Latest('modeler/markers_before', MarkerArray)
        cls.rooms = Latest('modeler/rooms', FloorRooms)
        cls.room_markers = Latest('modeler/room_markers', MarkerArray)
        cls.cloud = Latest('modeler/cloud', PointCloud2)
        cls.trajectory = Latest('modeler/trajectory', Path)
        cls.corrected = Latest('corrected_trajectory', Path)
        cls.finished = Latest('tour_finished', Bool)
        cls.log = Latest('/rosout', Log)
        cls.diagnostics = Diagnostics()
        cls.get_model = service('modeler/get_model', GetModel)
        for topic in (cls.tf, cls.scans, cls.base_scans, cls.log):
            assert eventually(topic.publishers)
        # The tour starts with this subscriber.
        cls.odometry = Latest('base_odometry/odom', Odometry)
        over = eventually(lambda: cls.finished.messages and cls.finished.newest().data)
        assert over, 'the tour does not end'
        corrected = eventually(lambda: cls.model().planes.revision == 1)
        assert corrected, 'the correction does not come'

    @classmethod
    def model(cls, which=GetModelRequest.CURRENT):
        return cls.get_model(which=which, as_built=False, cells=False)

    def test_every_line_arrives(self):
        model = self.model()
        self.assertGreater(model.lines, 600)
        self.assertTrue(eventually(lambda: len(self.scans.messages) == model.lines))
        self.assertEqual(model.dropped_lines, 0)
        steps = {b.header.stamp.to_nsec() - a.header.stamp.to_nsec()
                 for a, b in zip(self.scans.messages, self.scans.messages[1:])}
        self.assertEqual(steps, {25000000})

    def test_the_base_laser_is_the_pr2s(self):
        scan = self.base_scans.wait()
        self.assertEqual(scan.header.frame_id, 'base_laser_link')
        self.assertEqual(len(scan.ranges), 1040)
        steps = {b.header.stamp.to_nsec() - a.header.stamp.to_nsec()
                 for a, b in zip(self.base_scans.messages, self.base_scans.messages[1:])}
        self.assertEqual(steps, {25000000})
        height = self.transform_to('base_link').translation.z
        height += self.transform_to('base_laser_link').translation.z
        self.assertAlmostEqual(height, 0.303, 6)

    def test_planes_are_those_of_the_room(self):
        self.assertTrue(eventually(lambda: self.planes.messages and
                                   self.planes.newest().revision == 1))
        self.assertEqual(len(self.truth.wait().planes), 5)
        self.assertEqual(len(self.model().planes.planes), 5)
        self.assertEqual(len(self.planes.newest().planes), 5)
        self.assertTrue(all(plane.outlines[0].outer.points for plane in self.model().planes.planes))
        self.assertTrue(self.model(GetModelRequest.BEFORE_CORRECTION).success)

    def test_planes_have_labels(self):
        labels = sorted(plane.label for plane in self.model().planes.planes)
        self.assertIn('floor', labels)
        self.assertTrue(all(labels))
        self.assertTrue(all(0.5 <= p.label_confidence <= 1 for p in self.model().planes.planes))

    def test_annotations(self):
        annotate = service('modeler/annotate', Annotate)
        plane = self.model().planes.planes[0]
        ids = {p.id for p in self.model().planes.planes}
        unknown = annotate(id=max(ids) + 1, label='mine', note='')
        self.assertFalse(unknown.success)
        self.assertTrue(all(str(i) in unknown.message for i in ids), unknown.message)
        self.assertTrue(annotate(id=plane.id, label='mine', note='a note').success)
        found = [p for p in self.model().planes.planes if p.id == plane.id][0]
        self.assertEqual((found.label, found.note), ('mine', 'a note'))
        self.assertTrue(annotate(id=plane.id, label='', note='').success)
        found = [p for p in self.model().planes.planes if p.id == plane.id][0]
        self.assertNotEqual(found.label, 'mine')

    def test_true_poses_at_the_acquisition_stamps(self):
        def stamps(path):
            return [pose.header.stamp for pose in path.poses]
        corrected = stamps(self.corrected.wait())
        self.assertTrue(corrected)
        self.assertTrue(eventually(lambda: stamps(self.trajectory.wait()) == corrected))

    def test_tf_chain_is_the_robots(self):
        """URDF, joint states and sim/robot/pr2.cpp agree: the laser's axis is 1.017675 m above the
        floor, plus the torso's lowest position."""
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
        """robot_state_publisher drops joint states at high speed unless the simulator waits for it.

        The simulator counts them: this test may itself lose transforms on a loaded machine."""
        def statements():
            return [entry.msg for entry in list(self.log.messages) if 'back as tf' in entry.msg]
        self.assertTrue(eventually(statements))
        self.assertEqual(statements(), ['Every joint state came back as tf.'])

    def test_rviz_gets_triangles(self):
        eventually(lambda: len(self.shown_markers()) == 5)
        self.assertEqual(len(self.shown_markers()), 5, self.shown_markers())
        for marker in self.shown_markers().values():
            self.assertEqual(marker.type, Marker.TRIANGLE_LIST)
            self.assertEqual(len(marker.points) % 6, 0)
            self.assertEqual(3 * len(marker.colors), len(marker.points))
        self.assertTrue(eventually(lambda: self.before.messages and
                                   self.before.newest().markers[0].colors))
        white = self.before.newest().markers[0].colors[0]
        self.assertEqual((white.r, white.g), (white.b, white.b))
        self.assertTrue(eventually(lambda: self.cloud.wait().width > 1000))

    def shown_markers(self, namespace='planes'):
        shown = {}
        for array in list(self.markers.messages):
            for marker in array.markers:
                if marker.ns == namespace:
                    shown[marker.id] = marker
        return {i: m for i, m in shown.items() if m.action == Marker.ADD}

    def test_rviz_gets_texts_normals_and_lines(self):
        for namespace in ('labels', 'normals', 'outlines'):
            self.assertTrue(eventually(lambda: len(self.shown_markers(namespace)) == 5), namespace)
        self.assertTrue(eventually(lambda: self.shown_markers('edges')))
        texts = {plane.id: f'{plane.id} {plane.label}\n{plane.area:.1f} m2'
                 for plane in self.model().planes.planes}
        # The markers of a label that another test has set and taken back may still be on their way.
        eventually(lambda: self.shown_texts() == texts)
        self.assertEqual(self.shown_texts(), texts)

    def shown_texts(self):
        return {i: marker.text for i, marker in self.shown_markers('labels').items()}

    def test_the_room_is_one_room(self):
        self.assertTrue(eventually(lambda: self.rooms.messages and
                                   self.rooms.newest().revision == 1))
        rooms = self.rooms.newest()
        self.assertEqual((rooms.header.frame_id, len(rooms.rooms)), ('map', 1))
        self.assertEqual(rooms.rooms[0].name, 'A')
        self.assertAlmostEqual(rooms.rooms[0].area, 24.0, delta=1.5)
        self.assertEqual(rooms.passages, [])
        drawn = {marker.ns for marker in self.room_markers.wait().markers}
        self.assertTrue({'rooms', 'names'} <= drawn, drawn)

    def test_maps_are_made_when_asked_for(self):
        """The room is 6 x 4 m: its floor is free, and around it are walls."""
        grid = service('modeler/get_map', GetMap)().map
        self.assertEqual(grid.header.frame_id, 'map')
        self.assertEqual(len(grid.data), grid.info.width * grid.info.height)
        self.assertEqual(set(grid.data), {-1, 0, 100})
        cell_m2 = grid.info.resolution ** 2
        self.assertAlmostEqual(list(grid.data).count(0) * cell_m2, 24.0, delta=1.5)
        self.assertGreater(list(grid.data).count(100), 2 * (6.0 + 4.0) / 0.05 * 0.8)
        latched = Latest('modeler/map', OccupancyGrid)
        self.assertEqual(latched.wait().info.width, grid.info.width)

    def test_maps_are_saved_by_name(self):
        save = service('modeler/save_map', Save)
        answer = save('room')
        self.assertTrue(answer.success, answer.message)
        for ending in ('room_map.bt', 'room_map.pgm', 'room_map.yaml'):
            self.assertIn(ending, answer.message)
        self.assertFalse(save('../room').success)

    def test_diagnostics_count(self):
        self.diagnostics.wait_until_handled(self.model().lines)
        self.assertEqual(self.diagnostics.value('lines dropped'), '0')
        self.assertGreater(float(self.diagnostics.value('real-time factor')), 0.0)
        self.assertGreater(float(self.diagnostics.value('process [MB]')), 1.0)

    def test_odometry_drifts_but_moves_alike(self):
        self.assertEqual(self.odometry.wait().header.frame_id, 'odom_combined')
        self.assertTrue(math.isfinite(self.odometry.wait().pose.pose.position.x))


if __name__ == '__main__':
    rospy.init_node('wiring_test')
    rostest.rosrun('ribbon_mapper', 'wiring', Wiring, sys.argv)
