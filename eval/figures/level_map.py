# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a level laser's map from above: points, trajectory and closed loops.

Usage: python3 level_map.py DIRECTORY

Reads map_points.txt, trajectory.tum, loops.json and summary.json from DIRECTORY, as offline_slam
writes them, and writes level_map.png there.
"""

import json
import pathlib
import sys

import figure_files  # first: it chooses a backend without a display
import matplotlib.pyplot as plt
import numpy
from matplotlib.collections import LineCollection

WIDTH_IN = 10.0
MARGIN_M = 1.0


def load_table(path, columns):
    """Returns the numbers of a text file; empty without rows."""
    rows = [line.split()[:columns] for line in path.read_text(encoding="utf-8").splitlines()
            if line and not line.startswith("#")]
    return numpy.array(rows, float).reshape(-1, columns)


def loop_lines(loops, trajectory):
    """Returns the ends of each accepted loop [m]."""
    stamps = trajectory[:, 0]
    ends = []
    for loop in loops:
        if loop["accepted"]:
            rows = [min(int(numpy.searchsorted(stamps, loop[end] - 1e-4)), len(stamps) - 1)
                    for end in ("from", "to")]
            ends.append(trajectory[rows, 1:3])
    return ends


def draw(directory):
    points = load_table(directory / "map_points.txt", 2)
    trajectory = load_table(directory / "trajectory.tum", 3)
    loops = json.loads((directory / "loops.json").read_text(encoding="utf-8"))["loops"]
    summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
    everything = numpy.concatenate([points, trajectory[:, 1:3]])
    low, high = everything.min(axis=0) - MARGIN_M, everything.max(axis=0) + MARGIN_M
    ratio = min(3.0, max(0.2, (high - low)[1] / (high - low)[0]))
    figure, axes = plt.subplots(figsize=(WIDTH_IN, 1.0 + WIDTH_IN * ratio))
    axes.plot(*points.T, ",", color="black", zorder=1)
    axes.plot(*trajectory[:, 1:3].T, color="tab:blue", linewidth=0.5, zorder=2)
    axes.add_collection(LineCollection(loop_lines(loops, trajectory), colors="tab:red",
                                       linewidths=0.5, zorder=3))
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal", xlabel="x [m]",
             ylabel="y [m]")
    accepted = sum(loop["accepted"] for loop in loops)
    axes.set_title(f"{', '.join(summary['bags'])}: {summary['poses']} poses, "
                   f"{summary['way_m']:.0f} m, {accepted} loops")
    return figure


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: level_map.py DIRECTORY")
    directory = pathlib.Path(sys.argv[1])
    try:
        figure_files.save(draw(directory), directory / "level_map.png", dpi=150)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"level_map.py: {figure_files.words_of(error)}")


if __name__ == "__main__":
    main()
