// Compounds of CAD files may list a shape again: a solid twice, beside it its shell or its faces. What
// occt-import-js then gives several times is taken once. Such copies are triangulated alike, so that equal
// means equal in every bit.

/** The points of a face, which belong to it alone: from `low` to `high`. */
function facesOf(mesh) {
  const { index: { array }, brep_faces: faces } = mesh;
  return faces.filter(({ first, last }) => last >= first).map(({ first, last }) => {
    let low = array[3 * first], high = low;
    for (let i = 3 * first; i < 3 * (last + 1); ++i) {
      low = Math.min(low, array[i]);
      high = Math.max(high, array[i]);
    }
    return { mesh, first, last, low, high };
  });
}

const pointOf = ({ mesh }, v) => mesh.attributes.position.array.slice(3 * v, 3 * v + 3);
const cornersOf = ({ mesh, first, low }) => [0, 1, 2].map((k) => mesh.index.array[3 * first + k] - low);

/** What equal faces have in common, and others seldom. */
const keyOf = (face) =>
  [face.last - face.first, ...pointOf(face, face.low), ...pointOf(face, face.high)].join();

/** 1 for the same face, -1 for the same one turned over, 0 for another. */
function sameness(a, b) {
  const p = a.mesh.attributes.position.array, q = b.mesh.attributes.position.array;
  if (a.last - a.first !== b.last - b.first || a.high - a.low !== b.high - b.low) return 0;
  for (let i = 0; i < 3 * (a.high - a.low + 1); ++i) if (p[3 * a.low + i] !== q[3 * b.low + i]) return 0;
  const [u, v, w] = cornersOf(a), other = cornersOf(b), at = other.indexOf(u);
  if (at < 0) return 0;
  const [next, last] = [other[(at + 1) % 3], other[(at + 2) % 3]];
  return next === v && last === w ? 1 : next === w && last === v ? -1 : 0;
}

/** The mesh of some of its faces. */
function meshOf(mesh, faces) {
  const index = [], position = [], brepFaces = [];
  for (const { first, last, low, high } of faces) {
    const shift = position.length / 3 - low, begin = index.length / 3;
    for (let i = 3 * first; i < 3 * (last + 1); ++i) index.push(mesh.index.array[i] + shift);
    for (let i = 3 * low; i < 3 * (high + 1); ++i) position.push(mesh.attributes.position.array[i]);
    brepFaces.push({ first: begin, last: index.length / 3 - 1 });
  }
  return { ...mesh, index: { array: index }, attributes: { position: { array: position } }, brep_faces: brepFaces };
}

/** Whether every edge has two triangles, where equal points are one. */
function isClosed({ index: { array }, attributes: { position: { array: p } } }) {
  const numbers = new Map(), count = new Map();
  const pointOf = (v) => {
    const key = [p[3 * v], p[3 * v + 1], p[3 * v + 2]].join();
    if (!numbers.has(key)) numbers.set(key, numbers.size);
    return numbers.get(key);
  };
  for (let i = 0; i < array.length; ++i) {
    const [a, b] = [pointOf(array[i]), pointOf(array[i % 3 === 2 ? i - 2 : i + 1])];
    const edge = Math.min(a, b) * 2 ** 26 + Math.max(a, b);
    if (a !== b) count.set(edge, (count.get(edge) ?? 0) + 1);
  }
  return [...count.values()].every((triangles) => triangles > 1);
}

/** A mesh with each of its faces once. */
function ownOnce(mesh, faces) {
  const known = new Map();
  const kept = faces.filter((face) => {
    const key = keyOf(face), alike = known.get(key) ?? [];
    known.set(key, [...alike, face]);
    return !alike.some((other) => sameness(face, other) === 1);
  });
  return kept.length < faces.length ? meshOf(mesh, kept) : mesh;
}

/**
 * A mesh without what is there before. A closed one stays closed; and where all that it shares is turned over, it is a
 * body that touches others, or fills a hole of one.
 */
function remaining(mesh, earlier) {
  const all = facesOf(mesh);
  if (all.reduce((sum, { first, last }) => sum + last - first + 1, 0) !== mesh.index.array.length / 3)
    return { ...mesh, closed: isClosed(mesh) };  // triangles of no face, or of several
  const once = ownOnce(mesh, all), faces = facesOf(once);
  const whole = { ...once, closed: isClosed(once) };
  const found = faces.map(earlier), kept = faces.filter((_, i) => found[i] === 0);
  if (kept.length === faces.length || (whole.closed && !found.includes(1))) return whole;
  if (kept.length === 0) return undefined;
  const rest = meshOf(once, kept), closed = isClosed(rest);
  return whole.closed && !closed ? whole : { ...rest, closed };
}

/** Meshes of occt-import-js, each shape once, and with `closed` beside what they have. */
export function withoutRepeats(meshes) {
  const known = new Map();
  const earlier = (face) => {
    const alike = (known.get(keyOf(face)) ?? []).map((other) => sameness(face, other));
    return alike.includes(1) ? 1 : alike.includes(-1) ? -1 : 0;
  };
  return meshes.flatMap((mesh) => {
    const rest = remaining(mesh, earlier);
    if (rest === undefined) return [];
    for (const face of facesOf(rest)) {
      const key = keyOf(face);
      known.set(key, [...known.get(key) ?? [], face]);
    }
    return [rest];
  });
}
