// What lies under a point of the picture.

import { Ray, Vector3 } from "three";

// Nearest hit of a ray on indexed triangles, as {distance, corners, weights}; null if there is none.
// accept(place): whether that part of a triangle is shown.
export function nearestHit(ray, positions, triangles, [first, count], accept) {
  const a = new Vector3(), b = new Vector3(), c = new Vector3(), at = new Vector3();
  let best = null;
  for (let i = first; i < first + count; i++) {
    const corners = [triangles[3 * i], triangles[3 * i + 1], triangles[3 * i + 2]];
    a.fromArray(positions, 3 * corners[0]);
    b.fromArray(positions, 3 * corners[1]);
    c.fromArray(positions, 3 * corners[2]);
    if (!ray.intersectTriangle(a, b, c, false, at) || !accept(at)) continue;
    const distance = ray.origin.distanceTo(at);
    if (best && distance >= best.distance) continue;
    best = { distance, triangle: i, corners, weights: weights(a, b, c, at), place: at.clone() };
  }
  return best;
}

function weights(a, b, c, at) {
  const area = (p, q, r) => new Vector3().subVectors(q, p).cross(new Vector3().subVectors(r, p)).length();
  const parts = [area(at, b, c), area(a, at, c), area(a, b, at)];
  const all = parts[0] + parts[1] + parts[2];
  return parts.map((part) => (all > 0 ? part / all : 1 / 3));
}

export function rayAt(camera, x, y) {
  const from = new Vector3(x, y, -1).unproject(camera), to = new Vector3(x, y, 1).unproject(camera);
  return new Ray(from, to.sub(from).normalize());
}
