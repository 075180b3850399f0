# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds that Python makes the same bytes of the same lines as C++ does:
same_bytes_test.py ROOM_LINES [BAG_LINES OFFLINE_MODELER]"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import lines_file
import ribbon_mapper

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PRESET = PROJECT / "config/pr2.yaml"
ROOM_LINES, *WITH_ROS = sys.argv[1:]


class SameBytes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def model_file(self, modeler):
        path = self.folder / "python.ribbons"
        modeler.save(path)
        return path.read_bytes()

    def assert_same(self, modeler, name):
        self.assertEqual((self.folder / f"{name}.json").read_text(),
                         ribbon_mapper.planes_to_json(modeler.planes()))
        self.assertEqual((self.folder / f"{name}.tum").read_text(),
                         ribbon_mapper.to_tum(*modeler.trajectory()))
        self.assertEqual((self.folder / f"{name}.ribbons").read_bytes(), self.model_file(modeler))

    def test_as_the_library(self):
        subprocess.run([ROOM_LINES, PRESET, self.folder], check=True)
        lines = lines_file.read(self.folder / "lines")
        self.assertGreater(len(lines), 500)
        modeler = lines_file.add(lines, ribbon_mapper.Modeler(PRESET))
        self.assert_same(modeler, "recorded")
        modeler.correct(*ribbon_mapper.read_tum(self.folder / "truth.tum"))
        self.assert_same(modeler, "corrected")
        again = ribbon_mapper.Modeler.load(self.folder / "corrected.ribbons")
        self.assert_same(again, "corrected")

    def test_another_line_makes_other_bytes(self):
        subprocess.run([ROOM_LINES, PRESET, self.folder], check=True)
        lines = lines_file.read(self.folder / "lines")
        ranges_m = lines[300].ranges_m.copy()
        ranges_m[100] += 0.001
        lines[300] = lines[300]._replace(ranges_m=ranges_m)
        modeler = lines_file.add(lines, ribbon_mapper.Modeler(PRESET))
        self.assertNotEqual((self.folder / "recorded.ribbons").read_bytes(),
                            self.model_file(modeler))

    @unittest.skipUnless(WITH_ROS, "built without ROS")
    def test_as_offline_modeler(self):
        bag_lines, offline_modeler = WITH_ROS
        bag, truth = PROJECT / "test/data/small_room.bag", PROJECT / "test/data/small_room.tum"
        subprocess.run([bag_lines, bag, self.folder / "lines"], check=True)
        modeler = lines_file.add(lines_file.read(self.folder / "lines"),
                                 ribbon_mapper.Modeler(PRESET))
        modeler.correct(*ribbon_mapper.read_tum(truth))
        results = self.folder / "results"
        run = subprocess.run([offline_modeler, "--bag", bag, "--trajectory", truth, "--config",
                              PRESET, "--output", results], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
        self.assertEqual(0, run.returncode, run.stdout)
        self.assertEqual((results / "model.ribbons").read_bytes(), self.model_file(modeler))
        planes = [line for line in (results / "planes_after.json").read_text().splitlines(True)
                  if not line.startswith('"run": ')]
        self.assertEqual("".join(planes), ribbon_mapper.planes_to_json(modeler.planes()))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
