#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Nodes refuse parameters that they do not understand: exit code 1, key and allowed range."""
import os
import subprocess
import sys
import tempfile
import unittest

import rospkg
import rostest

from program import path_of
from waiting import PATIENCE

PACKAGE = rospkg.RosPack().get_path('ribbon_mapper')
PR2 = '_config:=' + PACKAGE + '/config/pr2.yaml'
ROOM = ['_world:=' + PACKAGE + '/test/ros/room.sdf',
        '_route:=' + PACKAGE + '/test/ros/room.route.yaml']


class Refusal(unittest.TestCase):
    def refuse(self, node, arguments, *words):
        """Starts a node under a new name, because parameters outlive their node."""
        Refusal.starts = getattr(Refusal, 'starts', 0) + 1
        program = path_of(node)
        name = '__name:=%s_%d' % (node, Refusal.starts)
        done = subprocess.run([program, name] + arguments, stderr=subprocess.STDOUT,
                              stdout=subprocess.PIPE, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 1, done.stdout)
        if node != 'calibrate':  # which has no log by then
            self.assertIn('FATAL', done.stdout)
        for word in words:
            self.assertIn(word, done.stdout)

    def refuse_config(self, text, *words):
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
            file.write(text)
            file.flush()
            self.refuse('modeler', ['_config:=' + file.name], os.path.basename(file.name), *words)

    def test_modeler_without_config(self):
        self.refuse('modeler', [], '/config', 'is missing')
        self.refuse('modeler', ['_config:=/no/such.yaml'], '/no/such.yaml')

    def test_unknown_or_bad_config_keys(self):
        self.refuse_config('scan: {no_such_key: 1}\n', 'scan.no_such_key')
        self.refuse_config('scan: {range_sigma_m: -1}\n', 'range_sigma_m')
        self.refuse_config('scan: {range_sigma_m: wide}\n', 'range_sigma_m')
        self.refuse_config('scan: [1, 2\n')
        self.refuse_config('scan: &a {scan: *a}\n', 'unknown key scan.scan')

    def test_unknown_or_bad_parameters_of_the_modeler(self):
        self.refuse('modeler', [PR2, '_no_such:=1'], '/no_such', 'is unknown', '~transform_timeout')
        self.refuse('modeler', [PR2, '_transform_timeout:=-1'], '/transform_timeout', '0.1 to 60')
        self.refuse('modeler', [PR2, '_transform_timeout:=soon'], 'must be a number')
        self.refuse('modeler', [PR2, '_map_frame:=7'], 'must be a text')
        self.refuse('modeler', [PR2, '_mesh_formats:=glb,fbx'], '~mesh_formats', "'fbx'",
                    'glb, obj and stl')
        self.refuse('modeler', [PR2, '_mesh_formats:=7'], '/mesh_formats', 'must be a text')
        self.refuse('modeler', [PR2, '_output_dir:='], '/output_dir', 'is empty: set it to a folder')
        self.refuse('modeler', [PR2, '_map_frame:=/'], '/map_frame', 'is empty')
        self.refuse('modeler', [PR2, '_base_frame:=' + 'x' * 300], '/base_frame', 'is too long')
        self.refuse('modeler', [PR2, '_scan/no_such:=1'], '/scan', 'is unknown')

    def test_models_that_cannot_be_loaded(self):
        self.refuse('modeler', [PR2, '_load:=/no/such.ribbons'], 'cannot load /no/such.ribbons',
                    'cannot be read')
        self.refuse('modeler', [PR2, '_load:=..'], 'a name, not a path')
        self.refuse('modeler', [PR2, '_load:=/dev/null'], 'no model file of ribbon_mapper')
        self.refuse('modeler', [PR2, '_autosave_period_s:=-1'], '/autosave_period_s', '0 to 86400')
        self.refuse('modeler', [PR2, '_resume:=7'], '/resume', 'must be true or false')

    def test_every_node_says_what_it_is(self):
        """Without a master, which a person who asks may not have yet."""
        alone = dict(os.environ, ROS_MASTER_URI='http://localhost:1')
        for node in ('modeler', 'slam', 'slam_adapter', 'tf_filter', 'calibrate', 'pr2_simulator',
                     'correction'):
            for option, words in (('--help', node + ', a node of ROS: '), ('--version', '.')):
                said = subprocess.run([path_of(node), option], stdout=subprocess.PIPE, text=True,
                                      env=alone, timeout=PATIENCE, check=True).stdout
                self.assertIn(words, said)

    def test_every_node_refuses_unknown_parameters(self):
        output = '_output:=' + os.path.join(tempfile.gettempdir(), 'refused.yaml')
        for node, arguments in (('tf_filter', []), ('slam_adapter', ['_source:=tf']),
                                ('calibrate', [PR2, output]), ('slam', [PR2])):
            self.refuse(node, arguments + ['_no_such:=1'], '/no_such', 'is unknown; there are')

    def test_bad_parameters_of_the_slam(self):
        self.refuse('slam', [], '/config', 'is missing')
        self.refuse('slam', ['_config:=/no/such.yaml'], '/no/such.yaml')
        self.refuse('slam', [PR2, '_window:=0'], '/window', '1 to 600')
        self.refuse('slam', [PR2, '_first_noise_scale:=much'], 'must be a number')
        self.refuse('slam', [PR2, '_publish_tf:=7'], '/publish_tf', 'must be true or false')
        self.refuse('slam', [PR2, '_on_time_jump:=wait'], 'on_time_jump', 'reset, stop and continue')
        self.refuse('slam', ['_config:=' + PACKAGE + '/config/simulation.yaml'],
                    'trajectory.poses_follow is false', 'publish_tf')
        self.refuse('slam', [PR2, '_map_frame:=odom', '_odom_frame:=odom'], 'are both')

    def test_unknown_or_bad_parameters_of_the_correction(self):
        self.refuse('correction', ['_no_such:=1'], '/no_such', 'is unknown')
        self.refuse('correction', ['_radius:=0'], '/radius', 'allowed')
        self.refuse('correction', ['_at_loop:=7'], 'must be true or false')

    def test_unknown_or_bad_parameters_of_the_simulator(self):
        self.refuse('pr2_simulator', [], '/world', 'is missing')
        self.refuse('pr2_simulator', ROOM + ['_no_such:=1'], '/no_such', 'is unknown')
        self.refuse('pr2_simulator', ROOM + ['_rate:=0'], '/rate', '0.01 to 100')
        self.refuse('pr2_simulator', ROOM + ['_seed:=1.5'], '/seed', 'whole number')
        self.refuse('pr2_simulator', ROOM + ['_noise:=loud'], 'loud', 'datasheet')
        self.refuse('pr2_simulator', ROOM + ['_caster:=ode'], 'ode', 'embree')
        self.refuse('pr2_simulator', ROOM + ['_tilt_profile:=wild'], 'wild', 'manip')

    def test_bad_worlds_and_routes(self):
        self.refuse('pr2_simulator', ['_world:=/no/such.sdf', ROOM[1]], '/no/such.sdf')
        self.refuse('pr2_simulator', [ROOM[0], '_route:=/no/such.yaml'], '/no/such.yaml')
        wall = '_route:=' + PACKAGE + '/test/ros/through_the_wall.route.yaml'
        self.refuse('pr2_simulator', [ROOM[0], wall], 'east')


if __name__ == '__main__':
    rostest.rosrun('ribbon_mapper', 'refusal', Refusal, sys.argv)
