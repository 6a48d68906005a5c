// SPDX-License-Identifier: Apache-2.0
// Legends as elements; the static pictures have the same.
"use strict";

/** An element with properties and children; texts become text, never markup. */
function element(tag, properties = {}, ...children) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}

function swatch(colour) {
  const box = element("span", { className: "swatch" });
  box.style.background = colour;
  return box;
}

const percent = (share) => Number.isNaN(share) ? "–" : `${(100 * share).toFixed(2)} %`;

/** Classes without a share have none shown. */
function classLegend(classes, shares, note) {
  const items = classes.map((c, i) => element("li", {}, swatch(c.colour), c.name,
    ...(i < shares.length ? [" ", element("b", {}, percent(shares[i]))] : [])));
  const list = element("ul", { className: "classes" }, ...items);
  return element("div", { className: "legend" }, list, ...(note ? [note()] : []));
}

function rampLegend(ramp, low, high, unit, missing, open) {
  const stops = [], ticks = [];
  for (let i = 0; i <= 16; ++i) stops.push(`rgb(${ramp[Math.floor(255 * i / 16)]})`);
  const decimals = high - low < 10 ? 1 : 0;
  for (let i = 0; i <= 4; ++i) {
    const text = (low + (high - low) * i / 4).toFixed(decimals);
    const before = i === 4 && open ? "≥ " : "", after = i === 4 ? unit : "";
    ticks.push(element("span", {}, before + text + after));
  }
  const bar = element("div", { className: "bar" });
  bar.style.background = `linear-gradient(90deg,${stops})`;
  return element("div", { className: "legend" }, bar,
    element("div", { className: "ticks" }, ...ticks),
    classLegend([{ name: missing, colour: page.missing }], []));
}
