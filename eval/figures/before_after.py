# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Top view of a model before and after the correction of its trajectory, to scale, as figure 8 of
the paper: planes projected on the ground.

Usage: python3 before_after.py DIRECTORY

Reads planes_before.json, planes_after.json, summary.json, figure.json and trajectory_*.tum from
DIRECTORY, as the experiment writes them, and writes before_after.svg and before_after.png there.
"""

import json
import os
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (needs the backend)
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Patch  # noqa: E402

WALL_MAX_NORMAL_Z = 0.5  # steeper than 60 degrees: shown as its projection's edge, a line
OUTLINE_STYLE = {"colors": "0.55", "linewidths": 0.5}
MARGIN_M = 0.6

plt.rcParams.update({
    "font.size": 9,
    "axes.titlesize": 10,
    "svg.hashsalt": "ribbon_mapper",  # the same run gives the same bytes
    "svg.fonttype": "none",
})


def load_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


def load_trajectory(path):
    """x and y of a TUM file [m]."""
    rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()
            if line.strip() and not line.startswith("#")]
    return [float(row[1]) for row in rows], [float(row[2]) for row in rows]


def ground_polygon(plane):
    return [(x, y) for x, y, _ in plane["outline"]]


def draw_planes(axes, planes, colour_of):
    """Steep planes as thick lines, the others as faint areas beneath them."""
    flat = [p for p in planes if abs(p["normal"][2]) > WALL_MAX_NORMAL_Z]
    steep = [p for p in planes if abs(p["normal"][2]) <= WALL_MAX_NORMAL_Z]
    for plane in sorted(flat, key=lambda p: -p["area"]):
        colour = colour_of(plane)
        axes.add_collection(PolyCollection([ground_polygon(plane)], facecolors=[(*colour, 0.10)],
                                           edgecolors=[(*colour, 0.55)], linewidths=0.6,
                                           zorder=1))
    polygons = [ground_polygon(p) for p in steep]
    axes.add_collection(LineCollection(
        [polygon + polygon[:1] for polygon in polygons if polygon], linewidths=2.2,
        colors=[colour_of(p) for p, polygon in zip(steep, polygons) if polygon],
        capstyle="round", zorder=3))


def draw_world(axes, outlines):
    axes.add_collection(LineCollection([o + o[:1] for o in outlines if o], zorder=2,
                                       **OUTLINE_STYLE))


def draw_trajectories(axes, estimate, truth):
    axes.plot(*truth, color="black", linewidth=0.9, linestyle=(0, (4, 3)), zorder=5)
    axes.plot(*estimate, color="tab:red", linewidth=1.1, zorder=4)


def limits(outlines, *plane_lists):
    """Box around everything [m]: (x_min, x_max, y_min, y_max)."""
    points = [point for outline in outlines for point in outline]
    points += [point for planes in plane_lists for p in planes for point in ground_polygon(p)]
    xs, ys = zip(*points) if points else ((0, 1), (0, 1))
    return min(xs) - MARGIN_M, max(xs) + MARGIN_M, min(ys) - MARGIN_M, max(ys) + MARGIN_M


def add_legend(figure):
    handles = [
        Line2D([], [], color="tab:purple", linewidth=2.2, label="wall or other steep plane"),
        Patch(facecolor=(0.5, 0.35, 0.7, 0.15), edgecolor=(0.5, 0.35, 0.7, 0.6),
              label="floor, ceiling, table top"),
        Line2D([], [], color="0.55", linewidth=0.8, label="the world, cut at two heights"),
        Line2D([], [], color="tab:red", linewidth=1.1, label="trajectory of the model"),
        Line2D([], [], color="black", linewidth=0.9, linestyle=(0, (4, 3)),
               label="true trajectory"),
    ]
    figure.legend(handles=handles, loc="lower center", ncol=len(handles), frameon=False,
                  fontsize=8, handlelength=2.2, columnspacing=1.4)


def counts(cell):
    return (f"{cell['matched']} matched, {cell['duplicates']} duplicates, {cell['extra']} extra, "
            f"{cell['missed']} missed")


def panel_texts(summary):
    cells = summary["four_cells"]
    before, after = cells["noisy_raw"], cells["corrected_merged"]
    return [f"Before the correction: {before['planes']} planes\n{counts(before)}",
            f"After the correction, merged and filtered: {after['planes']} planes "
            f"(truth: {summary['truth_planes']})\n{counts(after)}"]


def figure_size(box):
    """Two panels side by side on 11 inches, as high as their content asks for."""
    width, height = box[1] - box[0], box[3] - box[2]
    return 11.0, min(9.0, 5.2 * height / width) + 1.3


def draw(directory):
    data = load_json(directory / "figure.json")
    planes = [load_json(directory / f"planes_{when}.json")["planes"]
              for when in ("before", "after")]
    trajectories = [load_trajectory(directory / f"trajectory_{which}.tum")
                    for which in ("before", "after", "truth")]
    box = limits(data["world_outlines"], *planes)

    def colour_of(plane):
        return matplotlib.colors.to_rgb(data["colours"].get(str(plane["id"]), "0.3"))

    figure, panels = plt.subplots(1, 2, figsize=figure_size(box), sharex=True, sharey=True)
    titles = panel_texts(load_json(directory / "summary.json"))
    for i, axes in enumerate(panels):
        draw_planes(axes, planes[i], colour_of)
        draw_world(axes, data["world_outlines"])
        draw_trajectories(axes, trajectories[i], trajectories[2])
        axes.set(title=titles[i], xlabel="x [m]", xlim=box[:2], ylim=box[2:], aspect="equal")
        axes.spines[["top", "right"]].set_visible(False)
    panels[0].set_ylabel("y [m]")
    add_legend(figure)
    figure.tight_layout(rect=(0, 0.05, 1, 1), w_pad=2.0)
    return figure


def save(figure, path, **options):
    """The old file stays until the new one is whole."""
    temporary = path.with_name(f".{path.name}.tmp")
    try:
        figure.savefig(temporary, format=path.suffix[1:], **options)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: before_after.py DIRECTORY")
    directory = pathlib.Path(sys.argv[1])
    try:
        figure = draw(directory)
        save(figure, directory / "before_after.svg", metadata={"Date": None})
        save(figure, directory / "before_after.png", dpi=160)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"before_after.py: {error!r}")


if __name__ == "__main__":
    main()
