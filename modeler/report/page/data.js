// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

const FORMAT = 1;

/** Returns the data of the page, with vectors where there were lists of numbers. */
function readData() {
  const data = JSON.parse(byId("data").textContent);
  if (data.format !== FORMAT) throw new Error(`The data have format ${data.format}, not ${FORMAT}.`);
  const sets = data.models.concat(data.truth ? [data.truth] : []);
  for (const set of sets) set.planes.forEach((plane) => prepare(plane));
  for (const model of data.models) {
    model.floor = floorHeight(model.planes);
    for (const plane of model.planes) plane.kind = kindOf(plane, model.floor);
    model.byId = new Map(model.planes.map((plane, index) => [plane.id, index]));
  }
  data.centre = centreOf(sets);
  return data;
}

const vector = (list) => new THREE.Vector3(...list.map((value) => value ?? 0));

function prepare(plane) {
  for (const name of ["normal", "centroid", "origin", "axis_u"]) plane[name] = vector(plane[name]);
  plane.axis_v = plane.normal.clone().cross(plane.axis_u);
}

/** Returns the height of the largest level plane that is seen from above, as the figures do. */
function floorHeight(planes) {
  let floor = null;
  for (const plane of planes) {
    if (plane.normal.z > 0.985 && (!floor || plane.area > floor.area)) floor = plane;
  }
  return floor ? floor.centroid.z : 0;
}

/** Returns what a plane is drawn as: its label says so, or else its direction and height. */
function kindOf(plane, floor) {
  if (plane.label === "floor" || plane.label === "ceiling") return plane.label;
  if (plane.normal.z < -0.8) return plane.label ? "other" : "ceiling";
  const isFloor = !plane.label && plane.normal.z > 0.985 && Math.abs(plane.centroid.z - floor) < 0.1;
  return isFloor ? "floor" : "other";
}

/** Returns the middle of all planes: coordinates on the graphics card are of single precision. */
function centreOf(sets) {
  const box = new THREE.Box3();
  for (const set of sets) for (const plane of set.planes) box.expandByPoint(plane.centroid);
  return box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3()).round();
}

/** Returns the point at (u, v) on a plane [m], relative to the centre of the data. */
function pointOn(plane, u, v, centre) {
  return plane.origin.clone().sub(centre).addScaledVector(plane.axis_u, u)
    .addScaledVector(plane.axis_v, v);
}

/** Calls visit(column, row, mean_mm) for each seen cell of a plane. */
function forEachCell(cells, visit) {
  const bytes = Uint8Array.from(atob(cells.data), (letter) => letter.charCodeAt(0));
  let at = 0;
  const next = () => {  // LEB128
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = bytes[at++];
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
  };
  const runs = [];
  let end = 0;
  for (let left = next(); left > 0; --left) {
    const first = end + next();
    end = first + next();
    runs.push([first, end]);
  }
  for (const [first, last] of runs) {
    for (let cell = first; cell < last; ++cell) {
      visit(cell % cells.columns, Math.floor(cell / cells.columns), bytes[at++] - 128);
    }
  }
}
