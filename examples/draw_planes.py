#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models a room with poses that drift, corrects the trajectory as a loop closure would, and draws
the planes of before and after: draw_planes.py [PICTURE.png]"""
import sys

import matplotlib
matplotlib.use("Agg")  # no window
from matplotlib.colors import to_rgba
import matplotlib.pyplot as plt
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
import numpy as np

import ribbon_mapper

BEAMS, LINES, LINE_PERIOD_S, BEAM_PERIOD_S = 361, 600, 0.025, 0.00005
LASER = ribbon_mapper.Laser(
    angle_min_rad=-np.pi / 2, angle_increment_rad=np.pi / (BEAMS - 1),
    time_increment_s=BEAM_PERIOD_S, range_min_m=0.1, range_max_m=30.0)
COLOURS = {"floor": "tab:brown", "ceiling": "tab:grey", "wall": "tab:blue"}
ROOM = np.array([[-3.0, -2.5, 0.0], [3.0, 2.5, 2.5]])  # two corners of a room


def matrices(rows):
    """Returns 4 x 4 matrices of these rows, one for each time."""
    return np.stack([np.stack(np.broadcast_arrays(*row), -1) for row in rows], -2)


def planar_pose(x_m, y_m, yaw_rad):
    """Returns poses on the floor."""
    c, s = np.cos(yaw_rad), np.sin(yaw_rad)
    return matrices([[c, -s, 0, x_m], [s, c, 0, y_m], [0 * c, 0, 1, 0], [0 * c, 0, 0, 1]])


def T_map_base(time_s):
    """Returns the robot's true pose: it drives in a circle, once in 15 s."""
    angle_rad = 2.0 * np.pi * time_s / 15.0
    return planar_pose(0.6 * np.cos(angle_rad), 0.6 * np.sin(angle_rad), angle_rad)


def T_map_base_drifting(time_s):
    """Returns the pose that a drifting localisation reports: 0.6 m and 11 degrees off at the end."""
    share = time_s / 15.0
    return planar_pose(0.6 * share, -0.2 * share, 0.2 * share) @ T_map_base(time_s)


def T_base_laser(time_s):
    """Returns the pose of the laser in the base: it tilts within +-1.2 rad at 0.8 rad/s."""
    periods = time_s * 0.8 / 4.8
    tilt_rad = 1.2 * (4.0 * np.abs(periods - np.round(periods)) - 1.0)
    c, s = np.cos(tilt_rad), np.sin(tilt_rad)
    return matrices([[c, 0, s, 0], [0 * c, 1, 0, 0], [-s, 0, c, 1.2], [0 * c, 0, 0, 1]])


def scan(first_s):
    """Returns the ranges of the line that begins at this time, as a driver would report them."""
    beams = np.arange(BEAMS)
    time_s = first_s + beams * BEAM_PERIOD_S
    angle_rad = LASER.angle_min_rad + beams * LASER.angle_increment_rad
    pose = T_map_base(time_s) @ T_base_laser(time_s)
    across = np.stack([np.cos(angle_rad), np.sin(angle_rad), 0 * angle_rad, 0 * angle_rad], -1)
    direction = (pose @ across[..., np.newaxis])[:, :3, 0]
    with np.errstate(divide="ignore"):  # beams that are parallel to a wall
        walls_m = (np.where(direction > 0.0, ROOM[1], ROOM[0]) - pose[:, :3, 3]) / direction
    return np.abs(walls_m).min(axis=1)


def model():
    """Returns the model of the drive, and the stamps and true poses of its lines."""
    modeler = ribbon_mapper.Modeler()
    stamps_ns, true_poses = [], []
    for line in range(LINES):
        first_s = 1.0 + line * LINE_PERIOD_S
        last_s = first_s + (BEAMS - 1) * BEAM_PERIOD_S
        stamp_ns = round(first_s * 1e9)
        modeler.add_scan_line(
            stamp_ns, scan(first_s), LASER,
            T_odom_base=[T_map_base_drifting(first_s), T_map_base_drifting(last_s)],
            T_base_laser=[T_base_laser(first_s), T_base_laser(last_s)])
        stamps_ns.append(stamp_ns)
        true_poses.append(T_map_base(first_s))
    return modeler, stamps_ns, true_poses


def draw(axes, planes, title):
    """Draws the outlines of planes as seen from above: filled if they face the viewer."""
    axes.view_init(elev=45, azim=-60)
    elev, azim = np.radians([axes.elev, axes.azim])
    to_viewer = [np.cos(elev) * np.cos(azim), np.cos(elev) * np.sin(azim), np.sin(elev)]
    for plane in planes:
        faces = plane.normal @ to_viewer > 0.0
        colour = COLOURS.get(plane.label, "tab:red")
        axes.add_collection3d(Poly3DCollection(
            [outline.outer for outline in plane.outlines], edgecolor=colour if faces else "grey",
            facecolor=to_rgba(colour, 0.4 if faces else 0.0), linewidth=0.7))
        if faces and plane.area_m2 > 10.0:
            axes.text(*plane.centroid, f"{plane.label}\n{plane.area_m2:.1f} m²", ha="center",
                      va="center", fontsize=8)
    axes.set(title=f"{title}: {len(planes)} planes", xlabel="x [m]", ylabel="y [m]",
             zlabel="z [m]", xlim=(-3.5, 3.5), ylim=(-3, 3), zlim=(0, 2.5), zticks=[0, 1, 2])
    axes.set_box_aspect((7, 6, 2.5))


def main():
    """Returns the exit status: 0 if the corrected model has the six planes of the room."""
    modeler, stamps_ns, true_poses = model()
    before = modeler.planes()
    modeler.correct(stamps_ns, true_poses)
    after = modeler.planes()
    for plane in after:
        print(plane)

    figure = plt.figure(figsize=(13, 6))
    draw(figure.add_subplot(1, 2, 1, projection="3d"), before, "Poses that drift")
    draw(figure.add_subplot(1, 2, 2, projection="3d"), after, "Corrected")
    picture = sys.argv[1] if len(sys.argv) > 1 else "planes.png"
    figure.savefig(picture, dpi=120, bbox_inches="tight")
    print(f"the planes are drawn in {picture}")
    return 0 if len(after) == 6 < len(before) else 1


if __name__ == "__main__":
    sys.exit(main())
