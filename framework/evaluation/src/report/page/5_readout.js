// SPDX-License-Identifier: Apache-2.0
// The values at one pixel, as a table.
"use strict";

const shown = (value, digits = 3) => Number.isNaN(value) ? "–" : value.toFixed(digits);

function row(kind, cells) {
  return element("tr", {}, ...cells.map((cell, i) =>
    element(i === 0 ? "th" : kind, {}, ...[].concat(cell))));
}

function tableOf(head, rows) {
  const table = element("table", {}, element("thead", {}, row("th", head)),
    element("tbody", {}, ...rows.map((cells) => row("td", cells))));
  return element("div", { className: "scroll" }, table);
}

async function runRow(scene, run, runIndex, i) {
  const disparity = (await numbers(run.disparity)).values[i];
  const status = page.statuses[(await unpack(run.status)).codes[i]];
  const value = element("span", { id: `value-${runIndex}` }, shown(disparity));
  const cells = [run.name, value, [swatch(status.colour), status.name]];
  if (scene.truth) {
    const truth = (await numbers(scene.truth)).values[i];
    cells.push(shown(Math.abs(disparity - truth)));
  }
  if (scene.runs.some((r) => r.confidence)) {
    cells.push(run.confidence ? shown((await numbers(run.confidence)).values[i]) : "–");
  }
  return cells;
}

async function levelRow(level, x, y) {
  const i = indexAt(level.grid, x, y);
  const cells = [scaleName(level.grid.scale), shown((await numbers(level.disparity)).values[i]),
    page.statuses[(await unpack(level.status)).codes[i]].name];
  if (level.first) {
    const first = (await numbers(level.first)).values[i], last = (await numbers(level.last)).values[i];
    cells.push(Number.isNaN(first) ? "nothing" : `${first} to ${last}`);
  } else {
    cells.push("–");
  }
  return cells;
}

/** What is known of pixel (x, y) of the scene. */
async function readout(scene, x, y) {
  const i = indexAt(scene.grid, x, y);
  const rows = await Promise.all(scene.runs.map((run, r) => runRow(scene, run, r, i)));
  const heading = element("p", {}, element("b", {}, `Pixel x = ${x}, y = ${y}`));
  const head = ["Pipeline", "Disparity, px", "Status"];
  if (scene.truth) {
    heading.append(` · truth ${shown((await numbers(scene.truth)).values[i])} px`);
    head.push("Error, px");
  }
  if (scene.runs.some((r) => r.confidence)) head.push("Confidence");
  const parts = [heading, tableOf(head, rows)];
  for (const run of scene.runs.filter((r) => r.levels.length > 0)) {
    const levels = await Promise.all(run.levels.map((level) => levelRow(level, x, y)));
    const table = tableOf(["Level", "Disparity, px", "Status", "Searched, px"], levels);
    parts.push(element("details", { open: scene.runs.length === 1 },
      element("summary", {}, `Levels of ${run.name}, in their own pixels`), table));
  }
  return parts;
}
