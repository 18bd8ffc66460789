// The directions of x, y and z in a corner of the picture.

import { svg } from "./elements.js";

const COLOURS = ["#b3261e", "#1b6e3a", "#1f4fa3"];
const LENGTH = 26;

export class Axes {
  constructor() {
    this.root = svg("svg", { class: "axes", viewBox: "-40 -40 80 80", "aria-hidden": "true" });
  }

  show(directions) {
    const order = [0, 1, 2].sort((a, b) => directions[a].z - directions[b].z);
    this.root.replaceChildren(
      ...order.flatMap((k) => {
        const { x, y } = directions[k];
        const short = Math.hypot(x, y) < 0.05;
        const label = svg("text", {
          x: (LENGTH + 9) * x, y: -(LENGTH + 9) * y, fill: COLOURS[k], "text-anchor": "middle", "dominant-baseline": "central",
        }, "xyz"[k]);
        const line = svg("line", { x1: 0, y1: 0, x2: LENGTH * x, y2: -LENGTH * y, stroke: COLOURS[k], "stroke-width": 2.5 });
        return short ? [] : [line, label];
      }),
    );
  }
}
