# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scratch project for tests that plant a defect and see that a check finds it."""
import pathlib
import tempfile
import unittest


class PlantedProject(unittest.TestCase):
    HEAD = ""  # what each planted file begins with

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def plant(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(self.HEAD + text)
        return path
