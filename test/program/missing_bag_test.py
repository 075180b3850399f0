#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A replay of a bag that is not there ends, instead of waiting for its scans."""
import os
import socket
import subprocess
import unittest

PATIENCE = 300.0  # far more than a loaded machine needs [s]


def free_port():
    with socket.socket() as probe:
        probe.bind(('localhost', 0))
        return probe.getsockname()[1]


class MissingBag(unittest.TestCase):
    def test_the_launch_ends_and_names_the_bag(self):
        environment = dict(os.environ, ROS_HOSTNAME='localhost',
                           ROS_MASTER_URI=f'http://localhost:{free_port()}')
        done = subprocess.run(['roslaunch', 'ribbon_mapper', 'pr2_replay.launch', 'bag:=nothere.bag'],
                              env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=PATIENCE)
        self.assertIn('Error opening file', done.stdout)
        self.assertIn('nothere.bag', done.stdout)


if __name__ == '__main__':
    unittest.main()
