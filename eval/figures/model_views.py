# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a model to scale in a top and a side view: the observed cells and outlines of its planes.

Usage: python3 model_views.py DIRECTORY [FILE.png]

Reads planes_after.json, planes_after_cells.ply and summary.json from DIRECTORY, as offline_modeler
writes them, and writes model_views.png there, or FILE.png.
"""

import json
import pathlib
import sys

try:
    import numpy
    from figure_files import counted, save, words_of
    from outlines import closed, rings
    from text_places import TextPlaces
except ImportError:
    sys.exit("model_views.py: matplotlib is missing: sudo apt install python3-matplotlib")

import matplotlib.pyplot as plt  # noqa: E402 (needs the backend)
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402

WIDTH_IN = 8.0
TITLE_IN, GAP_IN = 0.75, 0.35
MARGIN_M = 0.3
LABELLED_M2 = 1.0  # planes from this area on get a label
LEVEL_NORMAL_Z = 0.5
CEILING_NORMAL_Z = -0.5  # ceilings are drawn as outlines in the top view


def load_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


def origin_of(header):
    """Returns what was subtracted from the points of a PLY file [m]."""
    for line in header:
        if line.startswith("comment origin "):
            return numpy.array(line.split()[2:], float)
    return numpy.zeros(3)


def load_cells(path):
    """Returns points [m], colours (0..1) and plane ids of a PLY cloud, binary or ASCII."""
    data = path.read_bytes()
    header, body = data.split(b"end_header\n", 1)
    lines = header.decode("ascii").splitlines()
    count = int(next(line.split()[2] for line in lines if line.startswith("element vertex")))
    kinds = {"float": "<f4", "double": "<f8", "uchar": "u1", "uint": "<u4", "int": "<i4"}
    fields = [line.split()[1:] for line in lines if line.startswith("property")]
    kind = numpy.dtype([(name, kinds[type_]) for type_, name in fields])
    if any("ascii" in line for line in lines):
        text = body.decode("ascii").splitlines()[:count]
        rows = numpy.array([line.split() for line in text], float)
        table = {name: rows[:, i] for i, (_, name) in enumerate(fields)}
    else:
        table = numpy.frombuffer(body, kind, count)
    points = numpy.stack([table[axis] for axis in "xyz"], axis=1) + origin_of(lines)
    colours = numpy.stack([table[c] for c in ("red", "green", "blue")], axis=1) / 255.0
    return points, colours, table["plane_id"].astype(int)


def views_of(points):
    """Returns title, right axis and up axis of each view; the longer of x and y points right."""
    extent = numpy.ptp(points, axis=0)
    right, other = (0, 1) if extent[0] >= extent[1] else (1, 0)
    return [("from above", right, other), ("from the side", right, 2)]


def draw_cells(axes, places, colours, side_m):
    """Draws cells as squares with this side, or as dots for side 0."""
    if side_m == 0.0:
        axes.scatter(*places.T, s=1.0, c=colours, linewidths=0, zorder=3, rasterized=True)
        return
    squares = [[(x - dx, y - dy), (x + dx, y - dy), (x + dx, y + dy), (x - dx, y + dy)]
               for x, y in places for dx, dy in [(0.5 * side_m, 0.5 * side_m)]]
    axes.add_collection(PolyCollection(squares, facecolors=colours, alpha=0.45, linewidths=0,
                                       zorder=2, rasterized=True))


def draw_plane(axes, view, plane, points, colours):
    """Draws planes that face the view as cells, edge-on planes as dots, ceilings as outlines."""
    _, right, up = view
    depth = ({0, 1, 2} - {right, up}).pop()
    faces = abs(plane["normal"][depth]) > LEVEL_NORMAL_Z
    is_ceiling = depth == 2 and plane["normal"][2] < CEILING_NORMAL_Z
    outlines = [closed(ring, right, up) for ring in rings(plane)]
    axes.add_collection(LineCollection(outlines, colors=[colours[0] if is_ceiling else "black"],
                                       linewidths=0.8 if is_ceiling else 0.4, zorder=4,
                                       linestyles="dashed" if is_ceiling else "solid"))
    if not is_ceiling:
        side_m = (plane["area"] / len(points)) ** 0.5 if faces else 0.0
        draw_cells(axes, points[:, [right, up]], colours, side_m)


def label(places, view, plane, colour):
    is_ceiling = view[2] != 2 and plane["normal"][2] < CEILING_NORMAL_Z
    places.add(f"{'ceiling ' if is_ceiling else ''}{plane['area']:.1f} m²",
               [plane["centroid"][axis] for axis in view[1:]],
               fontsize=6, color=0.6 * colour, zorder=5,
               bbox={"boxstyle": "round,pad=0.1", "fc": "white", "lw": 0, "alpha": 0.7})


def draw_view(axes, view, planes, cells):
    """Draws planes and labels, those of the largest planes first. The limits must be set."""
    points, colours, ids = cells
    places = TextPlaces(axes)
    for plane in sorted(planes, key=lambda p: -p["area"]):
        own = ids == plane["id"]
        draw_plane(axes, view, plane, points[own], colours[own])
        if plane["area"] >= LABELLED_M2 or len(planes) <= 8:
            label(places, view, plane, colours[own][0])


def limits(points, axis):
    return points[:, axis].min() - MARGIN_M, points[:, axis].max() + MARGIN_M


def title_of(summary):
    residual = summary["residual_m_median"]
    text = (f"{counted(summary['planes'], 'plane', 'planes')}, "
            f"{counted(summary['duplicates'], 'duplicate', 'duplicates')}")
    if residual is not None:
        text += f", median residual {1000 * residual:.1f} mm"
    return (", ".join(summary["bags"]) + f": {text}",
            f"{summary['lines']} lines, {summary['ribbons']} ribbons, {summary['points']} points; "
            f"preset {summary['config']}; poses: {summary['trajectory']}")


def draw(directory):
    planes = load_json(directory / "planes_after.json")["planes"]
    cells = load_cells(directory / "planes_after_cells.ply")
    points = cells[0]
    if not len(points):
        sys.exit("model_views.py: the model has no planes")
    views = views_of(points)
    width_m = numpy.ptp(limits(points, views[0][1]))
    heights_in = [WIDTH_IN * 0.88 * numpy.ptp(limits(points, up)) / width_m for _, _, up in views]
    height = sum(heights_in) + TITLE_IN + 2.5 * GAP_IN
    figure = plt.figure(figsize=(WIDTH_IN, height))
    top = height - TITLE_IN
    for view, height_in in zip(views, heights_in):
        axes = figure.add_axes([0.08, (top - height_in) / height, 0.88, height_in / height])
        axes.set(xlim=limits(points, view[1]), ylim=limits(points, view[2]), aspect="equal")
        draw_view(axes, view, planes, cells)
        axes.set_ylabel(f"{view[0]}: {'xyz'[view[2]]} [m]")
        top -= height_in + GAP_IN
    axes.set_xlabel(f"{'xyz'[views[0][1]]} [m]")
    title, text = title_of(load_json(directory / "summary.json"))
    figure.text(0.5, 1.0 - 0.25 / height, title, ha="center", fontsize=10, fontweight="bold")
    figure.text(0.5, 1.0 - 0.48 / height, text, ha="center")
    return figure


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: model_views.py DIRECTORY [FILE.png]")
    directory = pathlib.Path(sys.argv[1])
    try:
        save(draw(directory), pathlib.Path(sys.argv[2]) if len(sys.argv) == 3
             else directory / "model_views.png", dpi=150)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"model_views.py: {words_of(error)}")


if __name__ == "__main__":
    main()
