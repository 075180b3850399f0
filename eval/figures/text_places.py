# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts in a figure that do not overlap: those that come first stand where they belong, others
beside, with a line to their place. A text for which there is no room is left out."""

import math

from matplotlib.text import Text

DIRECTIONS = 12
RADII_PT = [0.0, 12.0, 20.0, 30.0, 42.0, 56.0]  # from a text's place; further away, nobody follows
GAP_PT = 1.0  # between texts
LINE = {"arrowstyle": "-", "linewidth": 0.4, "color": "0.3", "shrinkA": 0.0, "shrinkB": 0.0}


def shifts():
    """Returns the places to try, relative to where a text belongs, the nearest first [pt]."""
    for radius in RADII_PT:
        for i in range(DIRECTIONS if radius else 1):
            angle = 2.0 * math.pi * i / DIRECTIONS
            yield radius * math.cos(angle), radius * math.sin(angle)


class TextPlaces:
    """The texts of one pair of axes, whose limits are set."""

    def __init__(self, axes):
        axes.apply_aspect()
        self._axes = axes
        self._renderer = axes.figure.canvas.get_renderer()
        self._frame = axes.get_window_extent(self._renderer)
        self._gap = GAP_PT * axes.figure.dpi / 72.0
        self._taken = []

    def add(self, text, place, **style):
        """Draws a text at a place of the axes, or near it. Returns whether there was room."""
        for shift in shifts():
            moved = math.hypot(*shift) > 0.0
            label = self._axes.annotate(text, place, shift, textcoords="offset points",
                                        ha="center", va="center",
                                        arrowprops=LINE if moved else None, **style)
            if self._take(label):
                return True
            label.remove()
        return False

    def _take(self, label):
        label.update_positions(self._renderer)
        box = Text.get_window_extent(label, self._renderer)  # without the line
        if not self._frame.containsx(box.x0) or not self._frame.containsx(box.x1) or \
                not self._frame.containsy(box.y0) or not self._frame.containsy(box.y1):
            return False
        if any(_overlap(box, other, self._gap) for other in self._taken):
            return False
        self._taken.append(box)
        return True


def _overlap(a, b, gap):
    return (a.x0 < b.x1 + gap and b.x0 < a.x1 + gap and
            a.y0 < b.y1 + gap and b.y0 < a.y1 + gap)
