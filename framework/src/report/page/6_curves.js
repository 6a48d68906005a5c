// SPDX-License-Identifier: Apache-2.0
// Cost curves of the pixels that the run kept. Any part of an explanation may be missing.
"use strict";

const kPlot = { width: 640, height: 170, left: 8, right: 8, top: 10, bottom: 26 };

function svg(tag, attributes, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

/** Lines through what is there, each between 0 and 1 of its own largest; gaps where nothing is. */
function curve(values, toX, name) {
  const known = values.filter(isNumber);
  if (known.length === 0) return [];
  const low = Math.min(...known), high = Math.max(...known);
  const inner = kPlot.height - kPlot.top - kPlot.bottom;
  const toY = (v) => kPlot.top + inner * (1 - (high > low ? (v - low) / (high - low) : 0));
  let path = "", pen = "M";
  values.forEach((v, i) => {
    if (isNumber(v)) path += `${pen}${toX(i).toFixed(1)} ${toY(v).toFixed(1)}`;
    pen = isNumber(v) ? "L" : "M";
  });
  const points = values.flatMap((v, i) => isNumber(v)
    ? [svg("circle", { cx: toX(i), cy: toY(v), r: 2.4, class: name })] : []);
  return [svg("path", { d: path, class: name, fill: "none" }), ...(known.length < 80 ? points : [])];
}

function axis(first, count, toX) {
  const every = Math.max(1, Math.ceil(count / 8));
  const ticks = [];
  for (let i = 0; i < count; i += every) {
    const anchor = i === 0 ? "start" : "middle";
    ticks.push(svg("text", { x: toX(i), y: kPlot.height - 8, "text-anchor": anchor }, `${first + i}`));
  }
  return ticks;
}

function marker(d, first, toX, name, label) {
  if (!isNumber(d)) return [];
  const x = toX(d - first);
  return [svg("line", { x1: x, x2: x, y1: kPlot.top, y2: kPlot.height - kPlot.bottom, class: name },
    svg("title", {}, `${label}: ${d} px`))];
}

function levelPlot(level) {
  const [first, end] = Array.isArray(level.range) ? level.range : [0, 0];
  const count = Math.max(end - first, level.costs?.length ?? 0, level.sums?.length ?? 0);
  const title = `Level ${scaleName(level.scale ?? 1)}`;
  const known = [["winner", level.winner], ["runner-up", level.runner_up]]
    .filter(([, d]) => isNumber(d)).map(([name, d]) => `${name} ${d} px`);
  const text = count > 0 ? [`searched ${first} to ${first + count - 1} px`, ...known].join(" · ")
    : "nothing was searched";
  const caption = element("figcaption", {}, element("b", {}, title), ` ${text}`);
  if (count === 0) return element("figure", {}, caption);
  const span = kPlot.width - kPlot.left - kPlot.right;
  const toX = (i) => kPlot.left + (count > 1 ? span * i / (count - 1) : span / 2);
  const plot = svg("svg", { viewBox: `0 0 ${kPlot.width} ${kPlot.height}`, role: "img",
    "aria-label": `${title}: ${text}` },
    ...marker(level.winner, first, toX, "winner", "winner"),
    ...marker(level.runner_up, first, toX, "runner-up", "runner-up"),
    ...curve(level.costs ?? [], toX, "costs"), ...curve(level.sums ?? [], toX, "sums"),
    ...axis(first, count, toX));
  return element("figure", {}, caption, plot);
}

function curveLegend() {
  const entries = [["costs", "matching cost"], ["sums", "aggregated cost"], ["winner", "winner"],
    ["runner-up", "runner-up"]];
  return element("ul", { className: "classes" }, ...entries.map(([name, text]) =>
    element("li", {}, svg("svg", { viewBox: "0 0 24 12", class: "key" },
      svg("line", { x1: 0, x2: 24, y1: 6, y2: 6, class: name })), text)));
}

/** Everything to be shown of one explained pixel. */
function curvePlots(point) {
  const levels = Array.isArray(point.levels) ? point.levels : [];
  if (levels.length === 0) return [element("p", {}, "No level is known of this pixel.")];
  const note = element("p", { className: "note" },
    "Each curve spans the height between its own smallest and largest value.");
  return [curveLegend(), ...levels.map(levelPlot), note];
}

/** {run, point} of every explained pixel of a scene. */
function explainedPoints(scene) {
  return scene.runs.flatMap((run) => (Array.isArray(run.explanations) ? run.explanations : [])
    .filter((point) => isNumber(point?.x) && isNumber(point?.y)).map((point) => ({ run, point })));
}
