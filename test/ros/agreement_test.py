#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same tour over ROS and in one process: the same lines, no line dropped, equally many planes."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

import rospkg
import rospy
import rostest
from nav_msgs.msg import Path
from ribbon_mapper.srv import GetModel

from program import path_of
from waiting import Latest, eventually, service

PACKAGE = rospkg.RosPack().get_path('ribbon_mapper')
LONGEST_TOUR = 900.0  # seconds on the wall clock


def experiment_summary():
    program = path_of('experiment')
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, '--seed', '1', '--drift', '3.0', '--no-figure', '--output', folder,
                        '--world', os.path.join(PACKAGE, 'worlds/apartment.sdf'),
                        '--config', os.path.join(PACKAGE, 'config/simulation.yaml')],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(os.path.join(folder, 'summary.json')) as file:
            return json.load(file)


class Agreement(unittest.TestCase):
    def test_ros_and_one_process_agree(self):
        corrections = Latest('corrected_trajectory', Path)
        get_model = service('modeler/get_model', GetModel)
        self.assertTrue(eventually(corrections.newest, LONGEST_TOUR), 'no correction')

        def corrected():
            model = get_model(which=0, as_built=False, cells=False)
            return model if model.planes.revision == 1 else None

        model = eventually(corrected)
        self.assertTrue(model, 'the correction was not applied')
        summary = experiment_summary()
        self.assertEqual(model.dropped_lines, 0)
        self.assertEqual(model.lines, summary['lines'])
        self.assertEqual(len(model.planes.planes), summary['planes_corrected'])
        self.assertAlmostEqual(model.ribbons / summary['ribbons'], 1.0, delta=0.01)


if __name__ == '__main__':
    rospy.init_node('agreement_test')
    rostest.rosrun('ribbon_mapper', 'agreement', Agreement, sys.argv)
