// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

const SNAP = 0.06;  // of the slider, at a model
const MOST_TAGS = 60;

/** Says what has gone wrong, where the user looks. */
function complain(text) {
  byId("message").textContent = text;
  byId("message").hidden = false;
}

/** The page: what is shown, and what the controls change. */
class Page {
  constructor(data) {
    this.data = data;
    this.position = Math.max(0, data.models.length - 1);
    this.switches = {};
    this.stage = new Stage(byId("view"));
    this.surfaces = data.models.map(() => null);  // made when they are first seen
    this.path = new Path(data);
    this.truth = new THREE.Group();  // filled when it is first seen
    this.rooms = roomLines(data);
    this.selection = new Selection(data);
    this.stage.scene.add(this.path.group, this.truth, this.rooms, this.selection.group);
    this.addSwitches();
    this.addColours();
    this.addSliders();
    byId("from_above").onclick = () => { this.stage.isTurned = true; this.look(Math.PI / 2 * 0.999); };
    byId("from_home").onclick = () => { this.stage.isTurned = false; this.look(); };
    this.stage.onClick((ray) => this.pick(ray));
    document.addEventListener("keydown", (event) => { if (event.key === "Escape") this.choose(null); });
    this.stage.onFit = () => this.look();
    this.look();
    this.moveTo(this.position);
  }

  get model() { return this.data.models[Math.round(this.position)]; }

  addSwitches() {
    const {data} = this;
    const offered = [["path", "Trajectory", true, data.trajectories.length > 0],
      ["truth", "Truth", false, data.truth !== null], ["rooms", "Rooms", true, data.rooms.length > 0],
      ["tags", data.models.some((m) => m.planes.some((p) => p.label)) ? "Labels" : "Numbers", false, true],
      ["ceilings", "Ceilings", false, true], ["backs", "Backs of planes", false, true]];
    for (const [name, text, on, isOffered] of offered) {
      const box = element("input", {type: "checkbox", checked: on && isOffered, id: `show_${name}`});
      box.onchange = () => this.update();
      this.switches[name] = box;
      if (isOffered) byId("switches").append(element("label", {}, box, " ", text));
    }
  }

  addColours() {
    const select = byId("colours"), ways = colourings(this.data);
    select.append(...ways.map((way, i) => element("option", {value: i}, way.name)));
    select.onchange = () => {
      const way = ways[Number(select.value)];
      this.colourOf = way.colourOf;
      for (const one of this.surfaces) one?.colour(way.colourOf);
      showLegend(way.legend);
      this.stage.change();
    };
    select.onchange();
  }

  addSliders() {
    const {models, trajectories} = this.data, slider = byId("model");
    slider.max = Math.max(models.length - 1, 0);
    slider.value = this.position;
    byId("model_row").hidden = models.length < 2;
    slider.oninput = () => {
      const value = Number(slider.value), near = Math.round(value);
      this.moveTo(Math.abs(value - near) < SNAP ? near : value);
    };
    byId("stops").append(...models.map((model, i) => element("button",
      {type: "button", onclick: () => { slider.value = i; this.moveTo(i); }}, model.name)));
    const poses = Math.max(0, ...trajectories.map((one) => one.time_ms.length));
    byId("time_row").hidden = poses < 2;
    byId("time").max = Math.max(poses - 1, 0);
    byId("time").value = byId("time").max;
    byId("time").oninput = () => this.showTime();
  }

  /** Shows a model, or two that lie beside the position. */
  moveTo(position) {
    const before = this.model;
    this.position = position;
    this.path.place(position);
    [...byId("stops").children].forEach((button, i) => button.setAttribute("aria-pressed", i === position));
    if (this.model !== before || !this.isListed) this.showModel();
    this.update();
  }

  showModel() {
    this.isListed = true;
    if (this.model) showList(this.model, this.selection.id, (id) => this.choose(id, true));
    if (this.model && this.selection.id !== null) this.selection.choose(this.model, this.selection.id);
  }

  surfacesOf(index) {
    if (!this.surfaces[index]) {
      const made = new Surfaces(this.data.models[index], this.data.centre);
      made.colour(this.colourOf);
      this.stage.scene.add(made.group);
      this.surfaces[index] = made;
    }
    return this.surfaces[index];
  }

  update() {
    const on = (name) => this.switches[name].checked;
    this.surfaces.forEach((one, i) => {
      const weight = Math.max(0, 1 - Math.abs(this.position - i));
      if (one || weight > 0) {
        this.surfacesOf(i).show({weight, ceilings: on("ceilings"), backs: on("backs")});
      }
    });
    this.truth.visible = on("truth");
    if (on("truth") && this.truth.children.length === 0) this.truth.add(...truthLines(this.data));
    this.rooms.visible = on("rooms") && this.data.rooms.length > 0;
    this.path.group.visible = on("path") && this.data.trajectories.length > 0;
    this.stage.setTags(this.tags());
    this.showTime();
  }

  tags() {
    const {centre, rooms} = this.data, tags = [];
    if (this.switches.rooms.checked) {
      tags.push(...rooms.map((room) => ({text: `${room.name}, ${number(room.area_m2, 1)} m²`, kind: "room",
        point: middleOf(room).sub(centre)})));
    }
    if (!this.switches.tags.checked || !this.model) return tags;
    const shown = this.model.planes.filter((plane) => plane.kind !== "ceiling" || this.switches.ceilings.checked)
      .sort((a, b) => b.area - a.area).slice(0, MOST_TAGS);
    return tags.concat(shown.map((plane) => ({text: [plane.id, plane.label].filter((x) => x !== undefined).join(" "),
      kind: "plane", point: plane.centroid.clone().sub(centre), normal: plane.normal})));
  }

  showTime() {
    const index = Number(byId("time").value);
    this.path.at(index);
    const times = this.path.trajectory?.time_ms ?? [0];
    const now = times[Math.min(index, times.length - 1)] ?? 0;
    byId("time_text").textContent = `${number(now / 1e3, 1)} of ${number((times.at(-1) ?? 0) / 1e3, 1)} s`;
    this.stage.change();
  }

  pick(ray) {
    const index = this.surfaces[Math.round(this.position)]?.pick(ray) ?? null;
    this.choose(index === null ? null : this.model.planes[index].id);
  }

  choose(id, scroll = false) {
    if (id === null) this.selection.clear(); else this.selection.choose(this.model, id);
    if (this.model) showList(this.model, id, (other) => this.choose(other, true));
    if (scroll) byId("view").scrollIntoView({block: "nearest"});
    this.stage.change();
  }

  /** Looks at the whole model, from the side of the first pose if there is one. */
  look(elevation = 0.92) {
    const box = new THREE.Box3(), {centre, models} = this.data;
    for (const plane of models.at(-1)?.planes ?? []) {
      for (const rings of plane.rings) {
        for (const p of pointsOfRing(rings[0])) box.expandByPoint(pointOn(plane, p.x, p.y, centre));
      }
    }
    if (box.isEmpty()) box.expandByPoint(new THREE.Vector3()).expandByScalar(2);
    const size = box.getSize(new THREE.Vector3());
    const wide = this.stage.camera.aspect > 1 === size.x > size.y;  // the long side across
    this.stage.look(box, wide ? -Math.PI / 2 - (elevation < 1.5 ? 0.35 : 0) : (elevation < 1.5 ? 0.35 : 0), elevation);
  }
}

/** Returns where the name of a room stands: a ring's middle would be outside it. */
function middleOf(room) {
  if (room.centre_mm) return new THREE.Vector3(...room.centre_mm).divideScalar(1e3);
  const box = new THREE.Box3();
  for (const ring of room.outlines_mm.flat()) {
    for (let i = 0; i < ring.length; i += 3) box.expandByPoint(new THREE.Vector3(...ring.slice(i, i + 3)).divideScalar(1e3));
  }
  return box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3());
}

function begin() {
  const data = readData();
  showTexts(data);
  showPlots(data);
  try {
    window.report = new Page(data);
  } catch (error) {
    if (!/WebGL/i.test(String(error))) throw error;
    byId("stage").querySelector("#view").hidden = true;
    complain("This browser cannot draw in 3D: WebGL 2 is missing or switched off. The numbers are below.");
  }
  // The frame after the first: that one has been handed over then.
  requestAnimationFrame(() => requestAnimationFrame(() => {
    document.documentElement.dataset.firstPictureMs = performance.now().toFixed(0);
  }));
}

window.addEventListener("error", (event) => complain(`The page failed: ${event.message}`));
begin();
