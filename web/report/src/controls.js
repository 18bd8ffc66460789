// What the user chooses: native elements with labels, and the state they stand for.

import { element } from "./elements.js";
import { text, withUnit } from "./numbers.js";

const PLAY_MS = 350; // per time
const SECTION_STEPS = 200;
let count = 0;

function labelled(words, control, extra = "") {
  control.id ||= `viewer-control-${++count}`;
  return element("div", { class: `control ${extra}` }, element("label", { for: control.id }, words), control);
}

function checkBox(words, checked, change) {
  const box = element("input", { type: "checkbox", checked, on: { change } });
  box.id = `viewer-control-${++count}`;
  return { box, root: element("div", { class: "check" }, box, element("label", { for: box.id }, words)) };
}

// Deformation factors around the suggested one.
function factors(suggested) {
  const around = suggested > 0 ? [0.1, 0.5, 1, 2, 5, 10].map((part) => Number((part * suggested).toPrecision(3))) : [];
  return [...new Set([0, 1, ...around])].sort((a, b) => a - b);
}

export class Controls {
  // box: {low, high}; change: called after every choice
  constructor(header, box, change) {
    this.header = header;
    this.box = box;
    this.change = change;
    const option = (value, words, selected) => element("option", { value, selected }, words);
    const begin = Math.max(0, header.fields.findIndex((field) => field.name === header.begin.field));
    this.field = element(
      "select", { on: { change } },
      ...header.fields.map((field, f) => option(f, field.unit ? `${field.label} [${field.unit}]` : field.label, f === begin)),
    );
    this.time = element("input", {
      type: "range", min: 0, max: header.times.length - 1, step: 1, value: header.begin.time, on: { input: () => this.timeChanged() },
    });
    this.timeText = element("output", { class: "time-text" });
    this.play = element("button", { type: "button", on: { click: () => this.toggle() } }, "Play");
    this.warp = element(
      "select", { on: { change } },
      ...factors(header.warp).map((factor) =>
        option(factor, factor === 0 ? "none" : `× ${text(factor, 4)}`, factor === header.warp)),
    );
    this.range = element("select", { on: { change } }, option("now", "range of this time", true), option("all", "range of all times"));
    const solid = header.flat ? ["x", "y"] : ["x", "y", "z"];
    this.axis = element("select", { on: { change: () => this.sectionChanged() } }, option("", "none", true),
                        ...solid.map((name) => option(name, `normal to ${name}`)));
    this.place = element("input", {
      type: "range", min: 0, max: SECTION_STEPS, value: SECTION_STEPS / 2, disabled: true, on: { input: () => this.placed() },
    });
    this.placeText = element("output", {});
    this.flip = checkBox("other side", false, change);
    this.lines = checkBox("mesh lines", true, change);
    this.bodies = header.bodies.map((body) => checkBox(body.name, true, change));
    this.root = element(
      "div", { class: "controls" },
      labelled("Quantity", this.field),
      ...(header.model ? [] : [
        labelled("Colours", this.range),
        labelled("Deformation", this.warp),
        element("div", { class: "control wide time" }, ...labelled("Time", this.time).children, this.timeText, this.play),
      ]),
      labelled("Section", this.axis),
      element("div", { class: "control wide" }, ...labelled("Place of the section", this.place).children, this.placeText,
              this.flip.root),
      element("fieldset", { class: "control wide" }, element("legend", {}, "Show"), ...this.bodies.map((body) => body.root),
              this.lines.root),
    );
    this.flip.box.disabled = true;
    if (header.times.length < 2) this.play.disabled = this.time.disabled = true;
    this.showTime();
    this.showPlace();
  }

  state() {
    return {
      field: Number(this.field.value || 0),
      time: Number(this.time.value),
      warp: Number(this.warp.value),
      ofAllTimes: this.range.value === "all",
      lines: this.lines.box.checked,
      bodies: this.bodies.map((body) => body.box.checked),
      plane: this.plane(),
    };
  }

  // [nx, ny, nz, d]; null for none
  plane() {
    const axis = "xyz".indexOf(this.axis.value);
    if (!this.axis.value || axis < 0) return null;
    const sign = this.flip.box.checked ? -1 : 1;
    const normal = [0, 0, 0];
    normal[axis] = sign;
    return [...normal, sign * this.position()];
  }

  position() {
    const axis = "xyz".indexOf(this.axis.value);
    const { low, high } = this.box;
    // A little off the round numbers, on which element faces often lie.
    const share = Number(this.place.value) / SECTION_STEPS + 1e-4;
    return low[axis] + share * (high[axis] - low[axis]);
  }

  timeText_() {
    return withUnit(this.header.times[Number(this.time.value)], this.header.time_unit, 6);
  }

  showTime() {
    this.timeText.textContent = `t = ${this.timeText_()}`;
    this.time.setAttribute("aria-valuetext", this.timeText_());
  }

  showPlace() {
    const words = this.axis.value ? `${this.axis.value} = ${withUnit(this.position(), this.header.length_unit, 4)}` : "";
    this.placeText.textContent = words;
    this.place.setAttribute("aria-valuetext", words || "no section");
  }

  timeChanged() {
    this.showTime();
    this.change();
  }

  sectionChanged() {
    this.place.disabled = this.flip.box.disabled = !this.axis.value;
    this.placed();
  }

  placed() {
    this.showPlace();
    this.change();
  }

  toggle() {
    if (this.timer) return this.stop();
    this.play.textContent = "Stop";
    if (Number(this.time.value) === this.header.times.length - 1) this.time.value = -1;
    this.timer = setInterval(() => {
      this.time.value = Number(this.time.value) + 1;
      this.timeChanged();
      if (Number(this.time.value) === this.header.times.length - 1) this.stop();
    }, PLAY_MS);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = 0;
    this.play.textContent = "Play";
  }
}
