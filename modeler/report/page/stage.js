// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

const UP = new THREE.Vector3(0, 0, 1);

/** The 3D view: camera, picking, and labels over it. It draws only when something has changed. */
class Stage {
  constructor(view) {
    this.view = view;
    this.renderer = new THREE.WebGLRenderer({antialias: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setClearColor("#f4f6f8");
    view.prepend(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(40, 1, 0.05, 2000);
    this.camera.up.copy(UP);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.maxPolarAngle = 0.97 * Math.PI;
    this.controls.addEventListener("change", () => this.change());
    this.controls.addEventListener("start", () => { this.isTurned = true; });
    this.tags = [];
    this.frames = 0;
    this.onFit = () => {};
    new ResizeObserver(() => this.fit()).observe(view);
    view.addEventListener("keydown", (event) => this.onKey(event));
    this.fit();
  }

  /** Calls a function with the ray of each click that is no drag. */
  onClick(use) {
    const canvas = this.renderer.domElement;
    let down = null;
    canvas.addEventListener("pointerdown", (event) => { down = event; });
    canvas.addEventListener("pointerup", (event) => {
      const moved = down ? Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) : 99;
      if (moved < 6) use(this.rayAt(event.clientX, event.clientY));
    });
  }

  rayAt(x, y) {
    const box = this.renderer.domElement.getBoundingClientRect();
    const raycaster = new THREE.Raycaster();
    raycaster.setFromCamera(new THREE.Vector2(2 * (x - box.left) / box.width - 1,
      1 - 2 * (y - box.top) / box.height), this.camera);
    return raycaster;
  }

  /** Returns where a point is drawn, in pixels of the view, or null behind the camera. */
  project(point) {
    const on = point.clone().project(this.camera);
    if (on.z > 1) return null;
    return [(on.x + 1) / 2 * this.view.clientWidth, (1 - on.y) / 2 * this.view.clientHeight];
  }

  /** Turns the camera to a box, from an azimuth and a height above it [rad]. */
  look(box, azimuth, elevation) {
    const centre = box.getCenter(new THREE.Vector3());
    const direction = new THREE.Vector3(Math.cos(azimuth) * Math.cos(elevation),
      Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation));
    const away = Math.max(1, 1.03 * this.distanceFor(box, centre, direction));
    this.camera.far = 20 * away;
    this.camera.near = away / 500;
    this.camera.updateProjectionMatrix();
    this.camera.position.copy(centre).addScaledVector(direction, away);
    this.controls.target.copy(centre);
    this.controls.update();
    this.change();
  }

  /** Returns how far in this direction the camera must be to see all corners of a box. */
  distanceFor(box, centre, direction) {
    const right = UP.clone().cross(direction).normalize(), up = direction.clone().cross(right);
    const high = Math.tan(this.camera.fov * Math.PI / 360), wide = high * this.camera.aspect;
    let away = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const [x, y, z] = [0, 1, 2].map((k) => ((corner >> k) & 1 ? box.max : box.min).getComponent(k));
      const to = new THREE.Vector3(x, y, z).sub(centre);
      away = Math.max(away, to.dot(direction) + Math.abs(to.dot(right)) / wide,
        to.dot(direction) + Math.abs(to.dot(up)) / high);
    }
    return away;
  }

  onKey(event) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const turn = {ArrowLeft: -0.1, ArrowRight: 0.1}[event.key];
    const tilt = {ArrowUp: -0.07, ArrowDown: 0.07}[event.key];
    const zoom = {"+": 0.87, "=": 0.87, "-": 1.15}[event.key];
    if (turn) offset.applyAxisAngle(UP, turn);
    if (tilt) {
      const polar = offset.angleTo(UP) + tilt;
      if (polar < 0.02 || polar > 0.97 * Math.PI) return;
      offset.applyAxisAngle(UP.clone().cross(offset).normalize(), tilt);
    }
    if (zoom) offset.multiplyScalar(zoom);
    if (!turn && !tilt && !zoom) return;
    event.preventDefault();
    this.isTurned = true;
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.change();
  }

  fit() {
    const width = Math.max(1, this.view.clientWidth), height = Math.max(1, this.view.clientHeight);
    if (this.size && this.size[0] === width && this.size[1] === height) return;
    const isFirst = !this.size;  // nothing is there to be drawn yet
    this.size = [width, height];
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(width, height, false);
    if (isFirst) return;
    if (!this.isTurned) this.onFit();
    this.draw();  // at once: a new size empties the picture
  }

  /** Draws soon, once for all changes until then. */
  change() {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(() => { this.waits = false; this.draw(); });
  }

  draw() {
    ++this.frames;
    this.renderer.render(this.scene, this.camera);
    this.placeTags();
  }

  /** Shows texts at points: {point, normal (or none), text, kind}. */
  setTags(tags) {
    this.tags = tags.map((tag) => ({...tag, node: element("span", {className: tag.kind}, tag.text)}));
    byId("tags").replaceChildren(...this.tags.map((tag) => tag.node));
    for (const tag of this.tags) tag.box = tag.node.getBoundingClientRect();
    this.change();
  }

  placeTags() {
    const taken = [];
    for (const tag of this.tags) {
      const at = this.project(tag.point);
      const away = tag.normal && tag.normal.dot(this.camera.position.clone().sub(tag.point)) < 0;
      const {width, height} = tag.box;
      const hidden = !at || away || taken.some(([x, y, w, h]) =>
        Math.abs(at[0] - x) < (width + w) / 2 && Math.abs(at[1] - y) < (height + h) / 2);
      tag.node.style.display = hidden ? "none" : "";
      if (hidden) continue;
      taken.push([at[0], at[1], width, height]);
      tag.node.style.transform = `translate(${at[0]}px, ${at[1]}px) translate(-50%, -50%)`;
    }
  }
}
