// Compounds of CAD files may list a shape again: a solid twice, beside it its shell or its faces. What
// occt-import-js then gives several times is taken once. Such copies are triangulated alike, so that equal
// means equal in every bit.

/** With the points of a face, which belong to it alone: from `low` to `high`; `key`: all of them. */
function facesOf({ index: { array }, attributes: { position }, brep_faces: faces }) {
  return faces.filter(({ first, last }) => last >= first).map(({ first, last }) => {
    const part = Array.from(array.slice(3 * first, 3 * last + 3));
    const low = part.reduce((a, b) => Math.min(a, b)), high = part.reduce((a, b) => Math.max(a, b));
    const corners = part.slice(0, 3).map((v) => v - low);
    return { first, last, low, high, corners, key: `${last - first} ${position.array.slice(3 * low, 3 * high + 3).join()}` };
  });
}

/** 1 for the same way round, -1 for the other. */
function turn([u, v, w], other) {
  const at = other.indexOf(u), next = other[(at + 1) % 3], last = other[(at + 2) % 3];
  return at < 0 ? 0 : next === v && last === w ? 1 : next === w && last === v ? -1 : 0;
}

/** 1 for a face that is known, -1 for one that is known turned over, 0 for another. */
function sameness(known, { key, corners }) {
  const turns = (known.get(key) ?? []).map((other) => turn(corners, other));
  return turns.includes(1) ? 1 : turns.includes(-1) ? -1 : 0;
}

const note = (known, { key, corners }) => known.set(key, [...known.get(key) ?? [], corners]);

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
    const key = p.slice(3 * v, 3 * v + 3).join();
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
    const again = sameness(known, face) === 1;
    note(known, face);
    return !again;
  });
  return kept.length < faces.length ? meshOf(mesh, kept) : mesh;
}

/**
 * A mesh without what is there before. A closed one stays closed; and where all that it shares is turned over, it is a
 * body that touches others, or fills a hole of one.
 */
function remaining(mesh, known) {
  const all = facesOf(mesh);
  if (all.reduce((sum, { first, last }) => sum + last - first + 1, 0) !== mesh.index.array.length / 3)
    return { ...mesh, closed: isClosed(mesh) };  // triangles of no face, or of several
  const once = ownOnce(mesh, all), faces = facesOf(once);
  const whole = { ...once, closed: isClosed(once) };
  const found = faces.map((face) => sameness(known, face)), kept = faces.filter((_, i) => found[i] === 0);
  if (kept.length === faces.length || (whole.closed && !found.includes(1))) return whole;
  const rest = meshOf(once, kept), closed = isClosed(rest);
  return whole.closed && !closed ? whole : { ...rest, closed };
}

/** Meshes of occt-import-js, each shape once, and with `closed` beside what they have. */
export function withoutRepeats(meshes) {
  const known = new Map();
  return meshes.flatMap((mesh) => {
    const rest = remaining(mesh, known);
    facesOf(rest).forEach((face) => note(known, face));
    return rest.index.array.length > 0 ? [rest] : [];
  });
}
