# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A laser that tilts in the middle of a room, for tests of the Python package."""
import numpy as np

import ribbon_mapper

BEAMS = 181
LASER = ribbon_mapper.Laser(angle_min_rad=-np.pi / 2, angle_increment_rad=np.pi / (BEAMS - 1),
                            time_increment_s=0.0, range_min_m=0.1, range_max_m=30.0)
PERIOD_NS = 25_000_000
STANDING = np.eye(4)
_LOW, _HIGH = np.array([-3.0, -2.5, 0.0]), np.array([3.0, 2.5, 2.5])


def T_base_laser(index):
    """Returns the pose of the laser at a line: it tilts from -1.2 to 1.2 rad within 120 lines."""
    tilt_rad = -1.2 + 0.02 * index
    c, s = np.cos(tilt_rad), np.sin(tilt_rad)
    return np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 1.2], [0, 0, 0, 1]])


def ranges_m(index):
    """Returns the ranges of a line."""
    angles = LASER.angle_min_rad + np.arange(BEAMS) * LASER.angle_increment_rad
    pose = T_base_laser(index)
    directions = np.stack([np.cos(angles), np.sin(angles), 0 * angles], -1) @ pose[:3, :3].T
    with np.errstate(divide="ignore"):
        walls = (np.where(directions > 0, _HIGH, _LOW) - pose[:3, 3]) / directions
    return np.abs(walls).min(axis=1)


def add_line(modeler, index, **changed):
    """Adds a line, with some arguments changed. Returns the result."""
    arguments = {"stamp_ns": 10**9 + index * PERIOD_NS, "ranges_m": ranges_m(index), "laser": LASER,
                 "T_odom_base": STANDING, "T_base_laser": T_base_laser(index)}
    return modeler.add_scan_line(**{**arguments, **changed})


def model(lines=120):
    """Returns a model of the room."""
    modeler = ribbon_mapper.Modeler()
    for index in range(lines):
        add_line(modeler, index)
    return modeler


def bytes_of(modeler, folder):
    """Returns the bytes of the model's file, which say all that it is."""
    path = folder / "model.ribbons"
    modeler.save(path)
    return path.read_bytes()
