# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The walls of a world, read from its SDF as XML: what a floor plan is compared with.

Usage: python3 wall_truth.py FLOOR_PLAN.geojson WORLD.sdf     prints the comparison
"""
import json
import math
import sys
import xml.etree.ElementTree as xml

LABEL = "{urn:ribbon_mapper}label"
CUT_M = 1.0       # height at which plans are cut
LINTEL_M = 1.8    # a wall that begins higher is a lintel
ALONG = 0.5       # of the cosine: a box is along a wall, or across it


def pose_of(element):
    """Returns x, y, z and yaw of an element; worlds have no other turns."""
    pose = element.find("pose")
    numbers = [float(word) for word in pose.text.split()] if pose is not None else [0.0] * 6
    return numbers[0], numbers[1], numbers[2], numbers[5]


def moved(outer, inner):
    x, y, z, yaw = outer
    c, s = math.cos(yaw), math.sin(yaw)
    return (x + c * inner[0] - s * inner[1], y + s * inner[0] + c * inner[1], z + inner[2],
            yaw + inner[3])


class Box:
    """A box that stands upright, seen from above."""

    def __init__(self, pose, size):
        self.x, self.y, z, self.yaw = pose
        self.length, self.width, height = size
        self.bottom, self.top = z - 0.5 * height, z + 0.5 * height

    def local(self, point):
        dx, dy = point[0] - self.x, point[1] - self.y
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        return c * dx + s * dy, -s * dx + c * dy

    def outside_m(self, point):
        """Returns how far a point is outside; negative inside."""
        u, v = self.local(point)
        return max(abs(u) - 0.5 * self.length, abs(v) - 0.5 * self.width)

    def thickness_across(self, direction):
        """Returns the size across a direction."""
        along = abs(math.cos(self.yaw) * direction[0] + math.sin(self.yaw) * direction[1])
        return self.width if along > ALONG else self.length

    def middle_line(self):
        """Returns points of the middle half of the longer side, and the direction across."""
        u_long = self.length >= self.width
        half, c, s = 0.5 * max(self.length, self.width), math.cos(self.yaw), math.sin(self.yaw)
        along, across = ((c, s), (-s, c)) if u_long else ((-s, c), (c, s))
        places = [(self.x + t * half * along[0], self.y + t * half * along[1])
                  for t in (-0.5, 0.0, 0.5)]
        return places, across


def boxes(path, label="wall"):
    """Returns the boxes of a world that are called so, or whose model or link is."""
    found = []
    for model in xml.parse(path).getroot().iter("model"):
        for link in model.findall("link"):
            frame = moved(pose_of(model), pose_of(link))
            for shape in link.findall("collision"):
                names = [e.findtext(LABEL) for e in (shape, link, model)]
                size = shape.findtext("geometry/box/size")
                if next((n for n in names if n), None) == label and size:
                    found.append(Box(moved(frame, pose_of(shape)),
                                     [float(word) for word in size.split()]))
    return found


class Plan:
    """A floor plan, read from GeoJSON without our own code."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            features = json.load(file)["features"]
        self.features = [(f["properties"], f["geometry"]) for f in features]

    def kind(self, *kinds):
        return [(p, g) for p, g in self.features if p["kind"] in kinds]

    def polygons(self, kind):
        for _, geometry in self.kind(kind):
            parts = geometry["coordinates"]
            yield from [parts] if geometry["type"] == "Polygon" else parts

    def is_solid(self, point):
        return any(sum(inside(ring, point) for ring in polygon) % 2
                   for polygon in self.polygons("solid"))

    def crosses_a_line(self, a, b):
        return any(cross(a, b, *g["coordinates"]) for p, g in self.kind("wall") if p["faces"] == 1)


def inside(ring, point):
    x, y = point
    result = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:]):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            result = not result
    return result


def cross(a, b, c, d):
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def middle_and_direction(geometry, thickness):
    """Returns a point inside a wall's footprint and the direction of its longest edge."""
    polygon = geometry["coordinates"]
    ring = polygon[0] if geometry["type"] == "Polygon" else polygon[0][0]
    a, b = max(zip(ring, ring[1:]), key=lambda edge: math.dist(*edge))
    length = math.dist(a, b)
    x, y = (b[0] - a[0]) / length, (b[1] - a[1]) / length
    # An outer ring runs counter-clockwise: its inside is on the left.
    middle = (0.5 * (a[0] + b[0] - thickness * y), 0.5 * (a[1] + b[1] + thickness * x))
    return middle, (x, y)


def thickness_errors(plan, walls):
    """Returns a list of (error [m], properties) of walls with two faces; None if no wall is there."""
    cut = [box for box in walls if box.bottom <= CUT_M <= box.top]
    errors = []
    for properties, geometry in plan.kind("wall"):
        if properties["faces"] != 2:
            continue
        middle, direction = middle_and_direction(geometry, properties["thickness_m"])
        sizes = [b.thickness_across(direction) for b in cut if b.outside_m(middle) < 0.05]
        errors.append((properties["thickness_m"] - min(sizes) if sizes else None, properties))
    return errors


def shut_doorways(plan, walls):
    """Returns the lintels of the world below which the plan has a wall, and their number."""
    lintels = [box for box in walls if box.bottom > LINTEL_M]
    shut = []
    for lintel in lintels:
        places, across = lintel.middle_line()
        reach = 0.5 * min(lintel.length, lintel.width) + 0.1
        for x, y in places:
            a, b = [(x + s * reach * across[0], y + s * reach * across[1]) for s in (-1.0, 1.0)]
            if plan.is_solid((x, y)) or plan.crosses_a_line(a, b):
                shut.append(lintel)
                break
    return shut, len(lintels)


def width_errors(plan, walls):
    """Returns by how much the doors below the lintels of the world are too wide [m]."""
    errors = []
    for lintel in (box for box in walls if box.bottom > LINTEL_M):
        for properties, geometry in plan.kind("door", "opening"):
            a, b = geometry["coordinates"]
            if lintel.outside_m((0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]))) < 0.05:
                errors.append(properties["width_m"] - max(lintel.length, lintel.width))
    return errors


def main():
    plan, walls = Plan(sys.argv[1]), boxes(sys.argv[2])
    errors = thickness_errors(plan, walls)
    known = [abs(error) for error, _ in errors if error is not None]
    print(f"{len(errors)} walls with two faces, {len(plan.kind('wall')) - len(errors)} with one; "
          f"{len(errors) - len(known)} where the world has none; "
          f"largest error of thickness {1000 * max(known or [0.0]):.1f} mm")
    for error, properties in errors:
        if error is None or abs(error) > 0.01:
            print(f"  {properties}: {error}")
    shut, count = shut_doorways(plan, walls)
    print(f"{count - len(shut)} of {count} doorways below a lintel are open; "
          f"{len(plan.kind('door'))} doors, {len(plan.kind('opening'))} openings")
    print("errors of their widths [mm]:", *(f"{1000 * e:.0f}" for e in width_errors(plan, walls)))
    for lintel in shut:
        print(f"  shut: {lintel.x:.2f} {lintel.y:.2f}")


if __name__ == "__main__":
    main()
