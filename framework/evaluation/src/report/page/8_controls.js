// SPDX-License-Identifier: Apache-2.0
// Fills the controls, and listens to them, to the pointer and to keys.
"use strict";

function fillLayers(select) {
  const groups = new Map();
  for (const layer of layers) {
    if (!groups.has(layer.group)) groups.set(layer.group, element("optgroup", { label: layer.group }));
    const prefix = layer.group === "Scene" ? "" : `${layer.group}: `;
    groups.get(layer.group).append(element("option", { value: layer.id }, prefix + layer.name));
  }
  select.replaceChildren(...groups.values());
}

/** Two pipelines beside each other where there are two, else the image and its map. */
function defaultLayers() {
  const runs = scene().runs.length;
  return runs > 1 ? ["0.disparity", "1.disparity"] : ["left", runs === 1 ? "0.disparity" : "left"];
}

function fillCurves() {
  const points = explainedPoints(scene());
  $("curves").hidden = points.length === 0;
  $("curve-point").replaceChildren(...points.map(({ run, point }, i) =>
    element("option", { value: i }, `x = ${point.x}, y = ${point.y} · ${run.name}`)));
  $("marks").replaceChildren(...points.map(({ point }) => {
    const mark = element("span", {});
    position(mark, point.x, point.y);
    return mark;
  }));
  if (points.length > 0) showCurve();
}

function showCurve() {
  const { point } = explainedPoints(scene())[$("curve-point").value];
  $("curve-plots").replaceChildren(...explanationParts(point));
}

/** The explained pixel nearest to the chosen one, if it is near. */
function selectCurve(x, y) {
  const kNear = Math.max(scene().grid.width / 60, 3);
  const distances = explainedPoints(scene())
    .map(({ point }) => Math.hypot(point.x - x, point.y - y));
  const nearest = distances.indexOf(Math.min(...distances));
  if (nearest < 0 || distances[nearest] > kNear) return;
  $("curve-point").value = nearest;
  showCurve();
}

async function openScene(wanted) {
  layers = sceneLayers(scene(), view.scene, view.settings);
  const [a, b] = defaultLayers();
  view.a = layerOf(wanted.a) ? wanted.a : a;
  view.b = layerOf(wanted.b) ? wanted.b : b;
  for (const side of ["a", "b"]) {
    fillLayers($(`layer-${side}`));
    $(`layer-${side}`).value = view[side];
  }
  const { width, height } = scene().grid;
  $("stage").style.aspectRatio = `${width} / ${height}`;
  $("delta-field").hidden = !scene().truth;
  $("region-field").hidden = !scene().visible;
  Object.assign(view, { x: null, y: null });
  $("cross").hidden = true;
  $("readout").replaceChildren();
  fillCurves();
  await Promise.all([show("a"), show("b")]);
  showZoom();
  if (wanted.x !== null && wanted.y !== null) {
    selectCurve(wanted.x, wanted.y);
    await choose(wanted.x, wanted.y);
  }
}

function setSplit(percent) {
  view.split = Math.min(Math.max(percent, 0), 100);
  showSplit();
  writeAddress();
}

function setZoom(zoom) {
  view.zoom = Math.min(Math.max(zoom, 1), 16);
  showZoom();
  if (view.x !== null) $("cross").scrollIntoView({ block: "nearest", inline: "center" });
}

/** The pixel of the scene under the pointer. */
function pixelAt(event) {
  const box = $("stage").getBoundingClientRect(), { width, height } = scene().grid;
  return snapped(scene().grid, (event.clientX - box.left) / box.width * width,
    (event.clientY - box.top) / box.height * height);
}

function listenToPointer() {
  const stage = $("stage"), divider = $("divider");
  let dragging = false;
  divider.addEventListener("pointerdown", (event) => {
    dragging = true;
    divider.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  divider.addEventListener("pointermove", (event) => {
    const box = stage.getBoundingClientRect();
    if (dragging) setSplit((event.clientX - box.left) / box.width * 100);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    divider.addEventListener(end, () => { dragging = false; });
  }
  stage.addEventListener("pointermove", (event) => {
    if (dragging) return;
    const { x, y } = pixelAt(event);
    showReadout(x, y);
  });
  stage.addEventListener("pointerleave", () => {
    if (view.x !== null) showReadout(view.x, view.y);
  });
  stage.addEventListener("click", (event) => {
    if (divider.contains(event.target)) return;
    const { x, y } = pixelAt(event);
    selectCurve(x, y);
    choose(x, y);
  });
}

function listenToKeys() {
  const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const others = { "+": () => setZoom(view.zoom * 2), "-": () => setZoom(view.zoom / 2),
    "[": () => setSplit(view.split - 2), "]": () => setSplit(view.split + 2) };
  $("stage").addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { width, height, stride } = scene().grid;
    if (moves[event.key]) {
      const step = stride * (event.shiftKey ? 10 : 1), [dx, dy] = moves[event.key];
      choose((view.x ?? width >> 1) + dx * step, (view.y ?? height >> 1) + dy * step);
      $("cross").scrollIntoView({ block: "nearest", inline: "nearest" });
    } else if (others[event.key]) {
      others[event.key]();
    } else {
      return;
    }
    event.preventDefault();
  });
}

function redrawBad() {
  for (const side of ["a", "b"]) if (layerOf(view[side]).key === "bad") show(side);
}

function listenToControls() {
  const none = { a: null, b: null, x: null, y: null };
  $("scene").addEventListener("change", () => {
    view.scene = Number($("scene").value);
    openScene({ ...none, a: view.a, b: view.b }).then(writeAddress);
  });
  for (const side of ["a", "b"]) {
    $(`layer-${side}`).addEventListener("change", async (event) => {
      view[side] = event.target.value;
      await show(side);
      showSplit();
      writeAddress();
    });
  }
  $("delta").addEventListener("input", () => {
    const delta = $("delta").valueAsNumber;
    if (!(delta >= 0)) return;
    view.settings.delta = delta;
    redrawBad();
  });
  $("region").addEventListener("change", () => {
    view.settings.region = $("region").value;
    redrawBad();
  });
  $("curve-point").addEventListener("change", () => {
    const { point } = explainedPoints(scene())[$("curve-point").value];
    showCurve();
    choose(point.x, point.y);
  });
  $("split").addEventListener("input", () => setSplit(Number($("split").value)));
  $("zoom-in").addEventListener("click", () => setZoom(view.zoom * 2));
  $("zoom-out").addEventListener("click", () => setZoom(view.zoom / 2));
  $("zoom-fit").addEventListener("click", () => setZoom(1));
  window.addEventListener("resize", showSplit);
}
