# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that random worlds are reproducible and that the robot can drive through them.

Usage: random_world_test.py EXPERIMENT PROJECT
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

EXPERIMENT, PROJECT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


def made(seeds, folder):
    subprocess.run([PROJECT / 'worlds/random_world', seeds, folder], check=True)
    return {path.name: path.read_text() for path in pathlib.Path(folder).iterdir()}


class RandomWorld(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def test_the_same_seed_gives_the_same_world(self):
        first = made('2', f'{self.folder.name}/first')
        again = made('1-3', f'{self.folder.name}/again')
        self.assertEqual({'2.sdf', '2.route.yaml'}, set(first))
        self.assertEqual(first['2.sdf'], again['2.sdf'])
        self.assertNotEqual(again['1.sdf'], again['2.sdf'])

    def test_it_can_be_driven_through_and_modelled(self):
        made('2', self.folder.name)
        subprocess.run([EXPERIMENT, '--world', f'{self.folder.name}/2.sdf', '--no-figure',
                        '--output', f'{self.folder.name}/results'],
                       check=True, capture_output=True, cwd=PROJECT)
        summary = json.loads(pathlib.Path(f'{self.folder.name}/results/summary.json').read_text())
        self.assertEqual(0, summary['dropped_lines'])
        self.assertGreaterEqual(summary['truth_planes'], 8)  # two rooms of four walls
        self.assertGreaterEqual(summary['matched'], 8)
        self.assertLess(summary['angle_error_deg_mean'], 0.5)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
