// The view of a model before its run: faces are picked, named, and written as TOML.

import { element } from "./elements.js";
import { Viewer } from "./viewer.js";

const NAME = "A name of letters, digits, - and _ needs no quotation marks; any other is quoted.";
let count = 0;

function bareOrQuoted(name) {
  return /^[A-Za-z0-9_-]+$/.test(name) ? name : JSON.stringify(name);
}

export class ModelViewer extends Viewer {
  constructor(root) {
    super(root);
    this.model = JSON.parse(document.getElementById(root.dataset.scene + "-model").textContent);
    this.faces = new Map(this.model.faces.map((face) => [face.number, face]));
    this.named = new Map(); // name: set of numbers
    this.selected = new Set();
  }

  build() {
    super.build();
    this.reading.textContent = "Click on a face, or choose one in the list, to see what it is.";
    const id = (what) => `model-${what}-${++count}`;
    const labelled = (words, control) => {
      control.id = id("control");
      return element("div", { class: "field" }, element("label", { for: control.id }, words), control);
    };
    this.list = element(
      "select", { size: 8, multiple: true, on: { change: () => this.choose([...this.list.selectedOptions].map((one) => Number(one.value))) } },
    );
    this.filter = element("input", { type: "search", maxlength: 200, spellcheck: "false", placeholder: "cylinder bolt",
                                     on: { input: () => this.list_faces() } });
    this.shown = element("span", { role: "status" });
    this.list_faces();
    this.groups = element(
      "select", { size: Math.min(8, Math.max(2, this.model.groups.length)), on: { change: () => this.chooseGroup() } },
      ...this.model.groups.map((group, g) => element("option", { value: g }, [group.name, ...group.uses].join(": "))),
    );
    this.facts = element("div", { class: "facts", "aria-live": "polite", role: "group", "aria-label": "Chosen faces", tabindex: 0 });
    this.name = element("input", { type: "text", maxlength: 200, spellcheck: "false", title: NAME,
                                   on: { keydown: (event) => event.key === "Enter" && this.give() } });
    const button = (words, action) => element("button", { type: "button", on: { click: action } }, words);
    this.complaint = element("p", { class: "complaint", role: "alert" });
    this.output = element("textarea", { readonly: true, rows: 8, spellcheck: "false" });
    this.copied = element("span", { role: "status" });
    this.panel = element(
      "div", { class: "panel" },
      this.facts,
      element("div", { class: "faces" }, labelled("Faces (several with Ctrl or Shift)", this.list),
              element("div", { class: "naming" }, labelled("List only faces with these words", this.filter), this.shown)),
      this.model.groups.length ? labelled("Groups, supports, loads and contacts", this.groups) : "",
      element("div", { class: "names" },
              element("div", { class: "naming" }, labelled("Name for the chosen faces", this.name), button("Add", () => this.give()),
                      button("Forget the name", () => this.forget())),
              this.complaint,
              labelled("For the configuration", this.output),
              element("div", { class: "naming" }, button("Copy", () => this.copy()), button("Download", () => this.download()),
                      this.copied)),
    );
    this.root.append(this.panel);
    this.write();
  }

  // The lists do without a picture.
  fail(error) {
    super.fail(error);
    this.root.replaceChildren(
      element("p", { class: "failure" },
              "The picture needs WebGL 2 in a browser of 2023 or later, which is not available here; the lists work without it."),
      this.panel ?? "",
    );
  }

  show() {
    super.show();
    this.highlight();
  }

  words(face) {
    const names = face.names.length ? `; ${face.names.join(", ")}` : "";
    return `${face.number}: ${face.kind} of ${this.data.header.bodies[face.body].name}${names}`;
  }

  // A model may have thousands of faces.
  list_faces() {
    const wanted = this.filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = this.model.faces.filter((face) => {
      const text = `${this.words(face)} ${face.text} ${face.next_to.join(" ")}`.toLowerCase();
      return wanted.every((word) => text.includes(word));
    });
    this.list.replaceChildren(...found.map((face) => {
      const option = element("option", { value: face.number }, this.words(face));
      option.selected = this.selected.has(face.number);
      return option;
    }));
    this.shown.textContent = wanted.length ? `${found.length} of ${this.model.faces.length}` : "";
  }

  read(event) {
    const [x, y] = this.pressed ?? [event.clientX, event.clientY];
    if (Math.hypot(event.clientX - x, event.clientY - y) > 4) return; // it was turned
    const box = this.canvas.getBoundingClientRect();
    const found = this.view.pick(event.clientX - box.left, event.clientY - box.top);
    const face = found && this.model.faces.find(({ triangles: [first, n] }) => found.triangle >= first && found.triangle < first + n);
    if (!face) return this.choose([]);
    const add = event.ctrlKey || event.metaKey || event.shiftKey;
    const chosen = new Set(add ? this.selected : []);
    if (add && chosen.has(face.number)) chosen.delete(face.number);
    else chosen.add(face.number);
    this.choose([...chosen]);
  }

  choose(numbers) {
    this.selected = new Set(numbers);
    for (const option of this.list.options) option.selected = this.selected.has(Number(option.value));
    const first = [...this.list.options].find((option) => option.selected);
    first?.scrollIntoView?.({ block: "nearest" });
    this.facts.replaceChildren(...numbers.map((number) => this.described(this.faces.get(number))));
    this.reading.textContent = numbers.length ? `${numbers.length === 1 ? "Face" : "Faces"} ${numbers.join(", ")}`
                                              : "There is no face there.";
    this.root.dataset.faces = numbers.join(" ");
    this.highlight();
  }

  chooseGroup() {
    const group = this.model.groups[Number(this.groups.value)];
    if (group) this.choose(group.faces);
  }

  described(face) {
    const rows = [["body", this.data.header.bodies[face.body].name], ["kind", face.kind], ["", face.text]];
    if (face.names.length) rows.push(["named", face.names.join(", ")]);
    for (const next of face.next_to) rows.push(["next to", next]);
    return element(
      "dl", {}, element("dt", {}, "face"), element("dd", {}, String(face.number)),
      ...rows.flatMap(([what, text]) => [element("dt", {}, what || "where"), element("dd", {}, text)]),
    );
  }

  highlight() {
    if (!this.view) return;
    this.view.highlight([...this.selected].map((number) => this.faces.get(number).triangles));
  }

  give() {
    const name = this.name.value.trim();
    this.complaint.textContent = !name ? "Type a name first." : !this.selected.size ? "Choose a face first."
      : this.model.groups.some((group) => group.name === name) ? `The model has '${name}' already; choose another name.` : "";
    if (this.complaint.textContent) return;
    this.named.set(name, new Set(this.selected));
    this.write();
  }

  forget() {
    this.named.delete(this.name.value.trim());
    this.write();
  }

  write() {
    const lines = [];
    for (const [name, numbers] of this.named) {
      lines.push(`[surfaces.${bareOrQuoted(name)}]`);
      lines.push(`faces = [${[...numbers].sort((a, b) => a - b).join(", ")}]`, "");
    }
    this.output.value = lines.join("\n");
    this.output.placeholder = "Names that you give appear here.";
  }

  async copy() {
    this.output.select();
    let done = document.execCommand("copy"); // pages from a file may lack the newer way
    if (!done) done = await navigator.clipboard?.writeText(this.output.value).then(() => true, () => false);
    this.copied.textContent = done ? "Copied." : "The browser does not allow it: press Ctrl+C.";
  }

  download() {
    const link = element("a", { href: URL.createObjectURL(new Blob([this.output.value], { type: "application/toml" })), download: "surfaces.toml" });
    link.click();
    URL.revokeObjectURL(link.href);
  }
}
