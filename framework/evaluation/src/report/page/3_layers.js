// SPDX-License-Identifier: Apache-2.0
// What the viewer can show: layers with a name, a place in the scene, colours and a legend.
"use strict";

const rgb = (css) => [1, 3, 5].map((i) => parseInt(css.slice(i, i + 2), 16));
const missingColour = rgb(page.missing);

/** Numbers in the colours of a ramp. span() is asked once the numbers are there; `open`: values
    above it are to be expected. */
function rampLayer(ramp, load, span, unit, missing, open = false) {
  return {
    async draw() {
      const map = await load();
      const [low, high] = span(map);
      const colour = (value) => Number.isNaN(value) ? missingColour
        : ramp[Math.round(255 * Math.min(Math.max((value - low) / (high - low), 0), 1))];
      return { ...map, colour: (i) => colour(map.values[i]),
        legend: rampLegend(ramp, low, high, unit, missing, open) };
    },
  };
}

/** The first `counted` classes have shares, among themselves. */
function classLayer(classes, load, counted = classes.length, note = null) {
  const colours = classes.map((c) => rgb(c.colour));
  return {
    async draw() {
      const map = await load();
      const counts = classes.map(() => 0);
      for (const code of map.codes) ++counts[code];
      const some = counts.slice(0, counted), all = some.reduce((a, b) => a + b, 0);
      return { ...map, colour: (i) => colours[map.codes[i]],
        legend: classLegend(classes, some.map((n) => n / all), note) };
    },
  };
}

const scaleName = (scale) => scale === 1 ? "full size" : `1/${scale}`;

function levelLayers(scene, level, run) {
  const scale = level.grid.scale;
  const group = `${run.name}: level ${scaleName(scale)}`;
  const inSpan = () => scene.span.map((d) => d / scale);
  const at = (key, name, layer) =>
    ({ key: `s${scale}.${key}`, name, group, run, grid: level.grid, ...layer });
  const ramp = page.ramps.disparity;
  const layers = [
    at("disparity", "disparity",
      rampLayer(ramp, () => numbers(level.disparity), inSpan, " px", "none")),
    at("status", "status", classLayer(page.statuses, () => unpack(level.status)))];
  if (!level.first) return layers;
  const largest = (map) => [0, map.values.reduce((a, b) => b > a ? b : a, 1)];
  layers.push(
    at("first", "searched from",
      rampLayer(ramp, () => numbers(level.first), inSpan, " px", "nothing")),
    at("last", "searched to",
      rampLayer(ramp, () => numbers(level.last), inSpan, " px", "nothing")),
    at("count", "disparities searched",
      rampLayer(page.ramps.error, () => rangeSize(level), largest, "", "nothing")));
  return layers;
}

function runLayers(scene, run, settings) {
  const at = (key, name, layer) =>
    ({ key, name, group: run.name, run, grid: scene.grid, ...layer });
  const layers = [
    at("disparity", "disparity", rampLayer(page.ramps.disparity, () => numbers(run.disparity),
      () => scene.span, " px", "none: see the status")),
    at("status", "status", classLayer(page.statuses, () => unpack(run.status)))];
  if (run.confidence) {
    layers.push(at("confidence", "confidence", rampLayer(page.ramps.disparity,
      () => numbers(run.confidence), () => [0, 1], "", "none")));
  }
  if (scene.truth) {
    layers.push(
      at("error", "error", rampLayer(page.ramps.error, () => errors(scene, run),
        () => [0, page.errorSpan], " px", "no disparity or no truth", true)),
      at("bad", "bad pixels", classLayer(page.verdicts,
        () => verdicts(scene, run, settings.delta, settings.region), page.verdicts.length - 1,
        () => `bad: off by more than ${settings.delta} px`)));
  }
  return layers.concat(...run.levels.map((level) => levelLayers(scene, level, run)));
}

/** Every layer of a scene. Its id ("left", "0.disparity", "1.s4.count") stands in addresses. */
function sceneLayers(scene, index, settings) {
  const at = (key, name, layer) => ({ id: key, key, name, group: "Scene", grid: scene.grid, ...layer });
  const layers = [at("left", "left image", { image: document.getElementById(`left-${index}`) })];
  if (scene.truth) {
    layers.push(at("truth", "true disparity", rampLayer(page.ramps.disparity,
      () => numbers(scene.truth), () => scene.span, " px", "unknown")));
  }
  scene.runs.forEach((run, i) => {
    for (const layer of runLayers(scene, run, settings)) {
      layers.push({ ...layer, id: `${i}.${layer.key}` });
    }
  });
  return layers;
}
