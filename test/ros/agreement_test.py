#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same tour over ROS and in one process: the same lines, no line dropped, as many planes."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

import roslib.packages
import rospkg
import rospy
import rostest
from ribbon_mapper.srv import GetModel

from waiting import eventually

PACKAGE = rospkg.RosPack().get_path('ribbon_mapper')
LONGEST_TOUR = 200.0


def experiment_summary():
    program = roslib.packages.find_node('ribbon_mapper', 'experiment')[0]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, '--seed', '1', '--drift', '3.0', '--no-figure', '--output', folder,
                        '--world', os.path.join(PACKAGE, 'worlds/apartment.sdf'),
                        '--config', os.path.join(PACKAGE, 'config/simulation.yaml')],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(os.path.join(folder, 'summary.json')) as file:
            return json.load(file)


class Agreement(unittest.TestCase):
    def test_ros_and_one_process_agree(self):
        rospy.wait_for_service('modeler/get_model', 20.0)
        get_model = rospy.ServiceProxy('modeler/get_model', GetModel)

        def corrected():
            rospy.rostime.wallsleep(1.0)
            model = get_model(which=0, merged=True, cells=False)
            return model if model.planes.revision == 1 else None

        model = eventually(corrected, LONGEST_TOUR)
        self.assertTrue(model, 'no correction within %g s' % LONGEST_TOUR)
        summary = experiment_summary()
        self.assertEqual(model.dropped_lines, 0)
        self.assertEqual(model.lines, summary['lines'])
        self.assertEqual(len(model.planes.planes), summary['planes_corrected'])
        self.assertAlmostEqual(model.ribbons / summary['ribbons'], 1.0, delta=0.01)


if __name__ == '__main__':
    rospy.init_node('agreement_test')
    rostest.rosrun('ribbon_mapper', 'agreement', Agreement, sys.argv)
