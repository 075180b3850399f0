# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds what tools/house_table counts, on a project of two rooms and on this one."""
import importlib.machinery
import importlib.util
import pathlib
import unittest

import planted

PROJECT = pathlib.Path(__file__).resolve().parents[2]
LOADER = importlib.machinery.SourceFileLoader("house_table", str(PROJECT / "tools/house_table"))
house_table = importlib.util.module_from_spec(
    importlib.util.spec_from_loader("house_table", LOADER))
LOADER.exec_module(house_table)


class Table(planted.PlantedProject):
    def setUp(self):
        super().setUp()
        self.plant("sim/world/wall.hpp", "/// A wall.\nstruct Wall {\n  int a;\n};\n")
        self.plant("sim/world/wall.cpp", "// A comment.\nint f() {\n  return 1;\n}\n\nint g();\n")
        self.plant("sim/tour/tour.hpp", "/// Drives.\nint drive();\n")
        self.plant("test/sim/wall_test.cpp", '#include "sim/tour/tour.hpp"\n'
                   '#include "sim/world/wall.hpp"\nint a;\nint b;\n')
        self.plant("test/sim/route_test.cpp", '#include "sim/tour/tour.hpp"\n')
        self.plant("test/ros/node_test.py", "print()\n")

    def row(self, name):
        rows, _ = house_table.table(self.root)
        return dict(zip(house_table.COLUMNS, next(row for row in rows if row[0].startswith(name))))

    def test_a_room(self):
        self.assertEqual({
            "room": "sim/world", "files": 2, "lines": 10, "file median": 5, "file max": 6,
            "functions": 1, "function median": 3, "function max": 3, "over 40": 0,
            "declarations": 2, "documented %": "50%", "tests / code": "0.57"},
            self.row("sim/world"))

    def test_a_test_without_a_namesake_belongs_to_what_it_includes(self):
        self.assertEqual("1.00", self.row("sim/tour")["tests / code"])

    def test_all(self):
        row = self.row("**all**")
        self.assertEqual((3, 12, "67%", "0.75"), (
            row["files"], row["lines"], row["documented %"], row["tests / code"]))

    def test_a_long_function_counts(self):
        self.plant("sim/tour/long.cpp", "int f() {\n" + "  ++a;\n" * 39 + "}\n")
        self.assertEqual(1, self.row("sim/tour")["over 40"])


class House(unittest.TestCase):
    """What the table says of this project."""

    def test_no_function_is_longer_than_a_page(self):
        rows, _ = house_table.table(PROJECT)
        rows = [dict(zip(house_table.COLUMNS, row)) for row in rows]
        self.assertEqual([], [row["room"] for row in rows if row["over 40"]])


if __name__ == "__main__":
    unittest.main()
