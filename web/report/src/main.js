// Starts the interactive views of a page when they come near, and frees those that are farthest when there are many.

import { ModelViewer } from "./model_viewer.js";
import { Viewer } from "./viewer.js";

const MOST = 6;

function begin() {
  const viewers = [...document.querySelectorAll(".viewer[data-scene]")].map(
    (root) => (root.classList.contains("model") ? new ModelViewer(root) : new Viewer(root)));
  const near = new IntersectionObserver(
    (entries) => {
      for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        const viewer = viewers.find((one) => one.place === entry.target);
        viewer.start();
        const live = viewers.filter((one) => one.view && one !== viewer);
        const distance = (one) => Math.abs(one.root.getBoundingClientRect().top);
        live.sort((a, b) => distance(b) - distance(a));
        while (live.length >= MOST) live.shift().pause();
      }
    },
    { rootMargin: "400px" },
  );
  viewers.forEach((viewer) => near.observe(viewer.place));
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", begin);
else begin();
