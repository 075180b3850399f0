# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the scan lines that test/python/lines_file.hpp writes."""
import collections

import numpy as np

import ribbon_mapper

Line = collections.namedtuple("Line", "stamp_ns ranges_m laser T_odom_base T_base_laser T_map_base")

_HEAD = np.dtype([("stamp_ns", "=i8"), ("laser", "=f8", 5), ("poses", "=f8", (5, 4, 4)),
                  ("beams", "=i8")])
_LASER = ["angle_min_rad", "angle_increment_rad", "time_increment_s", "range_min_m", "range_max_m"]


def read(path):
    """Returns all lines of a file."""
    data, lines, at = path.read_bytes(), [], 0
    while at < len(data):
        head = np.frombuffer(data, _HEAD, 1, at)[0]
        ranges_m = np.frombuffer(data, "=f4", int(head["beams"]), at + _HEAD.itemsize)
        at += _HEAD.itemsize + ranges_m.nbytes
        laser = ribbon_mapper.Laser(**dict(zip(_LASER, head["laser"].tolist())))
        poses = head["poses"]
        lines.append(Line(int(head["stamp_ns"]), ranges_m, laser, poses[:2], poses[2:4], poses[4]))
    return lines


def add(lines, modeler):
    """Adds lines to a modeler. Returns it."""
    for line in lines:
        modeler.add_scan_line(*line)
    return modeler
