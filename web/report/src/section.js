// The cut of a plane through tetrahedra, with the values on it.

// plane: [nx, ny, nz, d], points with n . x > d are cut off. codes: of the field shown.
// Returns the triangles of the cut: positions and codes of their corners.
export function cutThrough(tetrahedra, [first, count], positions, codes, plane) {
  const [nx, ny, nz, d] = plane;
  const places = [], values = [];
  const distance = (point) =>
    nx * positions[3 * point] + ny * positions[3 * point + 1] + nz * positions[3 * point + 2] - d;
  const between = (a, b, da, db) => {
    const share = da / (da - db);
    for (let k = 0; k < 3; k++)
      places.push(positions[3 * a + k] + share * (positions[3 * b + k] - positions[3 * a + k]));
    const none = codes[a] === 65535 || codes[b] === 65535;
    values.push(none ? 65535 : codes[a] + share * (codes[b] - codes[a]));
  };
  const triangle = (...pairs) => pairs.forEach(([a, b, da, db]) => between(a, b, da, db));
  for (let cell = first; cell < first + count; cell++) {
    const kept = [], gone = [];
    for (let k = 0; k < 4; k++) {
      const point = tetrahedra[4 * cell + k], at = distance(point);
      (at > 0 ? gone : kept).push([point, at]);
    }
    if (!kept.length || !gone.length) continue;
    const edge = (inside, outside) => [inside[0], outside[0], inside[1], outside[1]];
    if (kept.length === 2) {
      const corners = [edge(kept[0], gone[0]), edge(kept[0], gone[1]), edge(kept[1], gone[1]), edge(kept[1], gone[0])];
      triangle(corners[0], corners[1], corners[2]);
      triangle(corners[0], corners[2], corners[3]);
    } else {
      const [alone, others] = kept.length === 1 ? [kept[0], gone] : [gone[0], kept];
      triangle(...others.map((other) => (kept.length === 1 ? edge(alone, other) : edge(other, alone))));
    }
  }
  return { positions: new Float32Array(places), codes: new Float32Array(values) };
}
