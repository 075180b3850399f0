# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Nodes that a test starts itself, to read what they print."""
import signal
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

    def kill(self):
        """Kills the node: it can do nothing more."""
        self._process.kill()
        self._process.wait(PATIENCE)

    def interrupt(self):
        """Ends the node as roslaunch does, and waits until it has."""
        self._process.send_signal(signal.SIGINT)
        self._process.wait(PATIENCE)

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
