# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a floor plan to scale: walls, doors with their swing, and rooms with their areas.

Usage: python3 floor_plan.py DIRECTORY, or python3 floor_plan.py NAME_floor_plan.geojson

Reads floor_plan.geojson, as experiment, offline_modeler and ~save write it, and writes
floor_plan.svg and .png beside it.
"""

import math
import sys

from figure_files import save, words_of
from floor_plan_file import FloorPlan, input_and_output, polygons

import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection
from matplotlib.patches import Arc, PathPatch, Rectangle
from matplotlib.path import Path

LONGEST_IN = 9.0  # of the drawing's sides
MARGIN_M = 0.8
UNSEEN_M = 0.1  # depth to which a wall is shaded whose other face was not seen
ROOM_COLOURS = ["#eef3e6", "#e8eef6", "#f7efe2", "#f3e9f1", "#e6f2f1", "#f5f2df"]
WALL, SHADE, DOOR, TEXT = "#222222", "#d5d5d5", "#30568a", "#333333"
HIDDEN = {"facecolor": "white", "edgecolor": "#888888", "linewidth": 0.5,
          "linestyle": (0, (3, 2))}
SCALES_M = [0.5, 1, 2, 5, 10, 20, 50, 100]


def path_of(geometry):
    """Returns polygons with holes as one path."""
    rings = [Path(ring, closed=True) for polygon in polygons(geometry) for ring in polygon]
    return Path.make_compound_path(*rings)


def unit(a, b):
    """Returns the direction from a to b, and its normal to the left."""
    length = math.dist(a, b) or 1.0
    x, y = (b[0] - a[0]) / length, (b[1] - a[1]) / length
    return (x, y), (-y, x)


def draw_rooms(axes, plan):
    for i, (_, geometry) in enumerate(plan.of_kind("room")):
        if not polygons(geometry):
            continue
        colour = ROOM_COLOURS[i % len(ROOM_COLOURS)]
        axes.add_patch(PathPatch(path_of(geometry), facecolor=colour, edgecolor="none", zorder=1))


def label_rooms(axes, plan, inch_per_m):
    for properties, _ in plan.of_kind("room"):
        size = min(9.0, max(4.5, 1.6 * inch_per_m * math.sqrt(properties["area_m2"]) * 3.0))
        free = "" if properties["is_enclosed"] else "\nof free floor"
        axes.text(*properties["label_at"],
                  f"Room {properties['name']}\n{properties['area_m2']:.1f} m²{free}", ha="center",
                  va="center", fontsize=size, color=TEXT, zorder=7, linespacing=1.2,
                  bbox={"boxstyle": "round,pad=0.15", "fc": "white", "lw": 0, "alpha": 0.6})


def draw_walls(axes, plan):
    """Fills walls of known thickness; shades behind the face where the other one was not seen."""
    faces = [geometry["coordinates"] for properties, geometry in plan.of_kind("wall")
             if properties["faces"] == 1]
    ends = [tuple(end) for face in faces for end in face]
    for a, b in faces:
        along, hidden = unit(a, b)
        # At a corner, the shade goes on below the rooms, so that no notch is left.
        before, after = (float(ends.count(tuple(end)) > 1) for end in (a, b))
        band = [(p[0] + UNSEEN_M * (end * along[0] + depth * hidden[0]),
                 p[1] + UNSEEN_M * (end * along[1] + depth * hidden[1]))
                for p, end, depth in ((a, -before, 0), (b, after, 0), (b, after, 1),
                                      (a, -before, 1), (a, -before, 0))]
        axes.add_patch(PathPatch(Path(band, closed=True), facecolor=SHADE, edgecolor="none",
                                 zorder=0.5))
    axes.add_collection(LineCollection(faces, colors=WALL, linewidths=1.1, zorder=4,
                                       capstyle="projecting"))
    for _, geometry in plan.of_kind("solid"):
        axes.add_patch(PathPatch(path_of(geometry), facecolor=WALL, edgecolor=WALL, linewidth=0.4,
                                 joinstyle="miter", zorder=3))


def draw_hidden(axes, plan):
    """Draws dashed where walls seem to go on behind furniture."""
    for _, geometry in plan.of_kind("hidden"):
        axes.add_patch(PathPatch(path_of(geometry), zorder=2.5, **HIDDEN))


def draw_openings(axes, plan):
    """Draws the sill of each opening on both faces of its wall: dashed where it has no lintel."""
    for properties, geometry in plan.of_kind("door", "opening"):
        a, b = geometry["coordinates"]
        _, across = unit(a, b)
        half_m = 0.5 * (properties["thickness_m"] or 0.0)
        sills = [[(x + side * across[0], y + side * across[1]) for x, y in (a, b)]
                 for side in {half_m, -half_m}]
        style = "solid" if properties["kind"] == "door" else (0, (3, 2))
        axes.add_collection(LineCollection(sills, colors=DOOR, linewidths=0.5, linestyles=[style],
                                           zorder=3))


def draw_leaf(axes, hinge, tip, closed):
    """Draws a leaf, and the arc on which it swings shut."""
    radius = math.dist(hinge, tip)
    angles = [math.degrees(math.atan2(p[1] - hinge[1], p[0] - hinge[0])) for p in (tip, closed)]
    if (angles[1] - angles[0]) % 360.0 > 180.0:
        angles.reverse()
    axes.add_patch(Arc(hinge, 2 * radius, 2 * radius, theta1=angles[0], theta2=angles[1],
                       color=DOOR, linewidth=0.5, zorder=5))
    axes.plot(*zip(hinge, tip), color=DOOR, linewidth=1.4, solid_capstyle="butt", zorder=5)


def draw_leaves(axes, plan):
    doors = {properties["number"]: geometry["coordinates"]
             for properties, geometry in plan.of_kind("door")}
    for properties, geometry in plan.of_kind("leaf"):
        hinge, tip = geometry["coordinates"]
        draw_leaf(axes, hinge, tip, max(doors[properties["door"]],
                                        key=lambda jamb: math.dist(jamb, hinge)))


def scale_bar(axes, limits):
    """Draws a bar of a round length, about a quarter of the width, below the plan on the left."""
    (left, right), (low, _) = limits
    length = max([s for s in SCALES_M if s <= 0.3 * (right - left)] or SCALES_M[:1])
    x, y, height = left + 0.5 * MARGIN_M, low + 0.25 * MARGIN_M, 0.1 * MARGIN_M
    for i in range(4):
        axes.add_patch(Rectangle((x + 0.25 * i * length, y), 0.25 * length, height, linewidth=0.5,
                                 edgecolor=WALL, facecolor=WALL if i % 2 == 0 else "white"))
    for share in (0.0, 0.5, 1.0):
        axes.annotate(f"{share * length:g}{' m' if share == 1.0 else ''}",
                      (x + share * length, y + height), (0, 1.5), textcoords="offset points",
                      ha="center", va="bottom", fontsize=6, color=TEXT)


def axes_cross(axes, plan, limits):
    """Draws the axes of the frame, below the plan on the right."""
    (_, right), (low, _) = limits
    x, y, length = right - 1.3 * MARGIN_M, low + 0.25 * MARGIN_M, 0.55 * MARGIN_M
    for dx, dy, name in ((length, 0.0, "x"), (0.0, length, "y")):
        axes.annotate("", (x + dx, y + dy), (x, y),
                      arrowprops={"arrowstyle": "-|>", "lw": 0.7, "color": WALL,
                                  "shrinkA": 0, "shrinkB": 0, "mutation_scale": 6})
        axes.text(x + 1.25 * dx, y + 1.25 * dy, name, ha="center", va="center", fontsize=6,
                  color=TEXT)
    axes.text(x - 0.15 * MARGIN_M, y, plan.frame, ha="right", va="bottom", fontsize=6, color=TEXT)


def legend(axes, plan, limits):
    """Says what black, grey and dashed walls are, below the plan in its middle."""
    (left, right), (low, _) = limits
    faces = {properties["faces"] for properties, _ in plan.of_kind("wall")}
    if not faces or right - left < 8.0 * MARGIN_M:
        return
    rows = [("hidden", HIDDEN)] * bool(plan.of_kind("hidden"))
    rows += [("one face seen", {"facecolor": SHADE})] * (1 in faces)
    rows += [("both faces seen", {"facecolor": WALL})] * (2 in faces)
    x, y = 0.5 * (left + right), low + 0.2 * MARGIN_M
    for i, (text, style) in enumerate(rows):
        axes.add_patch(Rectangle((x, y + 0.28 * i * MARGIN_M), 0.4 * MARGIN_M, 0.12 * MARGIN_M,
                                 **{"linewidth": 0.0, **style}))
        axes.text(x + 0.55 * MARGIN_M, y + (0.28 * i + 0.06) * MARGIN_M, text, va="center",
                  fontsize=6, color=TEXT)


def limits_of(plan):
    """Returns the ranges of x and y [m]: an empty plan has 2 m of each."""
    points = []
    for feature in plan.features:
        stack = [feature["geometry"]["coordinates"]]
        while stack:
            item = stack.pop()
            if item and isinstance(item[0], (int, float)):
                points.append(item)
            else:
                stack.extend(item)
    points = points or [(-1.0, -1.0), (1.0, 1.0)]
    ranges = [(min(p[axis] for p in points) - MARGIN_M, max(p[axis] for p in points) + MARGIN_M)
              for axis in (0, 1)]
    return ranges[0], (ranges[1][0] - 0.5 * MARGIN_M, ranges[1][1])


def title_of(plan):
    rooms = plan.of_kind("room")
    walls, doors = plan.of_kind("wall"), plan.of_kind("door")
    if not walls and not rooms:
        return "No walls and no floor were seen"
    counts = [(len(rooms), "room"), (len(doors), "door"), (len(plan.of_kind("opening")), "opening")]
    if not rooms:
        counts.append((len(walls), "wall"))
    text = ", ".join(f"{n} {word}{'' if n == 1 else 's'}" for n, word in counts if n)
    area = sum(properties["area_m2"] for properties, _ in rooms)
    return text + (f"; {area:.1f} m² in all" if rooms else "")


def draw(plan):
    limits = limits_of(plan)
    extent = [high - low for low, high in limits]
    inch_per_m = LONGEST_IN / max(extent)
    title_in = 0.3
    width, height = (inch_per_m * e for e in extent)
    width = max(width, 3.0)
    figure = plt.figure(figsize=(width, height + title_in))
    axes = figure.add_axes([0.0, 0.0, 1.0, height / (height + title_in)])
    axes.set_axis_off()
    axes.set(xlim=limits[0], ylim=limits[1], aspect="equal")
    draw_rooms(axes, plan)
    draw_walls(axes, plan)
    draw_hidden(axes, plan)
    draw_openings(axes, plan)
    draw_leaves(axes, plan)
    label_rooms(axes, plan, inch_per_m)
    scale_bar(axes, limits)
    axes_cross(axes, plan, limits)
    legend(axes, plan, limits)
    figure.text(0.5, 1.0 - 0.6 * title_in / (height + title_in), title_of(plan), ha="center",
                va="center", fontsize=9)
    return figure


def main():
    path, (svg, png) = input_and_output("floor_plan.py", [".svg", ".png"])
    try:
        figure = draw(FloorPlan(path))
        save(figure, svg, metadata={"Date": None})
        save(figure, png, dpi=150)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"floor_plan.py: {words_of(error)}")


if __name__ == "__main__":
    main()
