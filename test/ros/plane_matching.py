# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares planes of the model with planes of the world, given as messages.

Simple and slow, and independent of eval/, so that an error there cannot hide here.
"""
import math

MAX_ANGLE_DEG = 5.0
MAX_OFFSET = 0.10
REACH = 0.075
MIN_OVERLAP = 0.5


class Counts:
    def __init__(self, matched, missed, extra, duplicates):
        self.matched, self.missed = matched, missed
        self.extra, self.duplicates = extra, duplicates

    def __repr__(self):
        return '%d matched, %d missed, %d extra, %d duplicates' % self.key()

    def key(self):
        return self.matched, self.missed, self.extra, self.duplicates


def dot(a, b):
    return a.x * b.x + a.y * b.y + a.z * b.z


def angle_deg(a, b):
    return math.degrees(math.acos(max(-1.0, min(1.0, dot(a.normal, b.normal)))))


def offset(estimate, truth):
    return abs(dot(truth.normal, estimate.centroid) + truth.d)


def buckets(plane):
    """Returns the cubes of edge REACH that contain cells, as indices."""
    return {tuple(int(math.floor(v / REACH)) for v in (c.x, c.y, c.z)) for c in plane.cells}


def shared(cells, others):
    steps = (-1, 0, 1)
    return sum(1 for x, y, z in cells
               if any((x + i, y + j, z + k) in others for i in steps for j in steps for k in steps))


def overlap(estimate, truth):
    """Returns the shared cells of the truth; 0 if neither plane shares half of its cells."""
    e, t = buckets(estimate), buckets(truth)
    of_truth = shared(t, e)
    if of_truth >= MIN_OVERLAP * len(t) or shared(e, t) >= MIN_OVERLAP * len(e):
        return of_truth
    return 0


def compare(estimates, truths):
    """Counts matches between planes with cells. Pairs are one to one, the largest overlap first."""
    pairs = []
    for e, estimate in enumerate(estimates):
        for t, truth in enumerate(truths):
            if angle_deg(estimate, truth) < MAX_ANGLE_DEG and offset(estimate, truth) < MAX_OFFSET:
                pairs.append((overlap(estimate, truth), e, t))
    pairs = sorted(pair for pair in pairs if pair[0] > 0)[::-1]
    used, found = set(), set()
    for _, e, t in pairs:
        if e not in used and t not in found:
            used.add(e)
            found.add(t)
    copies = {e for _, e, _ in pairs} - used
    return Counts(len(found), len(truths) - len(found), len(estimates) - len(used) - len(copies),
                  len(copies))
