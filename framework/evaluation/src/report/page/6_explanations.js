// SPDX-License-Identifier: Apache-2.0
// Pixels of which the run kept what happened to them.
"use strict";

function curveLegend() {
  const entries = [["costs", "matching cost"], ["sums", "aggregated cost"], ["winner", "winner"],
    ["runner-up", "runner-up"], ["truth", "truth"]];
  return element("ul", { className: "classes" }, ...entries.map(([name, text]) =>
    element("li", {}, svg("svg", { viewBox: "0 0 24 12", class: "key" },
      svg("line", { x1: 0, x2: 24, y1: 6, y2: 6, class: name })), text)));
}

/** What every stage did, in the order of the run. */
function eventTable(events) {
  const rows = events.map((e) => [e.stage ?? "", e.plugin ?? "", e.effect ?? "", e.text ?? ""]);
  return element("details", {}, element("summary", {}, "What each stage did to it"),
    tableOf(["Stage", "Plugin", "Effect", ""], rows));
}

/** Everything to be shown of one explained pixel. */
function explanationParts(point) {
  const levels = Array.isArray(point.levels) ? point.levels : [];
  const parts = [point.verdict, point.diagnosis].filter(Boolean)
    .map((text) => element("p", {}, text));
  if (levels.length > 0) {
    const plots = element("div", { className: "plots" }, ...levels.map(levelPlot));
    parts.push(curveLegend(), plots, element("p", { className: "note" },
      "Each curve spans the height between its own smallest and largest value; a gap is a " +
      "disparity that cannot be matched. Disparities are px of the level."));
  } else {
    parts.push(element("p", {}, "No level is known of this pixel."));
  }
  if (Array.isArray(point.events) && point.events.length > 0) parts.push(eventTable(point.events));
  return parts;
}

/** {run, point} of every explained pixel of a scene. */
function explainedPoints(scene) {
  return scene.runs.flatMap((run) => run.explanations
    .filter((point) => isNumber(point?.x) && isNumber(point?.y)).map((point) => ({ run, point })));
}
