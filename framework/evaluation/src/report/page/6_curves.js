// SPDX-License-Identifier: Apache-2.0
// One plot of a pixel's costs per level. Any part of an explanation may be missing.
"use strict";

// As wide as it will be shown on a phone, so that its text can be read there.
const kPlot = { width: window.innerWidth < 640 ? 360 : 600, height: 170, left: 12, right: 12, top: 10, bottom: 26 };

function svg(tag, attributes, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

const isNumber = (value) => typeof value === "number" && Number.isFinite(value);
const numberOf = (part) => isNumber(part) ? part : part?.disparity;

/** A line through what is there, between its own smallest and largest; gaps where nothing is. */
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
  const line = svg("path", { d: path, class: name, fill: "none" });
  if (known.length > 80) return [line];
  return [line, ...values.flatMap((v, i) => isNumber(v)
    ? [svg("circle", { cx: toX(i), cy: toY(v), r: 2.4, class: name })] : [])];
}

function axis(first, count, toX) {
  const every = Math.max(1, Math.ceil(count / 8)), ticks = [];
  for (let i = 0; i < count; i += every) {
    const anchor = count === 1 ? "middle" : i === 0 ? "start" : i === count - 1 ? "end" : "middle";
    ticks.push(svg("text", { x: toX(i), y: kPlot.height - 8, "text-anchor": anchor }, `${first + i}`));
  }
  return ticks;
}

function marker(d, first, count, toX, name) {
  if (!isNumber(d) || d < first || d > first + count - 1) return [];
  const x = toX(d - first);
  return [svg("line", { x1: x, x2: x, y1: kPlot.top, y2: kPlot.height - kPlot.bottom, class: name },
    svg("title", {}, `${name}: ${d} px`))];
}

/** What one match searched and found, in words. */
function matchText(match, first, count) {
  const parts = [count > 0 ? `searched ${first} to ${first + count - 1} px` : "nothing to search"];
  for (const [name, part] of [["winner", match.winner], ["runner-up", match.runner_up],
    ["truth", match.truth]]) {
    const d = numberOf(part);
    if (isNumber(d)) parts.push(`${name} ${+d.toFixed(3)} px`);
  }
  if (isNumber(match.shift)) parts.push(`sub-pixel shift ${+match.shift.toFixed(3)} px`);
  if (match.status) parts.push(isNumber(match.disparity)
    ? `result ${+match.disparity.toFixed(3)} px, ${match.status}` : `result: ${match.status}`);
  return parts.join(" · ");
}

function matchPlot(match, title) {
  const [first, last] = Array.isArray(match.range) ? match.range : [0, -1];
  const costs = match.costs ?? [], sums = match.sums ?? [];
  const count = Math.max(last - first + 1, costs.length, sums.length);
  const text = matchText(match, first, count);
  const caption = element("figcaption", {}, element("b", {}, title), ` ${text}`);
  if (costs.length + sums.length === 0) return element("figure", {}, caption);
  const span = kPlot.width - kPlot.left - kPlot.right;
  const toX = (i) => kPlot.left + (count > 1 ? span * i / (count - 1) : span / 2);
  const markers = [["winner", match.winner], ["runner-up", match.runner_up], ["truth", match.truth]];
  return element("figure", {}, caption, svg("svg", { role: "img", "aria-label": `${title}: ${text}`,
    viewBox: `0 0 ${kPlot.width} ${kPlot.height}` },
  ...markers.flatMap(([name, part]) => marker(numberOf(part), first, count, toX, name)),
  ...curve(costs, toX, "costs"), ...curve(sums, toX, "sums"), ...axis(first, count, toX)));
}

function levelPlot(level) {
  const title = `Level ${scaleName(level.scale ?? 1)}`;
  const plots = [matchPlot(level, `${title}:`)];
  if (level.reverse) {
    plots.push(element("details", {}, element("summary", {}, `${title}, from the right image`),
      matchPlot(level.reverse, "At the pixel that the winner points at:")));
  }
  return element("div", {}, ...plots);
}
