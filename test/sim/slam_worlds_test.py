# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the shipped worlds for SLAM are those that worlds/slam_worlds writes.

Usage: slam_worlds_test.py PROJECT
"""
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

WORLDS = pathlib.Path(sys.argv[1]) / 'worlds'


def written(folder, *arguments):
    subprocess.run([WORLDS / 'slam_worlds', *arguments, folder], check=True)
    return {path.name: path.read_text() for path in pathlib.Path(folder).iterdir()}


def length_m(route):
    waypoints = [tuple(map(float, point)) for point in re.findall(r'- \[(.*), (.*)\]', route)]
    return sum(math.dist(a, b) for a, b in zip(waypoints, waypoints[1:]))


def rest_s(route):
    return float(re.search(r'^rest: ([0-9.]+)', route, re.MULTILINE).group(1))


class SlamWorlds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.files = written(folder.name)

    def test_the_shipped_files_are_the_written_ones(self):
        self.assertGreaterEqual(len(self.files), 14)
        for name, text in self.files.items():
            self.assertEqual((WORLDS / name).read_text(), text, f'run worlds/slam_worlds: {name}')

    def test_the_robot_rests_first(self):
        for name, text in self.files.items():
            if name.endswith('.yaml'):
                self.assertGreaterEqual(rest_s(text), 5.0, name)

    def test_rows_of_rooms_are_functions_of_their_number(self):
        with tempfile.TemporaryDirectory() as folder:
            one = written(folder, '--rows', '1')
        with tempfile.TemporaryDirectory() as folder:
            two = written(folder, '--rows', '2')
        self.assertEqual(set(two) - set(one), {'row_2.sdf', 'row_2.route.yaml'})
        self.assertEqual(set(one) - set(self.files), {'row_1.sdf', 'row_1.route.yaml'})
        self.assertEqual(one['row_1.sdf'], two['row_1.sdf'])
        cupboards = [re.findall('"(cupboard.*)<', two[f'row_{i}.sdf']) for i in (1, 2)]
        self.assertEqual(len(cupboards[0]), len(cupboards[1]))
        self.assertNotEqual(*cupboards)

    def test_open_paths_are_as_long_as_their_names_say(self):
        for name, way_m in (('open_path_flat', 26.0), ('open_path_corridor', 89.0)):
            self.assertAlmostEqual(length_m(self.files[f'{name}.route.yaml']), way_m, delta=0.05)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
