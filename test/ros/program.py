# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Nodes that a test starts itself, to read what they print."""
import subprocess
import tempfile

import roslib.packages

from waiting import PATIENCE


def path_of(program):
    return roslib.packages.find_node('ribbon_mapper', program)[0]


class Program:
    """A running node; `name` is its name in the graph."""

    def __init__(self, program, name, *arguments):
        self._output = tempfile.TemporaryFile('w+')
        self._process = subprocess.Popen([path_of(program), '__name:=' + name] + list(arguments),
                                         stdout=self._output, stderr=subprocess.STDOUT)

    def stop(self):
        """Ends the node and returns what it has printed."""
        self._process.terminate()
        try:
            self._process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.kill()
            raise
        self._output.seek(0)
        return self._output.read()
