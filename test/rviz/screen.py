# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A screen of its own for a program with windows, by Xvfb."""
import os
import pathlib
import subprocess
import tempfile

import numpy

HEADER_WORDS = 25  # of an XWD file, version 7; all of them big-endian


class Screen:
    """An X server without a screen. `environment` is what its programs need."""

    def __init__(self, width=1280, height=800):
        self._folder = tempfile.TemporaryDirectory(prefix='screen_')
        reader, writer = os.pipe()
        self._server = subprocess.Popen(
            ['Xvfb', '-displayfd', str(writer), '-screen', '0', f'{width}x{height}x24',
             '-nolisten', 'tcp', '-fbdir', self._folder.name],
            pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as pipe:
            number = pipe.readline().strip()  # written as soon as the server is ready
        if not number:
            raise RuntimeError('Xvfb does not start')
        # Programs find no configuration of a user, and no graphics card.
        self.environment = dict(os.environ, DISPLAY=':' + number, HOME=self._folder.name,
                                XDG_RUNTIME_DIR=self._folder.name, LIBGL_ALWAYS_SOFTWARE='1')

    def close(self):
        self._server.terminate()
        self._server.wait()
        self._folder.cleanup()

    def picture(self):
        """Returns what is seen: rows of pixels, each red, green and blue."""
        data = (pathlib.Path(self._folder.name) / 'Xvfb_screen0').read_bytes()
        words = numpy.frombuffer(data, '>u4', HEADER_WORDS)
        header_bytes, width, height, row_bytes, colours = (int(words[i]) for i in (0, 4, 5, 12, 19))
        begin = header_bytes + 12 * colours
        rows = numpy.frombuffer(data, 'u1', row_bytes * height, begin).reshape(height, -1, 4)
        return rows[:, :width, 2::-1].astype(int)

    def save(self):
        """Writes what is seen, for whoever looks into a failure. Returns the path."""
        import matplotlib.image
        handle, path = tempfile.mkstemp(suffix='.png')
        os.close(handle)
        matplotlib.image.imsave(path, self.picture().astype('uint8'))
        return path


def count(picture, colour, tolerance=2):
    """Returns the number of pixels with a colour."""
    return int((abs(picture - numpy.array(colour)).max(axis=2) <= tolerance).sum())
