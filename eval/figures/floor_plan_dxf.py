# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a floor plan as a drawing for CAD: floor_plan.dxf, in metres, by ezdxf.

Usage: python3 floor_plan_dxf.py DIRECTORY, or python3 floor_plan_dxf.py NAME_floor_plan.geojson

Layers: WALLS (walls with two faces as closed outlines, hatched; faces without a back as lines),
WALLS_HIDDEN (where walls seem to go on behind furniture), DOORS (sills, leaves and their swing), ROOMS (outlines, names and areas).
"""

import math
import os
import sys

from floor_plan_file import FloorPlan, input_and_output, polygons

try:
    import ezdxf
except ImportError:
    sys.exit("floor_plan_dxf.py: ezdxf is missing: sudo apt install python3-ezdxf")

# Same input, same bytes: neither times nor random identifiers. Versions before 0.17 have no such
# option.
if hasattr(ezdxf, "options") and hasattr(ezdxf.options, "write_fixed_meta_data_for_testing"):
    ezdxf.options.write_fixed_meta_data_for_testing = True

VERSION = "R2000"  # the oldest that has LWPOLYLINE and HATCH; every CAD reads it
METRES = 6  # of $INSUNITS
LAYERS = {"WALLS": 7, "WALLS_HIDDEN": 9, "DOORS": 5, "ROOMS": 8}  # and their colours
TEXT_M = 0.2


def new_drawing():
    drawing = ezdxf.new(VERSION)
    drawing.header["$INSUNITS"] = METRES
    drawing.header["$MEASUREMENT"] = 1  # metric
    for name, colour in LAYERS.items():
        drawing.layers.new(name, dxfattribs={"color": colour})
    return drawing


def add_outline(space, geometry, layer):
    for polygon in polygons(geometry):
        for ring in polygon:
            space.add_lwpolyline(ring[:-1], dxfattribs={"layer": layer, "closed": True})


def add_walls(space, plan):
    for _, geometry in plan.of_kind("solid"):
        add_outline(space, geometry, "WALLS")
        hatch = space.add_hatch(color=8, dxfattribs={"layer": "WALLS"})
        for polygon in polygons(geometry):
            for ring in polygon:
                hatch.paths.add_polyline_path(ring[:-1], is_closed=True)
    for _, geometry in plan.of_kind("hidden"):
        add_outline(space, geometry, "WALLS_HIDDEN")
    for properties, geometry in plan.of_kind("wall"):
        if properties["faces"] == 1:
            space.add_line(*geometry["coordinates"], dxfattribs={"layer": "WALLS"})


def add_doors(space, plan):
    doors = {}
    for properties, geometry in plan.of_kind("door", "opening"):
        a, b = geometry["coordinates"]
        doors[properties["number"]] = (a, b)
        length = math.dist(a, b) or 1.0
        half = 0.5 * (properties["thickness_m"] or 0.0)
        dx, dy = -half * (b[1] - a[1]) / length, half * (b[0] - a[0]) / length
        for side in sorted({1.0, -1.0 if half else 1.0}):
            space.add_line((a[0] + side * dx, a[1] + side * dy),
                           (b[0] + side * dx, b[1] + side * dy), dxfattribs={"layer": "DOORS"})
    for properties, geometry in plan.of_kind("leaf"):
        add_leaf(space, *geometry["coordinates"], doors[properties["door"]])


def add_leaf(space, hinge, tip, jambs):
    """Adds a leaf, and the arc on which it swings shut."""
    closed = max(jambs, key=lambda jamb: math.dist(jamb, hinge))
    angles = [math.degrees(math.atan2(p[1] - hinge[1], p[0] - hinge[0])) for p in (tip, closed)]
    if (angles[1] - angles[0]) % 360.0 > 180.0:
        angles.reverse()
    space.add_line(hinge, tip, dxfattribs={"layer": "DOORS"})
    space.add_arc(hinge, math.dist(hinge, tip), *angles, dxfattribs={"layer": "DOORS"})


def add_rooms(space, plan):
    for properties, geometry in plan.of_kind("room"):
        add_outline(space, geometry, "ROOMS")
        x, y = properties["label_at"]
        lines = (f"Room {properties['name']}", f"{properties['area_m2']:.1f} m2")
        for i, text in enumerate(lines):
            place = (x, y - 1.5 * TEXT_M * i)
            space.add_text(text, dxfattribs={"layer": "ROOMS", "height": TEXT_M, "insert": place,
                                             "halign": 1, "align_point": place})


def save(drawing, path):
    """Replaces the file only after the new one is complete."""
    temporary = path.with_name(f".{path.name}.tmp")
    try:
        drawing.saveas(temporary)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def main():
    path, (dxf,) = input_and_output("floor_plan_dxf.py", [".dxf"])
    try:
        plan = FloorPlan(path)
        drawing = new_drawing()
        space = drawing.modelspace()
        add_rooms(space, plan)
        add_walls(space, plan)
        add_doors(space, plan)
        save(drawing, dxf)
    except OSError as error:
        sys.exit(f"floor_plan_dxf.py: {error}")
    except (ValueError, KeyError) as error:
        sys.exit(f"floor_plan_dxf.py: {error!r}")


if __name__ == "__main__":
    main()
