// SPDX-License-Identifier: Apache-2.0
// Shows the viewer, where the browser can run it; without it the static page is complete.
"use strict";

function start() {
  if (page.scenes.length === 0 || typeof DecompressionStream === "undefined") return;
  const wanted = readAddress();
  $("viewer").hidden = false;
  $("scene").replaceChildren(...page.scenes.map((s, i) => element("option", { value: i }, s.name)));
  $("scene").value = view.scene;
  $("scene-field").hidden = page.scenes.length < 2;
  $("delta").value = view.settings.delta;
  $("region").replaceChildren(
    element("option", { value: "visible" }, "non-occluded"), element("option", { value: "all" }, "all"));
  listenToControls();
  listenToPointer();
  listenToKeys();
  window.addEventListener("hashchange", () => {
    const next = readAddress();
    $("scene").value = view.scene;
    if (/^#scene-/.test(location.hash)) return;  // a link to a section of the page
    openScene(next);
  });
  openScene(wanted).then(() => document.documentElement.classList.add("ready"));
}

start();
