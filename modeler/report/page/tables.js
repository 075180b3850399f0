// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause

const LONGEST_LIST = 500;  // rows: more would make phones slow

function tableOf(head, rows) {
  const cells = (tag, texts) => texts.map((text) => element(tag, {}, text));
  return element("table", {}, element("thead", {}, element("tr", {}, ...cells("th", head))),
    element("tbody", {}, ...rows.map((row) => element("tr", {}, ...cells("td", row)))));
}

/** Shows what does not change: tables, figures of the run, parameters, version and command. */
function showTexts(data) {
  document.title = byId("title").textContent = data.title;
  const models = data.models.map((model) => `${model.name}: ${counted(model.planes.length, "plane")}`);
  byId("subtitle").textContent = models.join(" · ");
  for (const table of data.tables) {
    byId("tables").append(element("h2", {}, table.title),
      element("div", {className: "scroll", tabIndex: 0}, tableOf(table.head, table.rows)));
  }
  if (data.facts.length > 0) {
    byId("facts").append(element("h2", {}, "Figures"), element("dl", {},
      ...data.facts.flatMap(([name, value]) => [element("dt", {}, name), element("dd", {}, value)])));
  }
  showParameters(data);
  const command = data.command ? [element("p", {}, "Made by"), element("p", {}, element("code", {}, data.command))] : [];
  byId("footer").append(...command, element("p", {}, [data.version, data.run && `run ${data.run}`,
    `coordinates in the frame ${data.frame}, in metres`].filter(Boolean).join(" · ")));
}

function showParameters(data) {
  if (data.parameters === null) return;
  const section = byId("parameters");
  section.append(element("h2", {}, "Parameters"));
  if (data.parameters.length === 0) {
    section.append(element("p", {}, "All keys of the configuration are at their defaults."));
    return;
  }
  section.append(element("p", {className: "soft"}, "All other keys of the configuration are at their defaults."),
    element("div", {className: "scroll", tabIndex: 0}, tableOf(["key", "value", "default"], data.parameters)));
}

/** Lists the planes of a model, so that they can be chosen without a mouse. */
function showList(model, chosenId, choose) {
  const section = byId("planes"), wasOpen = section.querySelector("details")?.open ?? false;
  const order = [...model.planes].sort((a, b) => b.area - a.area).slice(0, LONGEST_LIST);
  const rows = order.map((plane) => rowOf(plane, plane.id === chosenId, choose));
  const head = ["plane", "kind", "area [m²]", "height [m]", "angle error [°]", "offset error [mm]", "ribbons"];
  const table = tableOf(head, []);
  table.querySelector("tbody").append(...rows);
  const left = model.planes.length - order.length;
  section.replaceChildren(element("details", {open: wasOpen},
    element("summary", {}, `Planes, ${model.name} (${model.planes.length})`),
    element("div", {className: "scroll tall"}, table),
    ...(left > 0 ? [element("p", {className: "soft"}, `${counted(left, "smaller plane")} left out of this list.`)] : [])));
}

function rowOf(plane, isChosen, choose) {
  const button = element("button", {type: "button", onclick: () => choose(plane.id)}, String(plane.id));
  const texts = [plane.label ?? (plane.kind === "other" ? plane.verdict?.kind ?? "" : plane.kind), number(plane.area, 2),
    number(plane.centroid.z, 2), number(plane.verdict?.angle_deg, 2), number(1e3 * plane.verdict?.offset_m, 1),
    String(plane.ribbons)];
  const row = element("tr", {}, element("td", {}, button), ...texts.map((text) => element("td", {}, text)));
  row.setAttribute("aria-selected", isChosen);
  return row;
}
