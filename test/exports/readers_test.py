# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files for other programs open in independent readers, and say what the world is.

Usage: python3 readers_test.py EXPERIMENT MESH_AREAS PROJECT_DIR
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import wall_truth

EXPERIMENT, MESH_AREAS, PROJECT = sys.argv[1:4]
WORLD = PROJECT + "/worlds/apartment.sdf"
SVG = "{http://www.w3.org/2000/svg}"


def run(*command):
    return subprocess.run(command, check=True, text=True, capture_output=True).stdout


def area_of(ring):
    """Returns the area of a ring in space [m2]."""
    total = [0.0, 0.0, 0.0]
    for a, b in zip(ring, ring[1:] + ring[:1]):
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            total[axis] += 0.5 * (a[u] * b[v] - a[v] * b[u])
    return sum(component ** 2 for component in total) ** 0.5


class Readers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        run(EXPERIMENT, "--world", WORLD, "--output", str(cls.folder), "--no-figure",
            "--floor-plan", "--mesh-formats", "glb,obj,stl")
        cls.plan = wall_truth.Plan(cls.folder / "floor_plan.geojson")
        cls.walls = wall_truth.boxes(WORLD)
        cls.planes = json.loads((cls.folder / "planes_after.json").read_text())["planes"]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def rooms(self):
        return [properties for properties, _ in self.plan.kind("room")]

    def test_walls_are_as_thick_as_those_of_the_world(self):
        errors = [error for error, _ in wall_truth.thickness_errors(self.plan, self.walls)]
        self.assertGreaterEqual(len(errors), 6)  # four outer walls of the flat, two partitions
        for error in errors:
            self.assertIsNotNone(error, "no wall is there")
            self.assertLess(abs(error), 0.01)

    def test_each_doorway_is_open(self):
        shut, count = wall_truth.shut_doorways(self.plan, self.walls)
        self.assertEqual((shut, count), ([], 4))
        self.assertEqual(len(self.plan.kind("door", "opening")), 4, "none is invented")
        for error in wall_truth.width_errors(self.plan, self.walls):
            self.assertLess(abs(error), 0.101)  # a cell at each jamb

    def test_rooms_have_the_areas_of_the_world(self):
        inside = sorted(room["area_m2"] for room in self.rooms())[:3]
        for found, true in zip(inside, (3.3 * 2.8, 3.3 * 2.9, 4.4 * 5.8)):
            self.assertAlmostEqual(found, true, delta=0.01 * true)
        self.assertTrue(all(room["is_enclosed"] for room in self.rooms()))

    def test_meshes_open_in_assimp(self):
        true_m2 = sum(area_of(ring) * (1.0 if i == 0 else -1.0) for plane in self.planes
                      for outline in plane["outlines"] for i, ring in enumerate(outline))
        names = sorted(f"plane {plane['id']} {plane['label']}" for plane in self.planes)
        for suffix in ("glb", "obj", "stl"):
            lines = run(MESH_AREAS, str(self.folder / f"planes_after.{suffix}")).splitlines()
            objects = [line.split(" ", 1) for line in lines]
            found_m2 = sum(float(area) for area, _ in objects)
            self.assertAlmostEqual(found_m2, true_m2, delta=0.01 * true_m2, msg=suffix)
            if suffix != "stl":  # which has no names
                self.assertEqual(sorted(name for _, name in objects), names)

    @unittest.skipUnless(shutil.which("ogrinfo"), "needs gdal-bin")
    def test_geojson_opens_in_gdal(self):
        path = str(self.folder / "floor_plan.geojson")
        text = run("ogrinfo", "-al", path)
        self.assertNotIn("WGS 84", text)
        self.assertIn('ENGCRS["map"', text)
        for kind in ("wall", "door", "room", "solid"):
            self.assertIn(f"kind (String) = {kind}\n", text)
        table = run("ogrinfo", "-q", path, "-sql",
                    "SELECT OGR_GEOM_AREA AS drawn, area_m2 FROM floor_plan WHERE kind = 'room'")
        values = [float(line.split("=")[1]) for line in table.splitlines() if "=" in line]
        self.assertEqual(len(values), 2 * len(self.rooms()))
        for drawn, said in zip(values[::2], values[1::2]):
            self.assertAlmostEqual(drawn, said, delta=0.01)

    @unittest.skipUnless(shutil.which("ogrinfo"), "needs gdal-bin")
    def test_dxf_opens_in_gdal(self):
        table = run("ogrinfo", "-q", str(self.folder / "floor_plan.dxf"), "-sql",
                    "SELECT DISTINCT Layer FROM entities")
        for layer in ("WALLS", "DOORS", "ROOMS"):
            self.assertIn(f"Layer (String) = {layer}\n", table)

    def test_dxf_opens_in_ezdxf(self):
        try:
            import ezdxf
        except ImportError:
            self.skipTest("needs python3-ezdxf")
        drawing = ezdxf.readfile(self.folder / "floor_plan.dxf")
        self.assertEqual(drawing.audit().errors, [])
        self.assertEqual(drawing.header["$INSUNITS"], 6, "metres")
        outlines = [e for e in drawing.modelspace().query("LWPOLYLINE") if e.dxf.layer == "WALLS"]
        rings = [[(x, y, 0.0) for x, y in outline.get_points("xy")] for outline in outlines]
        solid = [ring for polygon in self.plan.polygons("solid") for ring in polygon]
        self.assertAlmostEqual(sum(map(area_of, rings)),
                               sum(area_of([(x, y, 0.0) for x, y in ring]) for ring in solid), 3)
        texts = {text.dxf.text for text in drawing.modelspace().query("TEXT")}
        self.assertTrue({"Room A", "25.5 m2"} <= texts, texts)

    def test_svg_is_xml_with_areas_and_a_scale(self):
        root = xml.parse(self.folder / "floor_plan.svg").getroot()
        texts = [text.text for text in root.iter(SVG + "text")]
        for words in ("25.5 m²", "5 m", "x", "y", "map"):
            self.assertIn(words, texts)
        self.assertGreater(sum(1 for _ in root.iter(SVG + "path")), 20)


class WithoutModules(unittest.TestCase):
    """A Python module that is missing costs its drawing, and nothing else."""

    def test_a_message_says_what_to_install(self):
        with tempfile.TemporaryDirectory() as folder:
            for script, module, package in (("floor_plan.py", "matplotlib", "python3-matplotlib"),
                                            ("floor_plan_dxf.py", "ezdxf", "python3-ezdxf")):
                (pathlib.Path(folder) / f"{module}.py").write_text("raise ImportError\n")
                done = subprocess.run(
                    ["/usr/bin/python3", f"{PROJECT}/eval/figures/{script}", folder],
                    env={"PYTHONPATH": folder}, text=True, capture_output=True)
                self.assertEqual(done.returncode, 1)
                self.assertIn(f"sudo apt install {package}", done.stderr)

    def test_wrong_formats_are_refused_with_the_list(self):
        done = subprocess.run([EXPERIMENT, "--mesh-formats", "glb,fbx"], text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("'fbx'", done.stderr)
        self.assertIn("glb, obj and stl", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
