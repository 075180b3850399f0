"use strict";
// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

// Texts of the data reach the page by textContent only, so that they are never read as HTML.

/** Returns the element with this id. */
const byId = (id) => document.getElementById(id);

/** Returns a new element with properties and children: nodes or texts. */
function element(tag, properties = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in node) node[name] = value; else node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

/** Returns a number with decimals and a true minus sign, or a dash for none. */
function number(value, decimals) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const text = value.toFixed(decimals);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}

/** Returns a table of two columns, in which nothing is a head. */
function pairsTable(pairs) {
  const rows = pairs.map(([name, value]) =>
    element("tr", {}, element("td", {className: "soft"}, name), element("td", {}, value)));
  return element("table", {className: "numbers"}, element("tbody", {}, ...rows));
}

/** Returns "1 plane" or "2 planes". */
const counted = (count, noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;
