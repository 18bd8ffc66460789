// The legend: colours with rounded numbers, and the smallest and largest value shown.

import { cssGradient } from "./colours.js";
import { element } from "./elements.js";
import { roundedTicks, text, withUnit } from "./numbers.js";

export class Legend {
  constructor() {
    this.title = element("div", { class: "legend-title" });
    this.bar = element("div", { class: "legend-bar" });
    this.bar.style.background = cssGradient();
    this.ticks = element("div", { class: "legend-ticks" });
    this.range = element("div", { class: "legend-range" });
    this.root = element(
      "div", { class: "legend" }, this.title, element("div", { class: "legend-scale" }, this.bar, this.ticks), this.range,
    );
  }

  // The range of the colours that covers [low, high] with rounded ends.
  static ends(low, high) {
    const ticks = roundedTicks(low, high);
    return [ticks[0], ticks[ticks.length - 1]];
  }

  // shown: smallest and largest value of the moment, or null
  show(field, low, high, shown) {
    this.title.textContent = field.unit ? `${field.label} [${field.unit}]` : field.label;
    const ticks = roundedTicks(low, high);
    const [first, last] = [ticks[0], ticks[ticks.length - 1]];
    this.ticks.replaceChildren(
      ...ticks.map((tick) => {
        const made = element("span", {}, text(Math.abs(tick) < 1e-12 * (last - first) ? 0 : tick, 6));
        made.style.bottom = `${(100 * (tick - first)) / (last - first)}%`;
        return made;
      }),
    );
    this.range.textContent = shown
      ? `now ${withUnit(shown[0], "", 4)} to ${withUnit(shown[1], field.unit, 4)}`
      : "no value at this time";
  }
}
