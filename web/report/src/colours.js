// The colour table: viridis, which colour-blind people can read and which prints in order of lightness.

import { DataTexture, LinearFilter, RGBAFormat, UnsignedByteType } from "three";
import points from "./colours.json";

const STEPS = 256;

function colour(position) {
  const next = points.findIndex((point) => point[0] >= position);
  if (next <= 0) return points[next === 0 ? 0 : points.length - 1].slice(1);
  const [before, after] = [points[next - 1], points[next]];
  const share = (position - before[0]) / (after[0] - before[0]);
  return [1, 2, 3].map((k) => before[k] + share * (after[k] - before[k]));
}

export function colourTexture() {
  const bytes = new Uint8Array(4 * STEPS);
  for (let i = 0; i < STEPS; i++) {
    colour(i / (STEPS - 1)).forEach((part, k) => (bytes[4 * i + k] = Math.round(255 * part)));
    bytes[4 * i + 3] = 255;
  }
  const texture = new DataTexture(bytes, STEPS, 1, RGBAFormat, UnsignedByteType);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export function cssGradient() {
  const stops = points.map(([position, ...rgb]) => {
    const parts = rgb.map((part) => Math.round(255 * part)).join(" ");
    return `rgb(${parts}) ${100 * position}%`;
  });
  return `linear-gradient(to top, ${stops.join(", ")})`;
}
