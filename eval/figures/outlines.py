# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by all figures: the outlines of planes, with holes, as matplotlib draws them."""

from matplotlib.path import Path


def rings(plane):
    """Returns all boundaries of a plane: outer ones and holes, each a list of points [m]."""
    return [ring for outline in plane["outlines"] for ring in outline]


def closed(ring, right, up):
    """Returns a boundary, with its first point at the end, as seen along the third axis [m]."""
    return [(point[right], point[up]) for point in ring + ring[:1]]


def area_of(plane, right=0, up=1):
    """Returns a plane's seen area, projected along the third axis, as a path with holes."""
    parts = [Path(closed(ring, right, up), closed=True) for ring in rings(plane)]
    return Path.make_compound_path(*parts)


def crossings(plane, z):
    """Returns the points where a plane's boundaries cross the height z [m], in order along it."""
    points = []
    for ring in rings(plane):
        for a, b in zip(ring, ring[1:] + ring[:1]):
            if (a[2] > z) != (b[2] > z):
                share = (z - a[2]) / (b[2] - a[2])
                points.append((a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])))
    along = (-plane["normal"][1], plane["normal"][0])
    return sorted(points, key=lambda p: p[0] * along[0] + p[1] * along[1])


def sections(plane, heights):
    """Returns the pieces of a steep plane at any of the heights, seen from above: pairs of points.

    Doors are open in all of them if all heights are below the lintel.
    """
    pieces = []
    for z in heights:
        points = crossings(plane, z)
        pieces += list(zip(points[::2], points[1::2]))
    return pieces
