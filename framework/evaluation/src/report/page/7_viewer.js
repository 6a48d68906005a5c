// SPDX-License-Identifier: Apache-2.0
// Two layers with a line between them, and the pixel that was chosen.
"use strict";

const $ = (id) => document.getElementById(id);

/** All that the viewer shows follows from these; the address holds them. */
const view = { scene: 0, a: "", b: "", split: 50, x: null, y: null, zoom: 1,
  settings: { delta: 1, region: "visible" } };
let layers = [];

const scene = () => page.scenes[view.scene];
const layerOf = (id) => layers.find((layer) => layer.id === id);

function paintMap(canvas, map) {
  canvas.width = map.cols;
  canvas.height = map.rows;
  const image = new ImageData(map.cols, map.rows);
  for (let i = 0, k = 0; i < map.cols * map.rows; ++i, k += 4) {
    const [r, g, b] = map.colour(i);
    image.data[k] = r;
    image.data[k + 1] = g;
    image.data[k + 2] = b;
    image.data[k + 3] = 255;
  }
  canvas.getContext("2d").putImageData(image, 0, 0);
}

async function paintImage(canvas, image) {
  await image.decode();
  canvas.width = image.naturalWidth;
  canvas.height = image.naturalHeight;
  canvas.getContext("2d").drawImage(image, 0, 0);
}

/** Levels may reach a little beyond the image: they are as wide as their pixels make them. */
function place(canvas, grid) {
  const { width, height } = scene().grid;
  canvas.style.width = `${100 * grid.width * grid.scale / width}%`;
  canvas.style.height = `${100 * grid.height * grid.scale / height}%`;
}

async function show(side) {
  const layer = layerOf(view[side]), canvas = $(`canvas-${side}`), legend = $(`legend-${side}`);
  const heading = element("b", {}, layer.group === "Scene" ? layer.name
    : `${layer.group}: ${layer.name}`);
  if (layer.image) {
    await paintImage(canvas, layer.image);
    legend.replaceChildren(heading);
  } else {
    const map = await layer.draw();
    if (layerOf(view[side]) !== layer) return;  // another one was chosen meanwhile
    paintMap(canvas, map);
    legend.replaceChildren(heading, map.legend);
  }
  place(canvas, layer.grid);
}

function showSplit() {
  $("split").value = view.split;
  $("divider").style.left = `${view.split}%`;
  // In the canvas's own width, which is not quite the stage's for levels.
  const stage = $("stage").clientWidth, own = $("canvas-b").clientWidth || stage;
  $("canvas-b").style.clipPath = `inset(0 0 0 ${view.split / 100 * stage / own * 100}%)`;
}

function showZoom() {
  $("stage").style.width = `${100 * view.zoom}%`;
  showSplit();
}

/** The share of the stage at which the middle of a pixel lies. */
function position(node, x, y) {
  const { width, height } = scene().grid;
  node.style.left = `${100 * (x + 0.5) / width}%`;
  node.style.top = `${100 * (y + 0.5) / height}%`;
}

let readoutAsked = 0;
async function showReadout(x, y) {
  const asked = ++readoutAsked;
  const parts = await readout(scene(), x, y);
  if (asked === readoutAsked) $("readout").replaceChildren(...parts);
}

function choose(x, y) {
  const pixel = snapped(scene().grid, x, y);
  Object.assign(view, pixel);
  $("cross").hidden = false;
  position($("cross"), pixel.x, pixel.y);
  writeAddress();
  return showReadout(pixel.x, pixel.y);
}

function writeAddress() {
  const state = new URLSearchParams({ scene: view.scene, a: view.a, b: view.b, split: view.split });
  if (view.x !== null) {
    state.set("x", view.x);
    state.set("y", view.y);
  }
  history.replaceState(null, "", `#${state}`);
}

function readAddress() {
  const state = new URLSearchParams(location.hash.slice(1));
  const whole = (name) => /^\d+$/.test(state.get(name) ?? "") ? Number(state.get(name)) : null;
  view.scene = Math.min(whole("scene") ?? 0, page.scenes.length - 1);
  view.split = Math.min(Math.max(Number(state.get("split") ?? 50) || 0, 0), 100);
  return { a: state.get("a"), b: state.get("b"), x: whole("x"), y: whole("y") };
}
