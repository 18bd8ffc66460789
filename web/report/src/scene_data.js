// The numbers of a scene: header in JSON, data as base64 of a zlib stream (docs/report.md says how they are laid out).

const NO_VALUE = 65535;

async function inflated(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

function aligned(offset) {
  return Math.ceil(offset / 4) * 4;
}

export class SceneData {
  static async read(id) {
    const header = JSON.parse(document.getElementById(id).textContent);
    const buffer = await inflated(document.getElementById(id + "-data").textContent.trim());
    return new SceneData(header, buffer);
  }

  constructor(header, buffer) {
    this.header = header;
    this.nPoints = header.surface_points + header.inner_points;
    const count = (key) => header.bodies.reduce((sum, body) => sum + body[key][1], 0);
    let offset = 0;
    const block = (Type, length) => {
      const view = new Type(buffer, offset, length);
      offset = aligned(offset + view.byteLength);
      return view;
    };
    this.positions = block(Float32Array, 3 * this.nPoints);
    this.triangles = block(Uint32Array, 3 * count("triangles"));
    this.edges = block(Uint32Array, 2 * count("edges"));
    this.tetrahedra = block(Uint32Array, 4 * count("tetrahedra"));
    const n = header.times.length;
    this.displacements = block(Int16Array, 3 * this.nPoints * n);
    this.values = block(Uint16Array, this.nPoints * n * header.fields.length);
  }

  // Codes of one time: divide by 32767 and multiply by largest_displacement.
  displacement(time) {
    return this.displacements.subarray(3 * this.nPoints * time, 3 * this.nPoints * (time + 1));
  }

  // Codes of one field at one time, as value() takes them.
  codes(field, time) {
    const first = this.nPoints * (field * this.header.times.length + time);
    return this.values.subarray(first, first + this.nPoints);
  }

  // NaN where there is none.
  value(field, code) {
    const { min, max } = this.header.fields[field];
    return code === NO_VALUE ? NaN : min + (code / (NO_VALUE - 1)) * (max - min);
  }

  // Smallest and largest value at one time; null if there is none.
  range(field, time) {
    let low = NO_VALUE, high = -1;
    for (const code of this.codes(field, time)) {
      if (code === NO_VALUE) continue;
      if (code < low) low = code;
      if (code > high) high = code;
    }
    return high < 0 ? null : [this.value(field, low), this.value(field, high)];
  }

  // The box around all points in the mesh.
  box() {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.positions.length; i++) {
      low[i % 3] = Math.min(low[i % 3], this.positions[i]);
      high[i % 3] = Math.max(high[i % 3], this.positions[i]);
    }
    return { low, high };
  }

  // Deformed positions of all points.
  deformed(time, warp) {
    const moved = new Float32Array(this.positions);
    const factor = (warp * this.header.largest_displacement) / 32767;
    const codes = this.displacement(time);
    if (factor !== 0) for (let i = 0; i < moved.length; i++) moved[i] += factor * codes[i];
    return moved;
  }
}

export { NO_VALUE };
