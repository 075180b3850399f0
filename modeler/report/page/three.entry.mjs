// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the page needs of three.js; see bundle_three.
export { Box3, BufferAttribute, BufferGeometry, CanvasTexture, Color, ConeGeometry, DoubleSide,
  FrontSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, NearestFilter,
  PerspectiveCamera, Raycaster, Scene, ShapeUtils, SRGBColorSpace, Vector2, Vector3,
  WebGLRenderer } from "three";
export { OrbitControls } from "three/addons/controls/OrbitControls.js";
export { LineMaterial } from "three/addons/lines/LineMaterial.js";
export { LineSegments2 } from "three/addons/lines/LineSegments2.js";
export { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
