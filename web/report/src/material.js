// One shader for surfaces and cuts: deforms in the vertex shader, looks up the colour per pixel, cuts by a plane.

import { DoubleSide, ShaderMaterial, Vector4 } from "three";

const vertex = /* glsl */ `
attribute vec3 displacement;
attribute float code;
uniform float warp;
varying vec3 place;
varying float share;
varying float none;
void main() {
  place = position + warp * displacement;
  none = code > 65534.5 ? 1.0 : 0.0;
  share = code / 65534.0;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
}`;

const fragment = /* glsl */ `
uniform sampler2D colours;
uniform vec2 range;   // of the colours, in shares of the range of all times
uniform vec4 plane;   // what is beyond it is cut off
uniform bool cut, lit, greyBack;
uniform int show;     // 0: all, 1: what has a value, 2: what has none, as glass
varying vec3 place;
varying float share;
varying float none;
void main() {
  if (cut && dot(plane.xyz, place) > plane.w) discard;
  bool without = none > 0.0;
  if (show == 1 && without) discard;
  if (show == 2 && !without) discard;
  vec3 colour = vec3(0.80, 0.82, 0.84);
  if (!without) {
    float at = clamp((share - range.x) / max(range.y - range.x, 1e-9), 0.0, 1.0);
    colour = texture2D(colours, vec2((at * 255.0 + 0.5) / 256.0, 0.5)).rgb;
  }
  if (greyBack && !gl_FrontFacing) colour = vec3(0.72, 0.74, 0.76);
  float light = 1.0;
  if (lit) {
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    vec3 seen = normalize((viewMatrix * vec4(normal, 0.0)).xyz);
    light = 0.62 + 0.38 * abs(dot(seen, normalize(vec3(0.25, 0.35, 1.0))));
  }
  gl_FragColor = vec4(colour * light, show == 2 ? 0.14 : 1.0);
}`;

export function surfaceMaterial(colours, { lit, show = 0 }) {
  return new ShaderMaterial({
    vertexShader: vertex,
    fragmentShader: fragment,
    side: DoubleSide,
    transparent: show === 2,
    depthWrite: show !== 2,
    polygonOffset: true,
    polygonOffsetFactor: show === 2 ? 4 : 1, // glass lies behind the contact surface that it touches
    polygonOffsetUnits: show === 2 ? 4 : 1,
    uniforms: {
      colours: { value: colours },
      warp: { value: 0 },
      range: { value: [0, 1] },
      plane: { value: new Vector4(0, 0, 1, 0) },
      cut: { value: false },
      lit: { value: lit },
      greyBack: { value: false },
      show: { value: show },
    },
  });
}

const lineVertex = /* glsl */ `
attribute vec3 displacement;
uniform float warp;
varying vec3 place;
void main() {
  place = position + warp * displacement;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
}`;

const lineFragment = /* glsl */ `
uniform vec4 plane;
uniform bool cut;
uniform float opacity;
varying vec3 place;
void main() {
  if (cut && dot(plane.xyz, place) > plane.w) discard;
  gl_FragColor = vec4(0.07, 0.11, 0.15, opacity);
}`;

export function lineMaterial() {
  return new ShaderMaterial({
    vertexShader: lineVertex,
    fragmentShader: lineFragment,
    transparent: true,
    uniforms: {
      warp: { value: 0 },
      plane: { value: new Vector4(0, 0, 1, 0) },
      cut: { value: false },
      opacity: { value: 0.35 },
    },
  });
}
