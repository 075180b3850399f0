# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds what `pip install .` knows of the package before it compiles it."""
import email
import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[2]


@unittest.skipUnless(importlib.util.find_spec("setuptools") and importlib.util.find_spec("wheel"),
                     "apt-get install python3-setuptools python3-wheel")
class Wheel(unittest.TestCase):
    def test_metadata(self):
        backend = dict(re.findall(r'^(build-backend|backend-path) = \W*([\w.]+)',
                                  (PROJECT / "pyproject.toml").read_text(), re.M))
        code = ("import importlib, sys\n"
                "backend = importlib.import_module(sys.argv[1])\n"
                "backend.prepare_metadata_for_build_wheel(sys.argv[2])\n")
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-c", code, backend["build-backend"], folder],
                           cwd=PROJECT, check=True, stdout=subprocess.DEVNULL,
                           env={"PYTHONPATH": backend["backend-path"]})
            text = next(pathlib.Path(folder).glob("*.dist-info/METADATA")).read_text()
        metadata = email.message_from_string(text)
        self.assertEqual("ribbon-mapper", metadata["Name"].replace("_", "-"))
        self.assertIn(f"<version>{metadata['Version']}</version>",
                      (PROJECT / "package.xml").read_text())
        self.assertEqual("numpy", metadata["Requires-Dist"])


if __name__ == "__main__":
    unittest.main()
