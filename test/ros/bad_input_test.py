#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever comes in, the modeler goes on, keeps its model and says what is wrong."""
import math
import os
import sys
import unittest

import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from ribbon_mapper.srv import GetModel, GetModelRequest, Save
from rosgraph_msgs.msg import Log
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

from diagnostics import Diagnostics
from robot_before_a_wall import BEAMS, Robot
from waiting import Latest, eventually, service


class BadInput(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.get_model = service('modeler/get_model', GetModel)
        cls.save = service('modeler/save', Save)
        cls.reset_model = service('modeler/reset', Trigger)
        cls.robot = Robot()
        cls.corrected = rospy.Publisher('corrected_trajectory', Path, queue_size=10)
        cls.log = Latest('/rosout', Log)
        cls.trajectory = Latest('modeler/trajectory', Path)
        cls.diagnostics = Diagnostics()
        assert eventually(cls.robot.connected)
        assert eventually(lambda: cls.corrected.get_num_connections() > 0)
        assert eventually(lambda: cls.log.publishers() > 0 and cls.trajectory.publishers() > 0)

    def setUp(self):
        """Builds a model of one wall."""
        self.reset()
        self.robot.take(100)
        self.wait_for_lines()
        self.assertTrue(eventually(lambda: self.model().ribbons > 50), self.model())
        self.assertEqual(len(self.model().planes.planes), 1)
        self.assertEqual(self.model().dropped_lines, 0)

    def tearDown(self):
        """Checks that good lines are taken as before."""
        ribbons, dropped = self.model().ribbons, self.model().dropped_lines
        self.robot.take(20)
        self.wait_for_lines()
        self.assertTrue(eventually(lambda: self.model().ribbons > ribbons), self.model())
        self.assertEqual(self.model().dropped_lines, dropped)
        self.assertEqual(len(self.model().planes.planes), 1)

    def reset(self):
        self.assertTrue(self.reset_model().success)
        self.robot.sent = 0

    def wait_for_lines(self):
        """Waits until no scan is on its way any more."""
        arrived = eventually(lambda: self.model().lines == self.robot.sent)
        self.assertTrue(arrived, (self.robot.sent, self.model()))

    def model(self, which=GetModelRequest.CURRENT):
        return self.get_model(which=which, as_built=False, cells=False)

    def dropped_for(self, reason):
        return int(self.diagnostics.value('dropped: ' + reason) or 0)

    def logged(self, text):
        return eventually(lambda: any(text in entry.msg for entry in self.log.messages))

    def test_scans_without_a_usable_range_change_nothing(self):
        wall = self.model().planes.planes[0]
        for value in (math.nan, math.inf, -math.inf, -1.0, 0.0, 1e30):
            scan = self.robot.scan(self.robot.line)
            scan.ranges = [value] * len(scan.ranges)
            self.robot.send(scan)
        self.wait_for_lines()
        after = self.model().planes.planes[0]
        self.assertEqual((after.normal, after.d, after.area), (wall.normal, wall.d, wall.area))

    def test_malformed_scans_are_dropped_and_counted(self):
        def spoilt(**fields):
            scan = self.robot.scan(self.robot.line)
            for name, value in fields.items():
                setattr(scan, name, value)
            return scan
        bad = [spoilt(ranges=[]), spoilt(ranges=[3.0] * 7), spoilt(ranges=[3.0] * 5000),
               spoilt(angle_increment=0.0), spoilt(angle_increment=math.nan),
               spoilt(angle_min=math.inf), spoilt(angle_min=-1e9, angle_max=1e9),
               spoilt(time_increment=math.nan), spoilt(time_increment=math.inf),
               spoilt(time_increment=-1.0), spoilt(time_increment=1e30),
               spoilt(range_max=math.nan)]
        bad.append(spoilt())
        bad[-1].header.frame_id = ''
        bad.append(spoilt())
        bad[-1].header.stamp = rospy.Time(0)
        bad.append(spoilt())
        bad[-1].header.stamp = rospy.Time(0xffffffff)
        for scan in bad:
            self.robot.send(scan)
        self.wait_for_lines()
        dropped = eventually(lambda: self.model().dropped_lines == len(bad))
        self.assertTrue(dropped, self.model().dropped_lines)
        self.assertTrue(eventually(lambda: self.dropped_for('malformed') >= 8),
                        self.diagnostics.reports()[-1:])

    def test_stamps_that_go_back_are_dropped(self):
        for line in (self.robot.line - 1, self.robot.line - 50):
            self.robot.send(self.robot.scan(line))
        self.assertTrue(eventually(lambda: self.dropped_for('out of order') == 2))

    def test_a_missing_frame_is_named(self):
        scan = self.robot.scan(self.robot.line)
        scan.header.frame_id = '/nowhere_link'
        self.robot.send(scan)
        self.assertTrue(eventually(
            lambda: self.dropped_for('frame nowhere_link is not in tf') == 1))
        self.assertTrue(self.logged('nowhere_link'))

    def test_a_name_of_two_megabytes_does_not_fill_the_log(self):
        scan = self.robot.scan(self.robot.line)
        scan.header.frame_id = 'x' * 2000000
        self.log.messages.clear()
        self.robot.send(scan)
        self.assertTrue(eventually(lambda: self.dropped_for('malformed') == 1))
        path = self.path([self.robot.stamp(0)], frame='y' * 2000000)
        self.corrected.publish(path)
        self.assertTrue(self.logged('refused'))
        self.assertLess(max(len(entry.msg) for entry in self.log.messages), 1000)

    def test_repeated_transforms_are_one_warning(self):
        self.log.messages.clear()
        for _ in range(200):
            self.robot.tf.publish(TFMessage([
                self.robot.transform('map', 'odom_combined', self.robot.line - 1)]))
        repeated = eventually(
            lambda: int(self.diagnostics.value('transforms repeated') or 0) >= 200)
        self.assertTrue(repeated, self.diagnostics.reports()[-1:])
        warnings = [entry.msg for entry in self.log.messages if 'repeated' in entry.msg]
        self.assertEqual(len(warnings), 1, warnings)

    def test_lost_lines_are_counted(self):
        self.robot.scans.impl.seq += 30  # as if a queue had dropped them
        self.robot.line += 30
        self.log.messages.clear()
        self.robot.take(1)
        lost = eventually(lambda: self.diagnostics.value(
            'lines lost before they came (header.seq)') == '30')
        self.assertTrue(lost, self.diagnostics.reports()[-1:])
        self.assertTrue(self.logged('30 lost so far'))

    def send_until_logged(self, text, **fields):
        """Sends spoilt scans until the node, which looks every 5 s, says something of them."""
        self.log.messages.clear()

        def is_said():
            for _ in range(10):
                scan = self.robot.scan(self.robot.line)
                for name, value in fields.items():
                    setattr(scan, name, value)
                self.robot.send(scan)
            return any(text in entry.msg for entry in self.log.messages)
        self.assertTrue(eventually(is_said), [entry.msg for entry in self.log.messages])
        self.wait_for_lines()

    def test_lines_that_give_nothing_are_explained(self):
        self.send_until_logged('x no returns): no range lies within the laser',
                               ranges=[math.inf] * BEAMS)

    def test_a_time_increment_that_does_not_fit_is_named(self):
        self.send_until_logged('scan_time is 25.0 ms, and lines come every 25.0 ms: these do not '
                               'fit', time_increment=1e-6, scan_time=0.025)

    def path(self, stamps, x=0.0, frame='map'):
        path = Path()
        path.header.frame_id = frame
        for stamp in stamps:
            pose = PoseStamped()
            pose.header.frame_id, pose.header.stamp = frame, stamp
            pose.pose.position.x = x
            pose.pose.orientation.w = 1.0
            path.poses.append(pose)
        return path

    def refuse(self, path, reason):
        wall = self.model().planes.planes[0]
        self.log.messages.clear()
        self.corrected.publish(path)
        self.assertTrue(self.logged('refused'), reason)
        self.assertTrue(self.logged(reason), [entry.msg for entry in self.log.messages])
        self.assertEqual(self.model().planes.revision, 0)
        self.assertEqual(self.model().planes.planes[0], wall)
        self.assertFalse(self.model(GetModelRequest.BEFORE_CORRECTION).success)

    def test_bad_trajectories_are_refused(self):
        stamps = [self.robot.stamp(self.robot.line - back) for back in (60, 40, 20)]
        self.refuse(Path(), 'it is empty')
        self.refuse(self.path(stamps[::-1]), 'not later than the one before')
        self.refuse(self.path(stamps[:1] * 3), 'not later than the one before')
        self.refuse(self.path(stamps, frame='odom'), "must be in 'map'")
        self.refuse(self.path(stamps, x=math.nan), 'is not finite')
        self.refuse(self.path([rospy.Time(1), rospy.Time(2)]), 'refused')
        upside_down = self.path(stamps)
        upside_down.poses[1].pose.orientation.w = 0.0
        self.refuse(upside_down, 'quaternion')

    def test_a_partial_trajectory_corrects_the_rest_too(self):
        stamps = [self.robot.stamp(self.robot.line - back) for back in (60, 40)]
        self.corrected.publish(self.path(stamps, x=0.5))
        self.assertTrue(eventually(lambda: self.model().planes.revision == 1))
        wall = self.model().planes.planes[0]
        self.assertAlmostEqual(wall.centroid.x, 3.5, delta=0.01)
        before = self.model(GetModelRequest.BEFORE_CORRECTION).planes.planes[0]
        self.assertAlmostEqual(before.centroid.x, 3.0, delta=0.01)
        moved = eventually(lambda: self.trajectory.messages and all(
            abs(pose.pose.position.x - 0.5) < 1e-6
            for pose in self.trajectory.messages[-1].poses))
        self.assertTrue(moved)
        self.reset()
        self.robot.take(60)

    def test_save_takes_a_name_only(self):
        for name in ('', '..', '../escape', 'a/b', '/tmp/x', '.hidden', 'a..b', 'x' * 100, 'a b',
                     'wall_rooms', 'wall_map', 'autosave'):
            answer = self.save(name)
            self.assertFalse(answer.success, name)
            self.assertTrue(answer.message, name)
        answer = self.save('wall')
        self.assertTrue(answer.success, answer.message)
        files = answer.message.split(' written to ')[1].split()
        endings = [os.path.splitext(file)[1] for file in files]
        self.assertEqual(sorted(endings), [".bt", ".geojson", ".glb", ".html", ".json", ".json", ".ply",
                                           ".ply", ".ribbons", ".stl"])
        self.assertTrue(all(os.path.getsize(file) > 0 for file in files), answer.message)


if __name__ == '__main__':
    rospy.init_node('bad_input_test')
    rostest.rosrun('ribbon_mapper', 'bad_input', BadInput, sys.argv)
