# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds which arguments of a scan line are taken, which are refused, and that nothing is left of
those that are."""
import pathlib
import tempfile
import unittest

import numpy as np

import ribbon_mapper
import small_room
from small_room import BEAMS, LASER, STANDING, add_line


def quaternion_pose(matrix):
    """Returns x, y, z, qx, qy, qz, qw of a pose that turns about y only."""
    half = 0.5 * np.arctan2(matrix[0, 2], matrix[0, 0])
    return [*matrix[:3, 3], 0.0, np.sin(half), 0.0, np.cos(half)]


class Test(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def bytes_with(self, **changed):
        """Returns the bytes of a model of 40 lines, whose arguments are made from the usual ones."""
        modeler = ribbon_mapper.Modeler()
        for index in range(40):
            usual = {"ranges_m": small_room.ranges_m(index).astype(np.float32),
                     "T_base_laser": small_room.T_base_laser(index), "T_odom_base": STANDING}
            add_line(modeler, index, **{**usual, **{k: f(usual[k]) for k, f in changed.items()}})
        self.assertGreater(modeler.statistics().ribbons, 0)
        return small_room.bytes_of(modeler, self.folder)

    def assert_refused(self, message, **changed):
        modeler = small_room.model(10)
        before = small_room.bytes_of(modeler, self.folder)
        with self.assertRaisesRegex(ValueError, message):
            add_line(modeler, 10, **changed)
        self.assertEqual(before, small_room.bytes_of(modeler, self.folder))
        self.assertEqual(10, modeler.statistics().lines)

    def test_layouts_and_types_of_ranges_do_not_matter(self):
        expected = self.bytes_with()
        for name, change in [
                ("float64", lambda r: r.astype(np.float64)),
                ("every second one", lambda r: np.repeat(r, 2)[::2]),
                ("backwards", lambda r: r[::-1].copy()[::-1]),
                ("a column", lambda r: np.stack([r, r], -1)[:, 1]),
                ("big endian", lambda r: r.astype(">f4")),
                ("not writeable", lambda r: np.frombuffer(r.tobytes(), np.float32)),
                ("a list", list), ("a tuple", tuple)]:
            with self.subTest(name):
                self.assertEqual(expected, self.bytes_with(ranges_m=change))

    def test_layouts_of_poses_do_not_matter(self):
        expected = self.bytes_with()
        for name, change in [
                ("columns first", np.asfortranarray), ("lists", lambda p: p.tolist()),
                ("a part of another", lambda p: np.pad(p, 2)[2:-2, 2:-2]),
                ("first and last", lambda p: [p, p])]:
            with self.subTest(name):
                self.assertEqual(expected, self.bytes_with(T_base_laser=change, T_odom_base=change))
        self.assertEqual(expected, self.bytes_with(T_odom_base=lambda p: p.astype(int)))
        self.assertEqual(expected, self.bytes_with(T_odom_base=lambda p: [0, 0, 0, 0, 0, 0, 1]))

    def test_a_pose_may_be_a_vector(self):
        modeler = ribbon_mapper.Modeler()
        for index in range(120):
            pose = small_room.T_base_laser(index)
            add_line(modeler, index, T_base_laser=quaternion_pose(pose), T_odom_base=2 * [
                [0, 0, 0, 0, 0, 0, -1]])
        expected = [plane.normal for plane in small_room.model().planes()]
        np.testing.assert_allclose([plane.normal for plane in modeler.planes()], expected,
                                   atol=1e-9)

    def test_first_and_last_pose_are_kept_apart(self):
        moved = STANDING + np.array([[0, 0, 0, 0.1]] + 3 * [[0, 0, 0, 0]])
        forth = self.bytes_with(T_odom_base=lambda p: [p, moved])
        back = self.bytes_with(T_odom_base=lambda p: [moved, p])
        self.assertEqual(3, len({forth, back, self.bytes_with()}))  # the order: same_bytes_test.py

    def test_map_is_odom_unless_a_pose_in_map_is_given(self):
        moved = STANDING + np.array([[0, 0, 0, 0.1]] + 3 * [[0, 0, 0, 0]])
        modeler = ribbon_mapper.Modeler()
        for index in range(20):
            add_line(modeler, index, T_odom_base=[STANDING, moved])
        np.testing.assert_allclose(modeler.trajectory()[1][:, 0, 3], 0.05, atol=1e-12)
        modeler = ribbon_mapper.Modeler()
        for index in range(20):
            add_line(modeler, index, T_map_base=moved)
        np.testing.assert_array_equal(modeler.trajectory()[1][:, 0, 3], 0.1)

    def test_nan_and_inf_are_no_returns(self):
        for value in [np.nan, np.inf, -np.inf, 0.0, 31.0]:
            ranges_m = small_room.ranges_m(0)
            ranges_m[:] = value
            result = add_line(ribbon_mapper.Modeler(), 0, ranges_m=ranges_m)
            self.assertEqual(ribbon_mapper.LineResult.no_returns, result)
        result = add_line(ribbon_mapper.Modeler(), 0, ranges_m=[])
        self.assertEqual(ribbon_mapper.LineResult.no_returns, result)
        ranges_m = small_room.ranges_m(0)
        ranges_m[::2] = np.nan
        result = add_line(ribbon_mapper.Modeler(), 0, ranges_m=ranges_m)
        self.assertEqual(ribbon_mapper.LineResult.waiting, result)

    def test_what_became_of_a_line(self):
        results = [add_line(modeler, index) for modeler in [ribbon_mapper.Modeler()]
                   for index in range(40)]
        self.assertEqual("waiting", results[0].name)
        self.assertIn(ribbon_mapper.LineResult.modelled, results)
        modeler = small_room.model(10)
        self.assertEqual("too_close", add_line(modeler, 10, T_base_laser=small_room.T_base_laser(
            9)).name)
        before = small_room.bytes_of(small_room.model(10), self.folder)
        modeler = small_room.model(10)
        for index in [9, 3]:
            self.assertEqual("out_of_order", add_line(modeler, index).name)
        self.assertEqual(12, modeler.statistics().lines)  # the file counts them, too
        self.assertEqual(len(before), len(small_room.bytes_of(modeler, self.folder)))

    def test_wrong_ranges(self):
        self.assert_refused(r"ranges_m must have the shape \(n,\), not \(2, 181\)",
                            ranges_m=np.ones((2, BEAMS)))
        self.assert_refused(r"ranges_m must have the shape \(n,\), not \(\)", ranges_m=3.0)
        self.assert_refused("ranges_m must be an array of numbers, not of <U1", ranges_m=["a"])
        self.assert_refused("ranges_m must be an array of numbers, not of bool", ranges_m=[True])
        self.assert_refused("ranges_m must be an array of numbers, not of complex128",
                            ranges_m=[1j])
        self.assert_refused("ranges_m must be an array of numbers", ranges_m=None)
        self.assert_refused("more ranges than angle_increment allows", ranges_m=np.ones(1000))

    def test_wrong_poses(self):
        mirrored, not_finite, row = np.diag([1.0, 1, -1, 1]), np.eye(4), np.eye(4)
        not_finite[0, 3], row[3, 0] = np.nan, 0.5
        for name in ["T_odom_base", "T_base_laser", "T_map_base"]:
            for pose, message in [
                    (mirrored, "is not rigid"), (2 * np.eye(4), "last row"),
                    (np.diag([2.0, 2, 2, 1]), "is not rigid"), (row, "last row"),
                    (not_finite, "is not finite"), (np.full(7, np.nan), "is not finite"),
                    (np.zeros(7), "unit length"), ([1e10, 0, 0, 0, 0, 0, 1], "1e9 m"),
                    (np.eye(3), r"must have the shape \(4, 4\), or \(7,\).*not \(3, 3\)"),
                    (np.zeros((3, 4, 4)), "must have the shape"), ("x", "of numbers, not of <U1")]:
                with self.subTest(name=name, message=message):
                    self.assert_refused(f"^{name} .*{message}", **{name: pose})
        self.assert_refused("T_odom_base, pose 1, is not finite", T_odom_base=[STANDING, not_finite])
        self.assert_refused("must have the shape", T_map_base=[STANDING, STANDING])
        far = STANDING + np.array([[0, 0, 0, 200]] + 3 * [[0, 0, 0, 0]])
        self.assert_refused("odometry jumps by more than 100 m", T_odom_base=[STANDING, far])

    def test_wrong_stamps(self):
        self.assert_refused(r"stamp_ns must be an int of nanoseconds, not .*float.*seconds \* 1e9",
                            stamp_ns=2.5)
        self.assert_refused("stamp_ns is too large", stamp_ns=2**63)
        self.assert_refused("stamp_ns must be an int", stamp_ns=None)
        self.assertEqual("waiting", add_line(ribbon_mapper.Modeler(), 0, stamp_ns=np.int32(7)).name)

    def test_wrong_lasers(self):
        good = {name: getattr(LASER, name) for name in dir(LASER) if not name.startswith("_")}
        self.assertEqual(repr(LASER), repr(ribbon_mapper.Laser(**good)))
        for changed, message in [
                ({"angle_min_rad": np.nan}, "angles are not finite"),
                ({"angle_increment_rad": 0.0}, "angle_increment is 0"),
                ({"time_increment_s": np.inf}, "time_increment is not finite"),
                ({"range_max_m": 0.05}, "0 <= range_min < range_max"),
                ({"range_min_m": -1.0}, "0 <= range_min < range_max")]:
            with self.subTest(changed), self.assertRaisesRegex(ValueError, message):
                ribbon_mapper.Laser(**{**good, **changed})
        with self.assertRaises(AttributeError):
            LASER.range_min_m = 1.0


if __name__ == "__main__":
    unittest.main()
