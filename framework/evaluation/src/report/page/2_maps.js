// SPDX-License-Identifier: Apache-2.0
// The page's data: maps of numbers and of codes, unpacked when they are first needed.
"use strict";

const page = JSON.parse(document.getElementById("data").textContent);

/** Unpacks once; everybody who asks gets the same promise. */
function unpack(packed) {
  packed.decoded ??= decodePng(packed.png);
  return packed.decoded;
}

/** {cols, rows, values}: NaN where there is no number. */
async function numbers(packed) {
  const png = await unpack(packed);
  packed.values ??= Float64Array.from(png.codes, (code) =>
    code === 0 ? NaN : (packed.first + code) * packed.step);
  return { cols: png.cols, rows: png.rows, values: packed.values };
}

/** Index of the shown pixel that stands for pixel (x, y) of the scene. */
function indexAt(grid, x, y) {
  const cell = (v, size) =>
    Math.min(Math.floor(v / grid.scale), size - 1) / grid.stride | 0;
  const cols = Math.ceil(grid.width / grid.stride);
  return cell(y, grid.height) * cols + cell(x, grid.width);
}

/** The pixel of the scene whose values are shown at and around (x, y). */
function snapped(grid, x, y) {
  const one = (v, size) => {
    const inside = Math.min(Math.max(Math.floor(v), 0), size - 1);
    return Math.min(Math.floor(inside / grid.stride) * grid.stride + (grid.stride >> 1), size - 1);
  };
  return { x: one(x, grid.width), y: one(y, grid.height) };
}

async function errors(scene, run) {
  const map = await numbers(run.disparity), truth = await numbers(scene.truth);
  return { ...map, values: map.values.map((d, i) => Math.abs(d - truth.values[i])) };
}

const kVisible = 255;

/** Indices of page.verdicts. */
async function verdicts(scene, run, delta, region) {
  const map = await numbers(run.disparity), error = await errors(scene, run);
  const truth = await numbers(scene.truth);
  const visible = scene.visible && region === "visible" ? (await unpack(scene.visible)).codes : null;
  const codes = error.values.map((e, i) => {
    if (Number.isNaN(truth.values[i]) || (visible && visible[i] !== kVisible)) return 3;
    return Number.isNaN(map.values[i]) ? 2 : e > delta ? 1 : 0;
  });
  return { cols: map.cols, rows: map.rows, codes };
}

async function rangeSize(level) {
  const first = await numbers(level.first), last = await numbers(level.last);
  return { ...first, values: last.values.map((d, i) => d - first.values[i] + 1) };
}
