// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

const FLOOR = "#c3c7cb", CEILING = "#dfe2e5";
const CALM = ["#8fb3cf", "#a9c6a3", "#dcbd9f", "#b9a9cc", "#cfc38f", "#8fc3bd", "#d8adae",
  "#a7b4d8", "#bfc7a0", "#c9b2a6"];
const VERDICTS = {matched: ["#7fb0a2", "matches a true plane"],
  duplicate: ["#e0a458", "a further plane on a true plane"],
  extra: ["#cc6f66", "on no true plane"]};
const LABELS = {floor: FLOOR, ceiling: CEILING, wall: "#a8bfd3", "door leaf": "#c9a27e",
  "table or shelf top": "#a9c6a3", slope: "#b9a9cc", "other furniture": "#d8adae"};
const OTHER = "#d5d0c8";

/** The ways to colour planes that the data allow: name, colour of a plane, and its legend. */
function colourings(data) {
  const planes = data.models.flatMap((model) => model.planes);
  const found = [{name: "by plane", colourOf: colourByPlane, legend: [[FLOOR, "floor; every other plane has a colour of its own"]]}];
  if (planes.some((plane) => plane.label)) found.push(byLabel(planes));
  if (planes.some((plane) => plane.verdict)) {
    found.push({name: "against the truth", legend: Object.values(VERDICTS),
      colourOf: (plane) => plane.verdict ? VERDICTS[plane.verdict.kind][0] : OTHER});
  }
  return found;
}

function colourByPlane(plane) {
  if (plane.kind === "floor") return FLOOR;
  if (plane.kind === "ceiling") return CEILING;
  return CALM[((plane.id * 7) % CALM.length + CALM.length) % CALM.length];
}

function byLabel(planes) {
  const labels = [...new Set(planes.map((plane) => plane.label).filter(Boolean))].sort();
  return {name: "by label", colourOf: (plane) => LABELS[plane.label] ?? OTHER,
    legend: labels.map((label) => [LABELS[label] ?? OTHER, label])};
}

/** Fills the legend with swatches. */
function showLegend(legend) {
  byId("legend").replaceChildren(...legend.map(([colour, text]) => {
    const swatch = element("span", {className: "swatch"});
    swatch.style.background = colour;
    return element("span", {}, swatch, text);
  }));
}

const LIGHT = new THREE.Vector3(0.35, -0.5, 0.8).normalize();

/** Returns a colour as it looks on a plane with this normal: no light needs to be computed. */
function shaded(colour, normal) {
  return new THREE.Color(colour).multiplyScalar(0.74 + 0.26 * (0.5 + 0.5 * normal.dot(LIGHT)));
}

const RANGE_MM = 10;  // of a cell's mean distance from its plane: beyond it, colours are full
const BELOW = [47, 95, 160], NONE = [238, 236, 230], ABOVE = [186, 74, 52];

/** Returns the colour of a cell: blue behind the plane, red before it. */
function cellColour(mean_mm) {
  const share = Math.min(1, Math.abs(mean_mm) / RANGE_MM), to = mean_mm < 0 ? BELOW : ABOVE;
  return NONE.map((value, i) => Math.round(value + share * (to[i] - value)));
}
