// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

const LARGEST_PICTURE = 2048;  // pixels of a side: textures of phones may be as small as 4096

const HINT = byId("hint").textContent;

/** The chosen plane: its outline and cells in the view, its numbers beside it. */
class Selection {
  constructor(data) {
    this.data = data;
    this.group = new THREE.Group();
    this.clear();
  }

  clear() {
    this.id = null;
    this.empty();
    byId("hint").textContent = HINT;
    byId("plane").replaceChildren(element("h3", {}, "No plane is chosen"),
      element("p", {className: "soft"}, "Click a plane in the picture, or choose one in the list below: "
        + "its numbers, the cells in which it was seen, and its errors appear here."));
  }

  /** Chooses a plane of a model; one that the model does not have is kept in mind. */
  choose(model, id) {
    const index = model.byId.get(id);
    this.id = id;
    this.empty();
    if (index === undefined) {
      byId("hint").textContent = HINT;
      byId("plane").replaceChildren(element("h3", {}, `Plane ${id}`),
        element("p", {}, `${model.name}: there is no such plane.`));
      return;
    }
    const plane = model.planes[index], truth = this.truthOf(plane);
    const picture = plane.cells ? pictureOf(plane.cells) : null;
    this.show(plane, truth, picture);
    byId("hint").textContent = shortText(plane);
    byId("plane").replaceChildren(...this.texts(model, plane, picture));
  }

  empty() {
    for (const child of this.group.children) {
      child.geometry.dispose();
      child.material.map?.dispose();
      child.material.dispose();
    }
    this.group.clear();
  }

  truthOf(plane) {
    const index = plane.verdict?.truth;
    return index === undefined ? null : this.data.truth?.planes[index] ?? null;
  }

  show(plane, truth, picture) {
    const {centre} = this.data;
    if (picture) this.group.add(cellsMesh(plane, picture, centre));
    const options = {depthTest: false, transparent: true};
    if (truth) this.group.add(wideLines(outlineSegments([truth], centre), TRUTH, 2, options));
    this.group.add(wideLines(outlineSegments([plane], centre), "#111111", 3, options));
    this.group.children.forEach((child, i) => { child.renderOrder = 10 + i; });
  }

  texts(model, plane, picture) {
    const label = plane.label ?? {floor: "floor", ceiling: "ceiling"}[plane.kind];
    const nodes = [element("h3", {}, `Plane ${plane.id}${label ? " · " + label : ""}`),
      element("p", {className: "soft"}, model.name), pairsTable(numbersOf(plane, this.truthOf(plane)))];
    if (!picture) {
      nodes.push(element("p", {className: "soft"}, "Its cells are left out of this page to keep it small."));
      return nodes;
    }
    nodes.push(element("h3", {}, "Seen cells"), picture,
      element("p", {className: "soft"}, "Mean distance of the points from the plane: "
        + `blue ${RANGE_MM} mm or more behind it, red before it; side of a cell ${number(100 * plane.cell, 0)} cm. `
        + "Grey was not seen."));
    return nodes;
  }
}

/** Returns the few numbers that fit below the view. */
function shortText(plane) {
  const {verdict} = plane;
  const errors = verdict?.truth === undefined ? "" : `, off by ${number(verdict.angle_deg, 2)}° and `
    + `${number(1e3 * verdict.offset_m, 1)} mm`;
  return `Plane ${plane.id}: ${number(plane.area, 2)} m²${errors}`;
}

function numbersOf(plane, truth) {
  const list = (v, decimals) => v.toArray().map((value) => number(value, decimals)).join(", ");
  const holes = plane.rings.reduce((sum, rings) => sum + rings.length - 1, 0);
  const rows = [["Seen area", `${number(plane.area, 2)} m²`],
    ["Normal", list(plane.normal, 3)],
    ["Distance d", `${number(plane.d, 4)} m`],
    ["Centroid", `${list(plane.centroid, 2)} m`],
    ["Uncertainty (1 σ)", `${number(plane.sigmas[0] * 180 / Math.PI, 3)}°, `
      + `${number(plane.sigmas[1] * 180 / Math.PI, 3)}°, ${number(1e3 * plane.sigmas[2], 2)} mm`],
    ["Outline", `${counted(plane.rings.length, "part")}, ${counted(holes, "hole")}`],
    ["Observations", `${counted(plane.ribbons, "ribbon")}, ${counted(plane.points, "point")}`],
    ["Cells", String(plane.seen)]];
  if (!plane.verdict) return rows;
  rows.push(["Against the truth", VERDICTS[plane.verdict.kind][1]]);
  if (truth) {
    rows.push(["Angle error", `${number(plane.verdict.angle_deg, 3)}°`],
      ["Offset error", `${number(1e3 * plane.verdict.offset_m, 1)} mm`],
      ["True area seen", `${number(truth.area, 2)} m²`]);
  }
  return rows;
}

/** Returns a picture of the cells, rows upwards. */
function pictureOf(cells) {
  const step = Math.ceil(Math.max(cells.columns, cells.rows) / LARGEST_PICTURE);
  const width = Math.ceil(cells.columns / step), height = Math.ceil(cells.rows / step);
  const canvas = element("canvas", {width, height});
  const context = canvas.getContext("2d"), image = context.createImageData(width, height);
  forEachCell(cells, (column, row, mean_mm) => {
    const at = 4 * ((height - 1 - Math.floor(row / step)) * width + Math.floor(column / step));
    image.data.set([...cellColour(mean_mm), 255], at);
  });
  context.putImageData(image, 0, 0);
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", "the seen cells of the plane");
  canvas.cellsPerPixel = step;
  return canvas;
}

/** Returns a rectangle on the plane with the picture of its cells. */
function cellsMesh(plane, picture, centre) {
  const {cells, cell} = plane, side = cell * picture.cellsPerPixel;
  const u = [cells.u * cell, cells.u * cell + side * picture.width];
  const v = [cells.v * cell, cells.v * cell + side * picture.height];
  const corners = [[u[0], v[0]], [u[1], v[0]], [u[1], v[1]], [u[0], v[1]]]
    .flatMap(([x, y]) => pointOn(plane, x, y, centre).toArray());
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(corners), 3));
  geometry.setAttribute("uv", new THREE.BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const map = new THREE.CanvasTexture(picture);
  map.magFilter = THREE.NearestFilter;
  map.generateMipmaps = false;
  map.minFilter = THREE.NearestFilter;
  map.colorSpace = THREE.SRGBColorSpace;
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({map, transparent: true,
    alphaTest: 0.5, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: -2,
    polygonOffsetUnits: -2}));
}
