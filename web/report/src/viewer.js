// One interactive view in its place on the page.

import { Axes } from "./axes.js";
import { Controls } from "./controls.js";
import { element } from "./elements.js";
import { Legend } from "./legend.js";
import { text, withUnit } from "./numbers.js";
import { SceneData } from "./scene_data.js";
import { View } from "./view.js";

const KEYS = "Arrow keys turn it, plus and minus zoom, 0 shows all of it again.";

export class Viewer {
  constructor(root) {
    this.root = root;
    this.figure = root.closest("figure");
    this.place = this.figure ?? root.parentElement; // has an extent while the view has none
  }

  async start() {
    if (this.starting) return;
    this.starting = true;
    try {
      this.data ??= await SceneData.read(this.root.dataset.scene);
      this.build();
      this.figure?.classList.add("live");
      this.view = new View(this.canvas, this.data, () => this.axes.show(this.view.axes()));
      this.watch = new ResizeObserver(() => this.view.resize());
      this.watch.observe(this.canvas);
      this.show();
      this.view.resize();
      this.root.dataset.state = "ready";
      this.root.dispatchEvent(new CustomEvent("ready", { bubbles: true }));
    } catch (error) {
      this.fail(error);
    }
  }

  // Frees the picture, of which browsers allow few at a time; start() makes it again.
  pause() {
    if (!this.view) return;
    this.controls.stop();
    this.watch.disconnect();
    this.view.dispose();
    this.view = null;
    this.starting = false;
    this.figure?.classList.remove("live");
    this.root.dataset.state = "paused";
    this.root.replaceChildren();
  }

  fail(error) {
    this.figure?.classList.remove("live");
    this.root.dataset.state = "failed";
    this.root.replaceChildren(
      element("p", { class: "failure" },
              "The interactive view needs WebGL 2 in a browser of 2023 or later, which is not available here. Pictures of the " +
              "fields are shown in its place, if the report has them."),
    );
    console.info(`interactive view: ${error.message}`);
  }

  build() {
    const { header } = this.data;
    this.canvas = element("canvas", {
      tabindex: 0, role: "img", "aria-label": `Bodies coloured by a quantity, deformed. ${KEYS}`,
      on: { keydown: (event) => this.key(event), pointerdown: (event) => this.press(event), click: (event) => this.read(event) },
    });
    this.axes = new Axes();
    this.legend = new Legend();
    this.reading = element("p", { class: "reading", role: "status" });
    this.note = element("p", { class: "note" });
    this.controls = new Controls(header, this.data.box(), () => this.show());
    const button = (words, label, action) => element("button", { type: "button", "aria-label": label, on: { click: action } }, words);
    const buttons = element(
      "div", { class: "buttons" },
      button("+", "zoom in", () => this.view.zoom(1.25)),
      button("−", "zoom out", () => this.view.zoom(0.8)),
      button("⌂", "show all of it", () => this.view.reset()),
    );
    const stage = element("div", { class: "stage" }, this.canvas, this.axes.root, buttons);
    this.root.replaceChildren(
      this.controls.root, element("div", { class: "picture" }, stage, this.legend.root), this.reading, this.note,
    );
    this.reading.textContent = "Click on a body to read its value there.";
  }

  show() {
    if (!this.view) return;
    const state = this.controls.state();
    const { header } = this.data;
    const field = header.fields[state.field];
    if (field) {
      const now = this.data.range(state.field, state.time);
      const [low, high] = state.ofAllTimes || !now ? [field.min, field.max] : now;
      [state.low, state.high] = Legend.ends(low, high);
      this.legend.show(field, low, high, now);
      this.note.textContent = field.on_contact
        ? `${field.label[0].toUpperCase()}${field.label.slice(1)} is defined on contact surfaces only: everything else is drawn as glass.`
        : state.plane && !header.has_tetrahedra && !header.flat
          ? "This page has the surfaces of the bodies only: a section shows their inside as empty."
          : "";
    }
    this.view.show(state);
    const onContact = Boolean(field && field.on_contact);
    if (onContact && !this.onContact) this.view.lookAtValues();
    else if (this.onContact && !onContact) this.view.reset();
    this.onContact = onContact;
    Object.assign(this.root.dataset, {
      time: state.time, field: field ? field.name : "", warp: state.warp, section: this.controls.axis.value,
    });
    if (this.read_) this.reading.textContent = "Click on a body to read its value there.";
    this.read_ = false;
  }

  key(event) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (turns[event.key]) this.view.turn(...turns[event.key]);
    else if (event.key === "+" || event.key === "=") this.view.zoom(1.25);
    else if (event.key === "-") this.view.zoom(0.8);
    else if (event.key === "0") this.view.reset();
    else return;
    event.preventDefault();
  }

  press(event) {
    this.pressed = [event.clientX, event.clientY];
  }

  read(event) {
    const [x, y] = this.pressed ?? [event.clientX, event.clientY];
    if (Math.hypot(event.clientX - x, event.clientY - y) > 4) return; // it was turned
    const box = this.canvas.getBoundingClientRect();
    const found = this.view.pick(event.clientX - box.left, event.clientY - box.top);
    const field = this.data.header.fields[this.controls.state().field];
    this.read_ = true;
    if (!found || !field) {
      this.reading.textContent = "There is no body there.";
      return;
    }
    const { x: px, y: py, z: pz } = found.place;
    const place = [px, py, pz].map((part) => text(part, 4)).join(", ");
    this.reading.textContent =
      `${found.body}: ${field.label} ${withUnit(found.value, field.unit, 5)} at (${place}) of the picture as it is drawn`;
  }
}
