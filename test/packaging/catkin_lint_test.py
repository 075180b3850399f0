#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""catkin_lint finds no error in the package. Skipped where it is not installed."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PARTS = ['CMakeLists.txt', 'LICENSE', 'bench', 'cmake', 'config', 'eval', 'examples', 'launch',
         'modeler', 'msg', 'package.xml', 'rviz', 'sim', 'slam', 'srv', 'test', 'urdf', 'worlds']


def lint(folder):
    """Returns what catkin_lint says of a package, errors only. Its rules are those of Debian."""
    env = {**os.environ, 'ROS_DISTRO': 'Debian', 'ROS_PACKAGE_PATH': '/usr/share'}
    result = subprocess.run(['catkin_lint', '--severity-level', '0', '--offline', str(folder)],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=env)
    return result.returncode, result.stdout


class CatkinLint(unittest.TestCase):
    def test_no_error(self):
        code, text = lint(PROJECT)
        self.assertEqual(code, 0, text)
        self.assertIn('checked 1 packages', text)
        self.assertNotIn('cannot lint', text)

    def test_an_error_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / 'ribbon_mapper'
            copy.mkdir()
            for part in PARTS:
                (copy / part).symlink_to(PROJECT / part)
            text = (PROJECT / 'package.xml').read_text()
            (copy / 'package.xml').unlink()
            (copy / 'package.xml').write_text(text.replace('<depend>geometry_msgs</depend>', ''))
            code, text = lint(copy)
            self.assertEqual(code, 1, text)
            self.assertIn("missing build_depend on 'geometry_msgs'", text)


if __name__ == '__main__':
    if not shutil.which('catkin_lint'):
        sys.stderr.write('skipped: missing catkin-lint (./install_dependencies test)\n')
        sys.exit(77)
    unittest.main()
