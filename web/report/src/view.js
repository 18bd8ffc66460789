// The picture: bodies, lines of the mesh, cut and camera. Draws only when something has changed.

import {
  BufferAttribute, BufferGeometry, DoubleSide, LineSegments, Mesh, MeshBasicMaterial, OrthographicCamera, Scene, Vector2, Vector3,
  Vector4, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { colourTexture } from "./colours.js";
import { lineMaterial, surfaceMaterial } from "./material.js";
import { nearestHit, rayAt } from "./picking.js";
import { cutThrough } from "./section.js";

const OBLIQUE = new Vector3(1, -1.25, 0.85).normalize();
const TURN = Math.PI / 24; // per key
const MARK = 0xd9480f; // of chosen faces
const FILLED = 0.86; // of the picture, by the bodies

export class View {
  // Throws if there is no WebGL.
  constructor(canvas, data, onChange) {
    this.canvas = canvas;
    this.data = data;
    this.onChange = onChange;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.setClearColor(0xffffff);
    this.scene = new Scene();
    this.camera = new OrthographicCamera();
    this.camera.up.set(0, 0, 1);
    this.flat = data.header.flat;
    const { low, high } = data.box();
    this.low = new Vector3(...low);
    this.high = new Vector3(...high);
    this.centre = this.low.clone().add(this.high).multiplyScalar(0.5);
    this.size = Math.max(this.low.distanceTo(this.high), 1e-30);
    this.build();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableRotate = !this.flat;
    this.controls.zoomToCursor = true;
    if (this.flat) this.controls.mouseButtons.LEFT = 2; // pan
    if (this.flat) this.controls.touches.ONE = 1;
    this.controls.addEventListener("change", () => this.draw());
    this.reset();
  }

  build() {
    const { data } = this;
    this.colours = colourTexture();
    this.displacement = new BufferAttribute(new Int16Array(3 * data.nPoints), 3, true);
    this.codes = new BufferAttribute(new Uint16Array(data.nPoints), 1);
    const positions = new BufferAttribute(data.positions, 3);
    const geometry = (indices) => {
      const made = new BufferGeometry();
      made.setAttribute("position", positions);
      made.setAttribute("displacement", this.displacement);
      made.setAttribute("code", this.codes);
      made.setIndex(new BufferAttribute(indices, 1));
      return made;
    };
    const lit = !this.flat;
    this.solid = surfaceMaterial(this.colours, { lit });
    this.glass = surfaceMaterial(this.colours, { lit, show: 2 });
    this.capMaterial = surfaceMaterial(this.colours, { lit: false });
    this.line = lineMaterial();
    this.bodies = data.header.bodies.map((body) => {
      const part = (all, [first, count], width) => all.slice(width * first, width * (first + count));
      const surface = geometry(part(data.triangles, body.triangles, 3));
      const made = {
        header: body,
        visible: true,
        surface: new Mesh(surface, this.solid),
        glass: new Mesh(surface, this.glass),
        lines: new LineSegments(geometry(part(data.edges, body.edges, 2)), this.line),
        cap: new Mesh(new BufferGeometry(), this.capMaterial),
      };
      made.glass.renderOrder = 1;
      made.lines.renderOrder = 2;
      for (const object of [made.surface, made.glass, made.lines, made.cap]) {
        object.frustumCulled = false; // deformed by the shader
        this.scene.add(object);
      }
      return made;
    });
  }

  // state: field, time (indices), warp, low, high (of the colours), lines, bodies (visible or not), plane (null or [n, d])
  show(state) {
    this.state = state;
    const { data } = this;
    const field = data.header.fields[state.field];
    this.displacement.array.set(data.displacement(state.time));
    this.displacement.needsUpdate = true;
    if (field) this.codes.array.set(data.codes(state.field, state.time));
    else this.codes.array.fill(65535);
    this.codes.needsUpdate = true;
    const onContact = Boolean(field && field.on_contact);
    const span = field ? field.max - field.min : 0;
    const range = span > 0 ? [(state.low - field.min) / span, (state.high - field.min) / span] : [-1, 1];
    const warp = state.warp * data.header.largest_displacement;
    for (const material of [this.solid, this.glass, this.capMaterial, this.line]) {
      const uniforms = material.uniforms;
      uniforms.warp.value = material === this.capMaterial ? 0 : warp;
      if (uniforms.range) uniforms.range.value = range;
      uniforms.cut.value = Boolean(state.plane) && material !== this.capMaterial;
      if (state.plane) uniforms.plane.value = new Vector4(...state.plane);
    }
    this.solid.uniforms.show.value = onContact ? 1 : 0;
    this.solid.uniforms.greyBack.value = Boolean(state.plane) && !data.header.has_tetrahedra;
    this.line.uniforms.opacity.value = onContact ? 0.1 : 0.35;
    this.bodies.forEach((body, b) => {
      const visible = state.bodies[b];
      body.surface.visible = visible;
      body.glass.visible = visible && onContact;
      body.lines.visible = visible && state.lines;
    });
    this.cut();
    this.draw();
  }

  cut() {
    const { state, data } = this;
    this.deformed = null;
    for (const [b, body] of this.bodies.entries()) {
      body.cap.visible = Boolean(state.plane && data.header.has_tetrahedra && state.bodies[b]);
      if (!body.cap.visible) continue;
      const made = cutThrough(data.tetrahedra, body.header.tetrahedra, this.places(), this.codes.array, state.plane);
      body.cap.geometry.dispose();
      body.cap.geometry = new BufferGeometry();
      body.cap.geometry.setAttribute("position", new BufferAttribute(made.positions, 3));
      body.cap.geometry.setAttribute("displacement", new BufferAttribute(new Float32Array(made.positions.length), 3));
      body.cap.geometry.setAttribute("code", new BufferAttribute(made.codes, 1));
    }
  }

  // Deformed positions, made when they are first needed.
  places() {
    this.deformed ??= this.data.deformed(this.state.time, this.state.warp);
    return this.deformed;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.frame();
    this.draw();
  }

  // The bodies fill the picture at zoom 1.
  frame() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    let wide = 1e-30, tall = 1e-30;
    for (let corner = 0; corner < 8; corner++) {
      const at = new Vector3(
        corner & 1 ? this.low.x : this.high.x, corner & 2 ? this.low.y : this.high.y, corner & 4 ? this.low.z : this.high.z,
      ).sub(this.centre);
      wide = Math.max(wide, 2 * Math.abs(at.dot(right)));
      tall = Math.max(tall, 2 * Math.abs(at.dot(up)));
    }
    if (!this.framed) this.span = Math.max(tall, (wide * height) / width) / FILLED;
    this.framed = true;
    const half = this.span / 2, aspect = width / height;
    Object.assign(this.camera, {
      left: -half * aspect, right: half * aspect, top: half, bottom: -half, near: -10 * this.size, far: 20 * this.size,
    });
    this.camera.updateProjectionMatrix();
  }

  reset() {
    const direction = this.flat ? new Vector3(0, 0, 1) : OBLIQUE;
    this.camera.up.set(0, this.flat ? 1 : 0, this.flat ? 0 : 1);
    this.camera.position.copy(this.centre).addScaledVector(direction, 2 * this.size);
    this.camera.zoom = 1;
    this.controls.target.copy(this.centre);
    this.camera.lookAt(this.centre);
    this.camera.updateMatrixWorld();
    this.framed = false;
    this.controls.update();
    this.resize();
  }

  // Marks triangles, given as pairs of the first one and their number.
  highlight(ranges) {
    this.marked?.[0].geometry.dispose();
    if (this.marked) this.scene.remove(...this.marked);
    this.marked = null;
    if (ranges.length) {
      const { data } = this;
      const made = new BufferGeometry();
      made.setAttribute("position", new BufferAttribute(data.positions, 3));
      made.setIndex(ranges.flatMap(([first, n]) => [...data.triangles.subarray(3 * first, 3 * (first + n))]));
      const material = (opacity, depthTest) =>
        new MeshBasicMaterial({
          color: MARK, side: DoubleSide, transparent: true, opacity, depthTest, polygonOffset: true, polygonOffsetFactor: -1,
          polygonOffsetUnits: -1,
        });
      this.markMaterials ??= [material(0.2, false), material(0.8, true)]; // behind others it shows through
      this.marked = this.markMaterials.map((one) => new Mesh(made, one));
      for (const one of this.marked) one.renderOrder = 3;
      this.scene.add(...this.marked);
    }
    this.draw();
  }

  // Looks at the points that have a value: the contact surfaces, with some of what is around them.
  lookAtValues() {
    const { array } = this.codes;
    const places = this.places();
    const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
    const at = new Vector3();
    for (let i = 0; i < array.length; i++) {
      if (array[i] === 65535) continue;
      at.fromArray(places, 3 * i);
      low.min(at);
      high.max(at);
    }
    if (!(low.x <= high.x)) return;
    const centre = low.clone().add(high).multiplyScalar(0.5);
    const size = Math.max(low.distanceTo(high), 1e-3 * this.size);
    const arm = this.camera.position.clone().sub(this.controls.target);
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).add(arm);
    this.camera.zoom = Math.max(1, this.span / (1.8 * size));
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  turn(across, upward) {
    if (this.flat) return this.pan(across, upward);
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.applyAxisAngle(this.camera.up, across * TURN);
    const side = new Vector3().crossVectors(this.camera.up, arm).normalize();
    const angle = arm.angleTo(this.camera.up) + upward * TURN;
    if (angle > 0.02 && angle < Math.PI - 0.02) arm.applyAxisAngle(side, upward * TURN);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.draw();
  }

  pan(across, upward) {
    const step = (0.05 * this.span) / this.camera.zoom;
    const move = new Vector3(across * step, -upward * step, 0);
    this.camera.position.add(move);
    this.controls.target.add(move);
    this.controls.update();
    this.draw();
  }

  zoom(factor) {
    this.camera.zoom = Math.min(Math.max(this.camera.zoom * factor, 0.2), 200);
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  // What is at a place of the canvas, in CSS pixels: {body, place, value}; null if nothing is.
  pick(x, y) {
    const at = new Vector2((2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight);
    const ray = rayAt(this.camera, at.x, at.y);
    const { state, data } = this;
    const plane = state.plane;
    const kept = (place) => !plane || plane[0] * place.x + plane[1] * place.y + plane[2] * place.z <= plane[3];
    let best = null;
    this.bodies.forEach((body, b) => {
      if (!state.bodies[b]) return;
      const consider = (hit, codes) => {
        if (!hit || (best && hit.distance >= best.distance)) return;
        const parts = hit.corners.map((corner) => (data.header.fields.length ? data.value(state.field, codes[corner]) : NaN));
        const value = parts.reduce((sum, part, k) => sum + part * hit.weights[k], 0);
        best = { distance: hit.distance, triangle: hit.triangle, body: body.header.name, place: hit.place, value };
      };
      consider(nearestHit(ray, this.places(), data.triangles, body.header.triangles, kept), this.codes.array);
      if (!body.cap.visible) return;
      const { position, code } = body.cap.geometry.attributes;
      const order = Uint32Array.from({ length: position.count }, (_, i) => i);
      consider(nearestHit(ray, position.array, order, [0, position.count / 3], () => true), code.array);
    });
    return best;
  }

  // Directions of the axes in the picture, x to the right, y upward, z to the viewer.
  axes() {
    return [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map((axis) =>
      axis.transformDirection(this.camera.matrixWorldInverse),
    );
  }

  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.camera.updateMatrixWorld();
      this.renderer.render(this.scene, this.camera);
      this.onChange();
    });
  }

  dispose() {
    cancelAnimationFrame(this.waiting);
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
