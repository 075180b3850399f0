# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what an estimate of the trajectory makes of odometry: from above, and as errors over time.

Usage: python3 estimate.py DIRECTORY

Reads what `experiment --closure self --output DIRECTORY` writes, and writes estimate.svg and
estimate.png there.
"""

import bisect
import csv
import math

from before_after import (TRUE, box_around, draw_planes, draw_scale_bar, draw_world, load_json,
                          load_trajectory, set_title)
from figure_files import draw_as

import matplotlib.pyplot as plt  # noqa: E402 (needs the backend)

WIDTH_IN, HEIGHT_IN = 8.0, 3.5
ODOMETRY = {"color": "tab:red", "linewidth": 1.0}
ESTIMATE = {"color": "tab:blue", "linewidth": 0.7}
LIVE = {"color": "tab:orange", "linewidth": 0.7}
GREY = (0.45, 0.45, 0.45)


def timed(path):
    """Returns the poses of a TUM file as (stamp [s], x [m], y [m])."""
    rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()
            if line.strip() and not line.startswith("#")]
    return [tuple(float(value) for value in row[:3]) for row in rows]


def errors_m(trajectory, truth):
    """Returns the distances from the true positions at the same stamps."""
    stamps = [pose[0] for pose in truth]
    errors = []
    for stamp, x, y in trajectory:
        true = truth[min(bisect.bisect_left(stamps, stamp), len(truth) - 1)]
        errors.append(math.hypot(x - true[1], y - true[2]))
    return errors


def stated_sigmas_m(path):
    """Returns the standard deviations of the positions in the plane, as estimated."""
    with open(path, encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [math.sqrt(float(row["x_x"]) + float(row["y_y"])) for row in rows]


def draw_map(axes, directory):
    data, planes = load_json(directory / "figure.json"), load_json(directory / "planes_after.json")
    before, after, truth = (load_trajectory(directory / f"trajectory_{which}.tum")
                            for which in ("before", "after", "truth"))
    box = box_around(data["world_outlines"], planes["planes"])
    axes.set(xlim=box[:2], ylim=box[2:], aspect="equal")
    axes.set_axis_off()
    draw_world(axes, data["world_outlines"])
    draw_planes(axes, planes["planes"], lambda plane: GREY)
    axes.plot(*before, zorder=4, label="odometry", **ODOMETRY)
    axes.plot(*after, zorder=5, label="estimate", **ESTIMATE)
    axes.plot(*truth, zorder=6, label="truth", **TRUE)
    axes.plot(truth[0][0], truth[1][0], "o", color="black", markersize=3.5, zorder=7)
    draw_scale_bar(axes, box)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=3, frameon=False)


def draw_errors(axes, directory):
    truth = timed(directory / "trajectory_truth.tum")
    for name, label, style in [("before", "odometry", ODOMETRY),
                               ("live", "estimate, live", LIVE),
                               ("after", "estimate, in the end", ESTIMATE)]:
        trajectory = timed(directory / f"trajectory_{name}.tum")
        seconds = [pose[0] - trajectory[0][0] for pose in trajectory]
        errors = [100 * error for error in errors_m(trajectory, truth)]
        axes.plot(seconds, errors, label=label, **style)
    sigmas = [100 * sigma for sigma in stated_sigmas_m(directory / "trajectory_covariance.csv")]
    axes.plot(seconds, sigmas, color="tab:blue", linewidth=0.8, linestyle=":",
              label="standard deviation, as stated")
    axes.set(yscale="log", ylim=(0.1, 500), xlim=(0, seconds[-1]), xlabel="time [s]",
             ylabel="error of the position [cm]")
    axes.grid(True, linewidth=0.3)
    axes.yaxis.set_major_formatter("{x:g}")
    axes.legend(loc="center right", bbox_to_anchor=(1.0, 0.62), frameon=False)


def draw(directory):
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH_IN, HEIGHT_IN),
                                         gridspec_kw={"width_ratios": [1.15, 1]})
    figure.subplots_adjust(left=0.01, right=0.98, bottom=0.14, top=0.82, wspace=0.16)
    draw_map(left, directory)
    draw_errors(right, directory)
    estimate = load_json(directory / "summary.json")["estimate"]
    set_title(left, "Odometry, estimate and truth", "walls of the model by the estimate")
    set_title(right, f"{100 * estimate['rmse_m']:.1f} cm RMS",
              f"{estimate['rmse_deg']:.2f} degrees RMS in heading")
    return figure


if __name__ == "__main__":
    draw_as("estimate", draw)
