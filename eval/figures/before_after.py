# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws top views of a model before and after the correction of its trajectory, to scale.

Level planes are projected on the ground, as in figure 8 of the paper. Upright ones are cut between
the floor and the lintels, so that doors are open. Slopes are hatched.

Usage: python3 before_after.py DIRECTORY

Reads planes_noisy.json, planes_after.json, summary.json, figure.json and trajectory_*.tum
from DIRECTORY, as the experiment writes them, and writes before_after.svg and before_after.png
there.
"""

import json

from figure_files import counted, draw_as, matplotlib
from outlines import area_of, rings, sections

import matplotlib.pyplot as plt  # noqa: E402 (needs the backend)
from matplotlib.collections import LineCollection  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Patch, PathPatch  # noqa: E402

WIDTH_IN = 8.0
TITLES_IN, LEGEND_IN = 0.68, 0.34
MARGIN_M = 0.3
WALL_MAX_NORMAL_Z = 0.5  # planes steeper than 60 degrees are drawn as lines
LEVEL_MIN_NORMAL_Z = 0.985  # planes steeper than 10 degrees are slopes
CUTS_M = [0.1 * i for i in range(1, 20)]  # heights above the floor at which upright planes are cut
FLOOR_MIN_AREA_M2 = 10.0  # level planes from this area on are floors or ceilings
MAX_LIGHT = 0.62  # greatest lightness of a colour on white paper
STROKE_PT = 1.5  # thin enough to distinguish both sides of a wall
WORLD = {"color": "0.7", "linewidth": 0.5}
FLOOR = (0.5, 0.5, 0.5, 0.07)
ESTIMATED = {"color": "tab:red", "linewidth": 1.0}
TRUE = {"color": "black", "linewidth": 0.8, "linestyle": (0, (4, 3))}


def load_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


def load_trajectory(path):
    """Returns x and y of the poses in a TUM file [m]."""
    rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()
            if line.strip() and not line.startswith("#")]
    return [float(row[1]) for row in rows], [float(row[2]) for row in rows]


def on_ground(plane):
    return [(x, y) for ring in rings(plane) for x, y, _ in ring]


def floor_of(planes):
    """Returns the height of the largest level plane that is seen from above [m], or 0."""
    floors = [p for p in planes if p["normal"][2] > LEVEL_MIN_NORMAL_Z]
    return max(floors, key=lambda p: p["area"])["centroid"][2] if floors else 0.0


def on_paper(colour):
    """Returns the colour, darkened if it is too light for a thin line."""
    red, green, blue = matplotlib.colors.to_rgb(colour)
    light = 0.30 * red + 0.59 * green + 0.11 * blue
    return tuple(c * min(1.0, MAX_LIGHT / max(light, 1e-6)) for c in (red, green, blue))


def draw_areas(axes, planes, colour_of):
    """Draws floors faintly, slopes hatched and table tops as areas, smaller ones over larger."""
    for plane in sorted(planes, key=lambda p: -p["area"]):
        is_slope = abs(plane["normal"][2]) < LEVEL_MIN_NORMAL_Z
        is_floor = plane["area"] > FLOOR_MIN_AREA_M2 and not is_slope
        colour = colour_of(plane)
        axes.add_patch(PathPatch(
            area_of(plane), facecolor=FLOOR if is_floor else (*colour, 0.28),
            edgecolor="none" if is_floor else colour, linewidth=0.7, zorder=1,
            hatch="////" if is_slope else None))


def is_steep(plane):
    return abs(plane["normal"][2]) <= WALL_MAX_NORMAL_Z


def draw_planes(axes, planes, colour_of):
    planes = [plane for plane in planes if plane["outlines"]]
    draw_areas(axes, [p for p in planes if not is_steep(p)], colour_of)
    floor_m = floor_of(planes)
    for plane in filter(is_steep, planes):
        # One that begins above the lintels, such as a high window's, is drawn where it is.
        pieces = sections(plane, [floor_m + z for z in CUTS_M]) \
            or sections(plane, [plane["centroid"][2]])
        axes.add_collection(LineCollection(pieces, colors=[colour_of(plane)],
                                           linewidths=STROKE_PT, zorder=3))


def draw_world(axes, outlines):
    axes.add_collection(LineCollection(outlines, zorder=2, colors=WORLD["color"],
                                       linewidths=WORLD["linewidth"]))


def draw_trajectories(axes, estimate, truth):
    axes.plot(*estimate, zorder=4, **ESTIMATED)
    axes.plot(*truth, zorder=5, **TRUE)
    if truth[0]:
        axes.plot(truth[0][0], truth[1][0], "o", color="black", markersize=3.5, zorder=6)


def draw_scale_bar(axes, box):
    """Draws a bar of a round length, about a fifth of the width, at the lower left."""
    width = box[1] - box[0]
    length = max((n for n in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50) if n <= 0.2 * width), default=0.1)
    x, y = box[0] + MARGIN_M, box[2] + 0.022 * width
    axes.plot([x, x + length], [y, y], color="black", linewidth=1.8, solid_capstyle="butt",
              zorder=7)
    axes.text(x + length + 0.012 * width, y, f"{length:g} m", va="center", zorder=7)


def box_around(outlines, *plane_lists):
    """Returns (x_min, x_max, y_min, y_max) of everything with the scale bar [m]."""
    points = [point for outline in outlines for point in outline]
    points += [point for planes in plane_lists for p in planes for point in on_ground(p)]
    xs, ys = zip(*points) if points else ((0, 1), (0, 1))
    below = MARGIN_M + 0.04 * (max(xs) - min(xs))
    return min(xs) - MARGIN_M, max(xs) + MARGIN_M, min(ys) - below, max(ys) + MARGIN_M


def add_legend(figure):
    handles = [
        Line2D([], [], color="tab:purple", linewidth=STROKE_PT, label="upright plane"),
        Patch(facecolor=(0.58, 0.40, 0.74, 0.3), edgecolor="tab:purple", linewidth=0.7,
              label="level plane"),
        Line2D([], [], label="world", **WORLD),
        Line2D([], [], label="estimated trajectory", **ESTIMATED),
        Line2D([], [], label="true trajectory", **TRUE),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=len(handles), frameon=False,
                  handlelength=2.0, columnspacing=1.6, borderaxespad=0.3)


def findings(metrics, truth):
    return (f"{metrics['matched']} of {counted(truth, 'true plane', 'true planes')} found, "
            f"{counted(metrics['duplicates'], 'duplicate', 'duplicates')}, "
            f"{metrics['extra']} extra")


def titles_of(summary):
    """Returns the title and the text below it for each panel."""
    models, truth = summary["four_models"], summary["truth_planes"]
    as_built, before, after = models["noisy_as_built"], models["noisy"], models["corrected"]
    return [(f"Before the correction: {counted(before['planes'], 'plane', 'planes')}",
             f"final planes; as built during the tour: {as_built['planes']}\n"
             f"{findings(before, truth)}"),
            (f"After the correction: {counted(after['planes'], 'plane', 'planes')}",
             f"final planes; truth: {truth}\n{findings(after, truth)}")]


def figure_height(box):
    panel_in = 0.5 * WIDTH_IN * (box[3] - box[2]) / (box[1] - box[0])
    return min(10.0, panel_in) + TITLES_IN + LEGEND_IN


def new_panels(box):
    height = figure_height(box)
    figure, panels = plt.subplots(1, 2, figsize=(WIDTH_IN, height))
    figure.subplots_adjust(left=0.0, right=1.0, wspace=0.0, bottom=LEGEND_IN / height,
                           top=1.0 - TITLES_IN / height)
    for axes in panels:
        axes.set(xlim=box[:2], ylim=box[2:], aspect="equal")
        axes.set_axis_off()
    return figure, panels


def set_title(axes, title, text):
    axes.annotate(text, (0.5, 1.0), (0, 3), xycoords="axes fraction", textcoords="offset points",
                  ha="center", va="bottom", linespacing=1.3)
    axes.annotate(title, (0.5, 1.0), (0, 30), xycoords="axes fraction",
                  textcoords="offset points", ha="center", va="bottom", fontsize=11,
                  fontweight="bold")


def draw(directory):
    data = load_json(directory / "figure.json")
    planes = [load_json(directory / f"planes_{when}.json")["planes"]
              for when in ("noisy", "after")]
    before, after, truth = (load_trajectory(directory / f"trajectory_{which}.tum")
                            for which in ("before", "after", "truth"))
    titles = titles_of(load_json(directory / "summary.json"))

    def colour_of(plane):
        return on_paper(data["colours"].get(str(plane["id"]), "0.3"))

    box = box_around(data["world_outlines"], *planes)
    figure, panels = new_panels(box)
    for axes, title, model, estimate in zip(panels, titles, planes, (before, after)):
        draw_world(axes, data["world_outlines"])
        draw_planes(axes, model, colour_of)
        draw_trajectories(axes, estimate, truth)
        set_title(axes, *title)
    draw_scale_bar(panels[0], box)
    add_legend(figure)
    return figure


if __name__ == "__main__":
    draw_as("before_after", draw)
