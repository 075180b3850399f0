#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A replayed bag gives the same lines and the same planes as offline_modeler."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

import rospkg
import rospy
import rostest
from ribbon_mapper.srv import GetModel

from program import path_of
from waiting import eventually, service

BAG = os.path.join(rospkg.RosPack().get_path('ribbon_mapper'), 'test/data/small_room.bag')


def offline():
    program = path_of('offline_modeler')
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, '--bag', BAG, '--output', folder], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(os.path.join(folder, 'summary.json')) as file:
            summary = json.load(file)
        with open(os.path.join(folder, 'planes_after.json')) as file:
            return summary, json.load(file)['planes']


class Replay(unittest.TestCase):
    def test_replay_and_offline_agree(self):
        get_model = service('modeler/get_model', GetModel)
        summary, planes = offline()

        def finished():
            model = get_model(which=0, as_built=False, cells=False)
            counts = (model.lines, model.ribbons)
            return model if counts == (summary['lines'], summary['ribbons']) else None

        model = eventually(finished)
        self.assertTrue(model, 'the bag was not played to its end')
        self.assertEqual(model.dropped_lines, 0)
        self.assertEqual(len(model.planes.planes), len(planes))
        for played, read in zip(model.planes.planes, planes):
            self.assertEqual(played.id, read['id'])
            self.assertAlmostEqual(played.d, read['d'], places=9)
            self.assertAlmostEqual(played.area, read['area'], places=9)


if __name__ == '__main__':
    rospy.init_node('replay_test')
    rostest.rosrun('ribbon_mapper', 'replay', Replay, sys.argv)
