// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

/** The planes of a model, drawn at once: few calls, however many planes. */
class Surfaces {
  constructor(model, centre) {
    this.group = new THREE.Group();
    this.parts = ["shown", "ceiling"].map((part) => {
      const indices = model.planes.map((_, index) => index)
        .filter((index) => (model.planes[index].kind === "ceiling") === (part === "ceiling"));
      return new Part(model, indices, centre);
    });
    for (const part of this.parts) this.group.add(part.mesh, part.edges);
  }

  colour(colourOf) { for (const part of this.parts) part.colour(colourOf); }

  /** Shows ceilings, the backs of planes, and how much of the model shines through (0 to 1). */
  show({weight, ceilings, backs}) {
    this.group.visible = weight > 0;
    this.parts[1].mesh.visible = this.parts[1].edges.visible = ceilings;
    for (const part of this.parts) {
      const material = part.mesh.material;
      material.opacity = weight;
      if (material.transparent !== weight < 1) material.needsUpdate = true;  // another shader
      material.transparent = weight < 1;
      material.depthWrite = weight >= 0.5;
      material.side = backs ? THREE.DoubleSide : THREE.FrontSide;
      part.edges.material.opacity = 0.75 * weight;
      part.edges.material.userData.behind.value = backs ? 1 : EDGE_FROM_BEHIND;
    }
  }

  /** Returns the index of the nearest plane on a ray, or null. */
  pick(raycaster) {
    const hits = this.parts.filter((part) => part.mesh.visible)
      .flatMap((part) => raycaster.intersectObject(part.mesh).slice(0, 1)
        .map((hit) => [hit.distance, part.planeOf(hit.faceIndex)]));
    hits.sort((a, b) => a[0] - b[0]);
    return hits.length > 0 ? hits[0][1] : null;
  }
}

/** Some planes of a model in one mesh, with their outlines. */
class Part {
  constructor(model, indices, centre) {
    this.planes = model.planes;
    this.indices = indices;
    this.firstVertex = [];
    this.firstTriangle = [];
    this.firstEdge = [];
    const points = [], triangles = [], edges = [], normals = [];
    for (const index of indices) {
      const plane = model.planes[index];
      this.addPlane(plane, centre, points, triangles, edges);
      const {x, y, z} = plane.normal;
      while (normals.length < edges.length) normals.push(x, y, z);
    }
    this.mesh = new THREE.Mesh(geometryOf(points, triangles), new THREE.MeshBasicMaterial(
      {vertexColors: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1}));
    this.edges = new THREE.LineSegments(geometryOf(edges), edgeMaterial());
    this.edges.geometry.setAttribute("normal",
      new THREE.BufferAttribute(new Float32Array(normals), 3));
  }

  addPlane(plane, centre, points, triangles, edges) {
    this.firstVertex.push(points.length / 3);
    this.firstTriangle.push(triangles.length / 3);
    this.firstEdge.push(edges.length / 3);
    for (const rings of plane.rings) {
      const flat = rings.map(pointsOfRing);
      const first = points.length / 3;
      for (const ring of flat) {
        const begin = points.length;
        appendCorners(plane, ring, centre, points);
        appendClosed(points, begin, edges);
      }
      for (const face of THREE.ShapeUtils.triangulateShape(flat[0].slice(), flat.slice(1))) {
        triangles.push(...face.map((corner) => first + corner));
      }
    }
  }

  colour(colourOf) {
    this.indices.forEach((index, i) => {
      const plane = this.planes[index], colour = shaded(colourOf(plane), plane.normal);
      fill(this.mesh.geometry, this.firstVertex, i, colour);
      fill(this.edges.geometry, this.firstEdge, i, colour.clone().multiplyScalar(0.35));
    });
    this.mesh.geometry.attributes.color.needsUpdate = true;
    this.edges.geometry.attributes.color.needsUpdate = true;
  }

  planeOf(triangle) {
    let low = 0, high = this.firstTriangle.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.firstTriangle[middle] <= triangle) low = middle; else high = middle;
    }
    return this.indices[low];
  }
}

const EDGE_FROM_BEHIND = 0.22;  // opacity: planes themselves are seen from their front only

/** Returns a material for edges that are faint where their plane is seen from behind. */
function edgeMaterial() {
  const material = new THREE.LineBasicMaterial({vertexColors: true, transparent: true});
  material.userData.behind = {value: EDGE_FROM_BEHIND};
  material.onBeforeCompile = (shader) => {
    shader.uniforms.behind = material.userData.behind;
    shader.vertexShader = "uniform float behind; varying float opacityOfSide;\n"
      + shader.vertexShader.replace("#include <begin_vertex>", "#include <begin_vertex>\n"
        + "opacityOfSide = dot(normal, cameraPosition - position) < 0.0 ? behind : 1.0;");
    shader.fragmentShader = "varying float opacityOfSide;\n" + shader.fragmentShader.replace(
      "#include <color_fragment>", "#include <color_fragment>\ndiffuseColor.a *= opacityOfSide;");
  };
  return material;
}

/** Returns the corners of a ring from the data [m]. */
function pointsOfRing(ring) {
  const points = [];
  for (let i = 0; i < ring.length; i += 2) points.push(new THREE.Vector2(ring[i] / 1e3, ring[i + 1] / 1e3));
  return points;
}

/** Appends the corners of a ring on a plane: x, y, z, x, ... A ring may have very many. */
function appendCorners(plane, ring, centre, points) {
  const {origin, axis_u, axis_v} = plane;
  const x = origin.x - centre.x, y = origin.y - centre.y, z = origin.z - centre.z;
  for (const p of ring) {
    points.push(x + p.x * axis_u.x + p.y * axis_v.x, y + p.x * axis_u.y + p.y * axis_v.y,
      z + p.x * axis_u.z + p.y * axis_v.z);
  }
}

/** Appends the closed line through the points from "begin" on, as pairs of points. */
function appendClosed(points, begin, edges) {
  for (let at = begin; at < points.length; at += 3) {
    const next = at + 3 < points.length ? at + 3 : begin;
    edges.push(points[at], points[at + 1], points[at + 2],
      points[next], points[next + 1], points[next + 2]);
  }
}

function geometryOf(points, triangles = null) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(points), 3));
  geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(points.length), 3));
  if (triangles) geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(triangles), 1));
  return geometry;
}

function fill(geometry, firsts, i, colour) {
  const colours = geometry.attributes.color;
  const end = i + 1 < firsts.length ? firsts[i + 1] : colours.count;
  for (let at = firsts[i]; at < end; ++at) colours.setXYZ(at, colour.r, colour.g, colour.b);
}

/** Returns the outlines of planes as pairs of points: x, y, z, x, ... */
function outlineSegments(planes, centre) {
  const segments = [];
  for (const plane of planes) {
    for (const ring of plane.rings.flat()) {
      const points = [];
      appendCorners(plane, pointsOfRing(ring), centre, points);
      appendClosed(points, 0, segments);
    }
  }
  return segments;
}
