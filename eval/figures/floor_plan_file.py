# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the drawings of a floor plan: its GeoJSON, as the programs write it."""

import json
import pathlib
import sys

SUFFIX = "floor_plan.geojson"


class FloorPlan:
    """The features of a floor plan by kind; coordinates in metres."""

    def __init__(self, path):
        data = json.loads(path.read_text(encoding="utf-8"))
        self.frame = data["frame"]
        self.features = data["features"]

    def of_kind(self, *kinds):
        """Returns pairs of properties and geometry."""
        return [(f["properties"], f["geometry"]) for f in self.features
                if f["properties"]["kind"] in kinds]


def polygons(geometry):
    """Returns polygons, each a list of closed rings: the outer one, then holes."""
    parts = geometry["coordinates"]
    return {"Polygon": [parts], "MultiPolygon": parts}.get(geometry["type"], [])


def input_and_output(script, suffixes):
    """Returns the GeoJSON and the drawings to be made of it, from the command line.

    Its argument is the file, or a folder with the file floor_plan.geojson.
    """
    if len(sys.argv) != 2:
        sys.exit(f"usage: {script} DIRECTORY, or {script} NAME_{SUFFIX}")
    path = pathlib.Path(sys.argv[1])
    if path.is_dir():
        path = path / SUFFIX
    return path, [path.with_suffix(suffix) for suffix in suffixes]
