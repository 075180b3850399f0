// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

const PATH = "#c2571a", TRUTH = "#23405c", LIFT_M = 0.04;  // above the floor that it lies on

/** Returns lines of a width in pixels between pairs of points. */
function wideLines(segments, colour, width, options = {}) {
  const geometry = new THREE.LineSegmentsGeometry();
  if (segments.length > 0) geometry.setPositions(segments);
  const material = new THREE.LineMaterial({color: colour, linewidth: width, ...options});
  const lines = new THREE.LineSegments2(geometry, material);
  lines.frustumCulled = false;  // its points change
  lines.visible = segments.length > 0;
  return lines;
}

/** Returns the points of a trajectory as one list of numbers, relative to the centre [m]. */
function pathPoints(trajectory, centre) {
  const offset = [centre.x, centre.y, centre.z - LIFT_M];
  return trajectory.points_mm.map((value, i) => value / 1e3 - offset[i % 3]);
}

function chained(points) {
  const segments = [];
  for (let i = 0; i + 5 < points.length; i += 3) segments.push(...points.slice(i, i + 6));
  return segments;
}

/** The way of the robot, from one model to the next, and the robot at a time. */
class Path {
  constructor(data) {
    this.trajectories = data.trajectories;
    this.models = data.models;
    this.points = data.trajectories.map((trajectory) => pathPoints(trajectory, data.centre));
    this.whole = wideLines([0, 0, 0, 0, 0, 0], PATH, 2, {transparent: true, opacity: 0.35});
    this.travelled = wideLines([0, 0, 0, 0, 0, 0], PATH, 3);
    this.robot = new THREE.Mesh(new THREE.ConeGeometry(0.16, 0.5, 20).rotateZ(-Math.PI / 2),
      new THREE.MeshBasicMaterial({color: PATH}));
    this.group = new THREE.Group().add(this.whole, this.travelled, this.robot);
  }

  /** Places the path for a position of the slider, which lies between two models. */
  place(position) {
    const from = Math.floor(position), to = Math.min(from + 1, this.models.length - 1);
    const a = this.models[from]?.trajectory ?? 0, b = this.models[to]?.trajectory ?? 0;
    const share = position - from;
    this.trajectory = this.trajectories[share < 0.5 ? a : b];
    if (!this.trajectory) return;
    this.now = this.points[a];
    if (a !== b && this.points[a].length === this.points[b].length) {
      this.now = this.points[a].map((value, i) => value + share * (this.points[b][i] - value));
    } else if (share >= 0.5) {
      this.now = this.points[b];
    }
    for (const lines of [this.whole, this.travelled]) {
      lines.geometry.dispose();
      lines.geometry = new THREE.LineSegmentsGeometry();
      lines.geometry.setPositions(this.now.length > 3 ? chained(this.now) : [0, 0, 0, 0, 0, 0]);
    }
  }

  /** Places the robot at the pose of this index. */
  at(index) {
    if (!this.trajectory || this.now.length < 3) { this.group.visible = false; return; }
    const i = Math.min(index, this.now.length / 3 - 1);
    this.travelled.geometry.instanceCount = i;
    this.travelled.visible = i > 0;
    this.robot.position.fromArray(this.now, 3 * i);
    this.robot.rotation.z = this.trajectory.heading_mrad[i] / 1e3;
  }
}

/** Returns the outlines of the true planes, and the true way. */
function truthLines(data) {
  if (!data.truth) return [];
  const shown = data.truth.planes.filter((plane) => plane.normal.z > -0.8);
  const outlines = outlineSegments(shown, data.centre);
  const all = [wideLines(outlines, TRUTH, 1.4),
    wideLines(chained(pathPoints(data.truth.trajectory, data.centre)), TRUTH, 1.6,
      {dashed: true, dashSize: 0.12, gapSize: 0.1})];
  for (const lines of all) if (lines.visible) lines.computeLineDistances();
  return all;
}

/** Returns the outlines of rooms on the floor. */
function roomLines(data) {
  const segments = [];
  for (const room of data.rooms) {
    for (const ring of room.outlines_mm.flat()) {
      const points = pathPoints({points_mm: ring}, data.centre);
      segments.push(...chained(points.concat(points.slice(0, 3))));
    }
  }
  return wideLines(segments, "#6b7580", 2, {dashed: false});
}
