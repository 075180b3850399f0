#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A calibration over ROS writes a preset."""
import os
import sys
import unittest

import rospy
import rostest
import yaml

from waiting import eventually


class Calibrate(unittest.TestCase):
    def test_it_writes_a_preset(self):
        path = rospy.get_param('~output')
        self.assertTrue(eventually(lambda: os.path.exists(path)), 'no ' + path)
        with open(path) as file:
            text = file.read()
        self.assertIn('V_sensor', text)
        self.assertIn('V_slam', text)
        with open(os.path.join(os.path.dirname(os.path.abspath(__file__)),
                               '../../config/pr2.yaml')) as file:
            usual = yaml.safe_load(file)
        preset = yaml.safe_load(text)
        self.assertEqual({section: set(keys) for section, keys in preset.items()},
                         {section: set(keys) for section, keys in usual.items()})
        slam, corrected = preset['association']['slam'], preset['association']['corrected']
        self.assertGreater(slam['distance_m'], corrected['distance_m'])
        self.assertGreater(slam['angle_deg'], corrected['angle_deg'])
        self.assertLess(slam['distance_m'], 0.5)
        self.assertEqual(corrected, usual['association']['corrected'], 'the sensor alone is better than that')


if __name__ == '__main__':
    rospy.init_node('calibration')
    rostest.rosrun('ribbon_mapper', 'calibration', Calibrate, sys.argv)
