# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the model as Python sees it: planes, corrections, files, presets and threads."""
import gc
import json
import pathlib
import sys
import tempfile
import threading
import unittest

import numpy as np

import ribbon_mapper
import small_room

PROJECT = pathlib.Path(__file__).resolve().parents[2]


class ModelerTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def bytes_of(self, modeler):
        return small_room.bytes_of(modeler, self.folder)


class Planes(ModelerTest):
    def test_planes_are_those_of_the_room(self):
        planes = small_room.model().planes()
        found = {tuple(np.round(plane.normal).astype(int)): plane.d_m for plane in planes}
        self.assertEqual(len(planes), len(found))
        for normal, d_m in [((-1, 0, 0), 3), ((0, 1, 0), 2.5), ((0, -1, 0), 2.5), ((0, 0, 1), 0),
                            ((0, 0, -1), 2.5)]:
            self.assertAlmostEqual(d_m, found[normal], 3)
        labels = {plane.label for plane in planes}
        self.assertLessEqual({"floor", "ceiling"}, labels)

    def test_numbers_of_a_plane_agree(self):
        for plane in small_room.model().planes():
            n, cells = plane.normal, plane.cells
            self.assertEqual(((3,), np.float64), (n.shape, n.dtype))
            np.testing.assert_allclose(n, np.cross(plane.axis_u, plane.axis_v), atol=1e-12)
            self.assertAlmostEqual(0.0, n @ plane.origin + plane.d_m, 9)
            self.assertAlmostEqual(plane.area_m2, len(cells) * plane.cell_size_m**2, 9)
            self.assertGreater(plane.ribbon_count, 0)
            self.assertTrue(0.0 <= plane.label_confidence <= 1.0)
            np.testing.assert_allclose(plane.covariance, plane.covariance.T, rtol=1e-9, atol=0)
            self.assertTrue((np.linalg.eigvalsh(plane.covariance) > 0).all())

    def test_cells(self):
        plane = small_room.model().planes()[0]
        cells, centres = plane.cells, plane.cell_centres
        self.assertEqual(("u", "v", "count", "mean_m", "variance_m2"), cells.dtype.names)
        np.testing.assert_array_equal(np.lexsort((cells["u"], cells["v"])), np.arange(len(cells)))
        self.assertGreater(cells["count"].min(), 0)
        s = plane.cell_size_m
        np.testing.assert_allclose(
            centres, plane.origin + s * ((cells["u"] + 0.5)[:, None] * plane.axis_u
                                         + (cells["v"] + 0.5)[:, None] * plane.axis_v), atol=1e-12)
        np.testing.assert_allclose(plane.centroid, centres.mean(axis=0), atol=1e-9)

    def test_cells_outlive_the_model(self):
        modeler = small_room.model()
        plane = modeler.planes()[0]
        cells = plane.cells
        self.assertIs(plane, cells.base)  # which keeps it alive
        del plane
        before = cells.copy()
        modeler.reset()
        del modeler
        gc.collect()
        small_room.model()
        np.testing.assert_array_equal(before, cells)
        with self.assertRaises(ValueError):
            cells["count"][0] = 1

    def test_outlines(self):
        for plane in small_room.model().planes():
            area_m2 = 0.0
            for outline in plane.outlines:
                for ring, sign in [(outline.outer, 1), *((hole, -1) for hole in outline.holes)]:
                    self.assertEqual(3, ring.shape[1])
                    np.testing.assert_allclose(ring @ plane.normal + plane.d_m, 0.0, atol=1e-9)
                    area = 0.5 * np.cross(ring, np.roll(ring, -1, 0)).sum(0) @ plane.normal
                    self.assertGreater(sign * area, 0.0)
                    area_m2 += area
            self.assertTrue(0.9 * plane.area_m2 < area_m2 <= 30.0 + 1e-6)  # stripes are closed

    def test_json_and_text(self):
        planes = small_room.model().planes()
        read = json.loads(ribbon_mapper.planes_to_json(planes, frame="kitchen"))
        self.assertEqual("kitchen", read["frame"])
        for plane, entry in zip(planes, read["planes"]):
            self.assertEqual([plane.id, plane.d_m, plane.label, plane.normal.tolist()],
                             [entry[key] for key in ["id", "d", "label", "normal"]])
            self.assertEqual([[outline.outer.tolist(), *(hole.tolist() for hole in outline.holes)]
                              for outline in plane.outlines], entry["outlines"])
            self.assertIn(f"Plane {plane.id}, {plane.label}: normal (", repr(plane))
        with self.assertRaises(TypeError):
            ribbon_mapper.planes_to_json([None])

    def test_as_built(self):
        modeler = small_room.model()
        self.assertGreater(len(modeler.planes_as_built()), 4)
        self.assertEqual([], modeler.planes_as_built()[0].outlines)


class Corrections(ModelerTest):
    SHIFT = np.array([[0, 0, 0, 1.0]] + 3 * [[0, 0, 0, 0]])

    def test_a_correction_moves_the_planes_and_keeps_ids(self):
        modeler = small_room.model()
        before = modeler.planes()
        stamps_ns, poses = modeler.trajectory()
        self.assertEqual((np.int64, (len(stamps_ns), 4, 4)), (stamps_ns.dtype, poses.shape))
        modeler.correct(stamps_ns, poses + self.SHIFT)
        self.assertEqual(1, modeler.statistics().revision)
        after = {plane.id: plane for plane in modeler.planes()}
        for plane in before:
            moved_d_m = plane.d_m - plane.normal[0]
            self.assertAlmostEqual(moved_d_m, after[plane.id].d_m, 5)
        np.testing.assert_allclose(modeler.trajectory()[1], poses + self.SHIFT, atol=1e-12)

    def test_types_of_a_trajectory_do_not_matter(self):
        results = set()
        stamps_ns, poses = small_room.model().trajectory()
        for stamps, matrices in [
                (stamps_ns, poses + self.SHIFT), (stamps_ns.tolist(), (poses + self.SHIFT).tolist()),
                (stamps_ns.astype(np.uint64)[::-1][::-1], np.asfortranarray(poses + self.SHIFT)),
                (stamps_ns, [[1, 0, 0, 0, 0, 0, 1]] * len(poses))]:
            modeler = small_room.model()
            modeler.correct(stamps, matrices)
            results.add(self.bytes_of(modeler))
        self.assertEqual(1, len(results))

    def test_a_bad_correction_leaves_the_model_as_it_was(self):
        modeler = small_room.model()
        stamps_ns, poses = modeler.trajectory()
        modeler.correct(stamps_ns, poses + self.SHIFT)
        before = self.bytes_of(modeler)
        broken = poses.copy()
        broken[3, 0, 0] = np.nan
        same = stamps_ns.copy()
        same[5] = same[4]
        for stamps, matrices, message in [
                ([], np.empty((0, 4, 4)), "trajectory is empty"), ([], [], "trajectory is empty"),
                (stamps_ns[::-1], poses, "stamps do not increase at pose 1"),
                (same, poses, "stamps do not increase at pose 5"),
                (stamps_ns, broken, "poses, pose 3, is not finite"),
                (stamps_ns, 1.1 * poses, "last row"),
                (stamps_ns[1:], poses, "but there are [0-9]+ stamps"),
                (stamps_ns + 10**15, poses, "is it of another run"),
                (stamps_ns * 1e-9, poses, r"whole nanoseconds \(int64\), not float64"),
                (stamps_ns[:, None], poses, "stamps_ns must be an array of one dimension"),
                (stamps_ns, poses[:, :3], r"poses must have the shape \(n, 4, 4\)"),
                (stamps_ns, poses[0], "poses must have the shape"), (stamps_ns, 1.0, "shape"),
                (stamps_ns, "poses", "numbers"), (None, None, "must be an array")]:
            with self.subTest(message), self.assertRaisesRegex(ValueError, message):
                modeler.correct(stamps, matrices)
            self.assertEqual(before, self.bytes_of(modeler))
        with self.assertRaisesRegex(ValueError, "."):
            ribbon_mapper.Modeler().correct(stamps_ns, poses)


class Files(ModelerTest):
    def test_a_session_goes_on_from_a_file(self):
        whole, half = small_room.model(), small_room.model(60)
        half.save(self.folder / "half.ribbons")
        again = ribbon_mapper.Modeler.load(str(self.folder / "half.ribbons"))
        for index in range(60, 120):
            small_room.add_line(again, index)
        self.assertEqual(self.bytes_of(whole), self.bytes_of(again))

    def test_a_file_with_another_preset(self):
        preset = self.folder / "other.yaml"
        preset.write_text("assembly: {min_area_m2: 7.0}\n")
        small_room.model().save(self.folder / "a.ribbons")
        ids = [plane.id for plane in small_room.model().planes() if plane.area_m2 > 7.0]
        again = ribbon_mapper.Modeler.load(self.folder / "a.ribbons", preset)
        self.assertEqual(ids, [plane.id for plane in again.planes()])
        self.assertLess(len(ids), len(small_room.model().planes()))

    def test_bad_files(self):
        path = self.folder / "a.ribbons"
        with self.assertRaisesRegex(ValueError, f"{path}"):
            ribbon_mapper.Modeler.load(path)
        path.write_bytes(self.bytes_of(small_room.model(20))[:-5])
        with self.assertRaisesRegex(ValueError, f"{path}"):
            ribbon_mapper.Modeler.load(path)
        with self.assertRaisesRegex(OSError, "no_folder"):
            small_room.model(5).save(self.folder / "no_folder" / "a.ribbons")
        with self.assertRaises(TypeError):
            ribbon_mapper.Modeler.load(3)

    def test_trajectories(self):
        stamps_ns, poses = small_room.model().trajectory()
        path = self.folder / "a.tum"
        path.write_text(ribbon_mapper.to_tum(stamps_ns, poses))
        read_ns, read = ribbon_mapper.read_tum(path)
        np.testing.assert_array_equal(stamps_ns, read_ns)
        np.testing.assert_allclose(poses, read, atol=1e-9)
        path.write_text("1.0 0 0 0 0 0 1\n")
        with self.assertRaisesRegex(ValueError, f"{path}, line 1: expected 8 finite numbers"):
            ribbon_mapper.read_tum(path)
        with self.assertRaisesRegex(ValueError, "cannot read .*b.tum"):
            ribbon_mapper.read_tum(self.folder / "b.tum")


class Presets(ModelerTest):
    def test_presets(self):
        for path in (PROJECT / "config").glob("*.yaml"):
            again = self.folder / path.name
            again.write_text(ribbon_mapper.Modeler(path).preset)
            self.assertEqual(again.read_text(), ribbon_mapper.Modeler(str(again)).preset)
        self.assertEqual(ribbon_mapper.Modeler().preset, ribbon_mapper.Modeler(preset=None).preset)
        again = self.folder / "one_key.yaml"
        again.write_text("scan: {range_sigma_m: 0.0625}\n")
        self.assertIn("range_sigma_m: 0.0625\n", ribbon_mapper.Modeler(again).preset)

    def test_bad_presets(self):
        path = self.folder / "bad.yaml"
        for text, message in [
                ("scan: {range_sigma: 1}", "unknown key scan.range_sigma; known are"),
                ("scan: {range_sigma_m: -1}", "scan.range_sigma_m"),
                ("scan: {range_sigma_m: often}", "scan.range_sigma_m must be a number"),
                ("[", ""), ("3", "sections with keys")]:
            path.write_text(text)
            with self.subTest(text), self.assertRaisesRegex(ValueError, f"^{path}: .*{message}"):
                ribbon_mapper.Modeler(path)
        with self.assertRaisesRegex(ValueError, "cannot be read: does the file exist"):
            ribbon_mapper.Modeler(self.folder / "none.yaml")
        with self.assertRaises(TypeError):
            ribbon_mapper.Modeler(3)


class Threads(ModelerTest):
    def test_threads_may_share_a_modeler(self):
        modeler, results = small_room.model(60), []

        def read():
            for _ in range(5):
                results.append((len(modeler.planes()), modeler.statistics().lines))

        threads = [threading.Thread(target=read) for _ in range(3)]
        for thread in threads:
            thread.start()
        for index in range(60, 120):
            small_room.add_line(modeler, index)
        for thread in threads:
            thread.join()
        self.assertEqual(15, len(results))
        self.assertEqual(self.bytes_of(small_room.model()), self.bytes_of(modeler))

    def test_other_threads_go_on_during_a_long_call(self):
        """The interpreter switches threads only where a thread gives up its lock."""
        interval = sys.getswitchinterval()
        sys.setswitchinterval(1000.0)
        self.addCleanup(sys.setswitchinterval, interval)
        modeler = small_room.model()
        stamps_ns, poses = modeler.trajectory()
        for call in [modeler.planes, modeler.planes_as_built,
                     lambda: modeler.correct(stamps_ns, poses)]:
            self.assertTrue(any(self.goes_on_during(call) for _ in range(1000)))
        self.assertFalse(any(self.goes_on_during(lambda: None) for _ in range(20)))

    def goes_on_during(self, call):
        """Returns whether this thread came between the begin and the end of another's call."""
        order, begun = [], threading.Lock()
        begun.acquire()

        def work():
            order.append("begin")
            begun.release()
            call()
            order.append("end")

        thread = threading.Thread(target=work)
        thread.start()
        begun.acquire()
        order.append("between")
        thread.join()
        return order == ["begin", "between", "end"]


if __name__ == "__main__":
    unittest.main()
