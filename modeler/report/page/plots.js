// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

// As wide as its place, so that its text is as large as that of the page.
const PLOT = {width: Math.max(300, Math.min(560, document.body.clientWidth - 32)), height: 220, left: 52, right: 12, top: 12, bottom: 40};
const SERIES = ["#9aa3ab", PATH, "#2f6d9e", "#6b8f5e"];

function svg(tag, attributes, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

/** Returns about four round values from 0 to `largest`. */
function ticks(largest) {
  const raw = largest / 4, scale = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * scale).find((value) => value >= raw);
  const values = [];
  for (let i = 0; i * step <= largest * 1.0001; ++i) values.push(i * step);
  return [values, Math.max(0, -Math.floor(Math.log10(step) + 1e-9))];
}

/** Draws series {name, points: [[x, y], ...], marks} over axes from 0. */
function plot(title, xName, yName, series) {
  const all = series.flatMap((one) => one.points);
  if (all.length === 0) return;
  const xMost = Math.max(1e-3, ...maxima(all, 0)), yMost = Math.max(1e-3, ...maxima(all, 1)) * 1.05;
  const x = (v) => PLOT.left + v / xMost * (PLOT.width - PLOT.left - PLOT.right);
  const y = (v) => PLOT.height - PLOT.bottom - v / yMost * (PLOT.height - PLOT.top - PLOT.bottom);
  const picture = svg("svg", {viewBox: `0 0 ${PLOT.width} ${PLOT.height}`, role: "img", "aria-label": title});
  const [xs, xDecimals] = ticks(xMost), [ys, yDecimals] = ticks(yMost);
  for (const v of ys) {
    picture.append(svg("line", {x1: PLOT.left, x2: PLOT.width - PLOT.right, y1: y(v), y2: y(v), stroke: "#d8dde2"}),
      svg("text", {x: PLOT.left - 6, y: y(v) + 4, "text-anchor": "end"}, number(v, yDecimals)));
  }
  for (const v of xs) {
    picture.append(svg("text", {x: x(v), y: PLOT.height - PLOT.bottom + 16, "text-anchor": "middle"}, number(v, xDecimals)));
  }
  picture.append(svg("text", {x: (PLOT.left + PLOT.width) / 2, y: PLOT.height - 6, "text-anchor": "middle"}, xName));
  series.forEach((one, i) => picture.append(...marksOf(one, one.colour ?? SERIES[i], x, y)));
  const legend = series.map((one, i) => {
    const swatch = element("span", {className: "swatch"});
    swatch.style.background = one.colour ?? SERIES[i];
    return element("span", {}, swatch, one.name);
  });
  byId("plots").append(element("figure", {}, element("figcaption", {}, title), element("p", {className: "soft"}, yName),
    picture, element("p", {className: "soft wrap"}, ...legend)));
}

const maxima = (points, axis) => [points.reduce((most, point) => Math.max(most, point[axis]), 0)];

function marksOf(one, colour, x, y) {
  if (one.marks) {
    return one.points.map(([a, b]) => svg("circle", {cx: x(a), cy: y(b), r: 3.5, fill: colour, "fill-opacity": 0.8}));
  }
  const path = one.points.map(([a, b], i) => `${i === 0 ? "M" : "L"}${x(a).toFixed(1)} ${y(b).toFixed(1)}`).join("");
  return [svg("path", {d: path, fill: "none", stroke: colour, "stroke-width": 1.8})];
}

/** Returns the distance of two trajectories over time: [s, m]. Empty if their poses differ. */
function distances(a, b) {
  if (a.time_ms.length !== b.time_ms.length) return [];
  return a.time_ms.map((time_ms, i) => {
    const d = [0, 1, 2].map((k) => (a.points_mm[3 * i + k] - b.points_mm[3 * i + k]) / 1e3);
    return [time_ms / 1e3, Math.hypot(...d)];
  });
}

function showPlots(data) {
  const {trajectories, truth} = data;
  if (truth) {
    plot("Position error of the trajectory", "time [s]", "distance from the true position [m]",
      trajectories.map((one) => ({name: one.name, points: distances(one, truth.trajectory)})));
  } else if (trajectories.length > 1) {
    plot("What the correction moved", "time [s]", "distance between the two trajectories [m]",
      [{name: "correction", colour: PATH, points: distances(trajectories[0], trajectories.at(-1))}]);
  }
  const last = data.models.at(-1);
  const measured = last ? last.planes.filter((plane) => plane.verdict?.kind === "matched") : [];
  plot(`Offset error of each plane, ${last?.name}`, "seen area [m²]", "distance of the centroid from the true plane [mm]",
    [{name: "plane", colour: "#2f6d9e", marks: true,
      points: measured.map((plane) => [plane.area, 1e3 * Math.abs(plane.verdict.offset_m ?? 0)])}].filter((s) => s.points.length > 0));
}
