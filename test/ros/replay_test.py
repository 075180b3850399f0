#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bag that is played is modelled as offline_modeler does: the same lines, the same planes."""
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

BAG = os.path.join(rospkg.RosPack().get_path('ribbon_mapper'), 'test/data/small_room.bag')


def offline():
    program = roslib.packages.find_node('ribbon_mapper', 'offline_modeler')[0]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, '--bag', BAG, '--output', folder], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(os.path.join(folder, 'summary.json')) as file:
            summary = json.load(file)
        with open(os.path.join(folder, 'planes_after.json')) as file:
            return summary, json.load(file)['planes']


class Replay(unittest.TestCase):
    def test_replay_and_offline_agree(self):
        rospy.wait_for_service('modeler/get_model', 20.0)
        get_model = rospy.ServiceProxy('modeler/get_model', GetModel)
        summary, planes = offline()

        def finished():
            rospy.rostime.wallsleep(0.5)
            model = get_model(which=0, merged=True, cells=False)
            return model if model.lines == summary['lines'] else None

        model = eventually(finished, 60.0)
        self.assertTrue(model, 'the bag was not played to its end')
        rospy.rostime.wallsleep(1.0)
        model = get_model(which=0, merged=True, cells=False)
        self.assertEqual(model.dropped_lines, 0)
        self.assertEqual(model.ribbons, summary['ribbons'])
        print([(p.id, round(p.d, 4), round(p.area, 3)) for p in model.planes.planes], [(p["id"], round(p["d"], 4), round(p["area"], 3)) for p in planes], file=sys.stderr)
        self.assertEqual(len(model.planes.planes), len(planes))
        for played, read in zip(model.planes.planes, planes):
            self.assertEqual(played.id, read['id'])
            self.assertAlmostEqual(played.d, read['d'], places=9)
            self.assertAlmostEqual(played.area, read['area'], places=9)


if __name__ == '__main__':
    rospy.init_node('replay_test')
    rostest.rosrun('ribbon_mapper', 'replay', Replay, sys.argv)
