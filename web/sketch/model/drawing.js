// Changes of a drawing: each makes a new one and leaves the old as it was. A place names a vertex
// and the edge that leaves it: a loop of a region, or with region -1 a line, or with -2 a point of
// its own. Vertices at the same coordinates move together, so regions that share an edge keep it.
/** @import { Drawing, Point, Region } from '../../types' */
import { boxOf, distance, encloses, midpoint, samePlace, shareInside, signedArea } from './geometry.js';

/** @typedef {{region: number, loop: number, vertex: number}} Place */

export const lineRegion = -1, pointRegion = -2;

/** @param {{region: number}} place */
export const isClosed = ({ region }) => region >= 0;

/** The vertices of the loop, line or point that a place is of. @param {Drawing} drawing  @param {{region: number, loop: number}} place  @returns {Point[]} */
export function pathOf({ regions, polylines, points }, { region, loop }) {
  if (region === lineRegion) return polylines[loop]?.points ?? [];
  if (region === pointRegion) return points[loop] ? [points[loop].position] : [];
  return regions[region]?.loops[loop] ?? [];
}

/** @param {Drawing} drawing  @param {Place} place  @returns {Point | undefined} */
export const vertexAt = (drawing, place) => pathOf(drawing, place)[place.vertex];

/** All loops, lines and points. @param {Drawing} drawing  @returns {{region: number, loop: number, points: Point[]}[]} */
export function pathsOf({ regions, polylines, points }) {
  return [
    ...regions.flatMap(({ loops }, region) => loops.map((loop, i) => ({ region, loop: i, points: loop }))),
    ...polylines.map((line, loop) => ({ region: lineRegion, loop, points: line.points })),
    ...points.map(({ position }, loop) => ({ region: pointRegion, loop, points: [position] })),
  ];
}

/** @param {Drawing} drawing */
export const vertexCount = (drawing) => pathsOf(drawing).reduce((sum, { points }) => sum + points.length, 0);

/** The path with other vertices, and other tags where given. @param {Drawing} drawing  @param {{region: number, loop: number}} place
 *  @param {Point[]} points  @param {string[]} [tags]  @returns {Drawing} */
function withPath(drawing, { region, loop }, points, tags) {
  if (region === lineRegion) return { ...drawing, polylines: drawing.polylines.with(loop, { ...drawing.polylines[loop], points }) };
  if (region === pointRegion) return { ...drawing, points: drawing.points.with(loop, { ...drawing.points[loop], position: points[0] }) };
  const old = drawing.regions[region];
  const changed = { ...old, loops: old.loops.with(loop, points), ...(tags && old.tags && { tags: old.tags.with(loop, tags) }) };
  return { ...drawing, regions: drawing.regions.with(region, changed) };
}

/** @param {Drawing} drawing  @param {{region: number, loop: number}} place  @returns {string[]} one per edge */
function tagsOf({ regions }, { region, loop }) {
  return regions[region]?.tags?.[loop] ?? [];
}

/** The name of the edge that leaves a place. @param {Drawing} drawing  @param {Place} place */
export const tagOf = (drawing, place) => place.region >= 0 ? tagsOf(drawing, place)[place.vertex] ?? '' :
  (place.region === lineRegion ? drawing.polylines : drawing.points)[place.loop]?.tag ?? '';

/** @param {Drawing} drawing  @param {Place} place  @param {string} tag  of a line or point: all of it  @returns {Drawing} */
export function withTag(drawing, { region, loop, vertex }, tag) {
  if (region === lineRegion) return { ...drawing, polylines: drawing.polylines.with(loop, { ...drawing.polylines[loop], tag }) };
  if (region === pointRegion) return { ...drawing, points: drawing.points.with(loop, { ...drawing.points[loop], tag }) };
  const old = drawing.regions[region];
  const tags = old.tags ?? old.loops.map((points) => points.map(() => ''));
  const changed = { ...old, tags: tags.with(loop, tags[loop].with(vertex, tag)) };
  return { ...drawing, regions: drawing.regions.with(region, changed) };
}

/** @param {Drawing} drawing  @returns {Drawing} */
export const withoutTags = (drawing) => drawing.regions.every(({ tags }) => tags === undefined) ? drawing
  : { ...drawing, regions: drawing.regions.map(({ name, loops }) => ({ name, loops })) };

/** @param {Point[]} loop */
export const extentOf = (loop) => Math.abs(signedArea(loop));

/** Another outline in the place of one; its edges are called as the first was. @param {Drawing} drawing
 *  @param {{region: number, loop: number}} place  @param {Point[]} points  @returns {Drawing} */
export const replacePath = (drawing, place, points) =>
  withPath(drawing, place, points, points.map(() => tagsOf(drawing, place)[0] ?? ''));

/** Every vertex at the same coordinates. @param {Drawing} drawing  @param {Point} at  @returns {Place[]} */
export function placesAt(drawing, at) {
  /** @type {Place[]} */
  const places = [];
  for (const { region, loop, points } of pathsOf(drawing))
    for (let vertex = 0; vertex < points.length; ++vertex)
      if (samePlace(points[vertex], at)) places.push({ region, loop, vertex });
  return places;
}

/** @param {Drawing} drawing  @param {Place[]} places  @param {Point} to  @returns {Drawing} */
export function movePlaces(drawing, places, to) {
  return places.reduce((result, place) => withPath(result, place, pathOf(result, place).with(place.vertex, to)), drawing);
}

/** @param {Drawing} drawing  @param {Place} place  @param {Point} to  @returns {Drawing} */
export function moveVertex(drawing, place, to) {
  const from = vertexAt(drawing, place);
  return from ? movePlaces(drawing, placesAt(drawing, from), to) : drawing;
}

/** Replaces every vertex by what `map` makes of it, where that is another. @param {Drawing} drawing  @param {(p: Point) => Point} map  @returns {Drawing} */
export function mapVertices({ regions, polylines, points }, map) {
  const all = (/** @type {Point[]} */ path) => path.map(map);
  return {
    regions: regions.map((region) => ({ ...region, loops: region.loops.map(all) })),
    polylines: polylines.map((line) => ({ ...line, points: all(line.points) })),
    points: points.map((point) => ({ ...point, position: map(point.position) })),
  };
}

const keyOf = (/** @type {Point} */ [x, y]) => `${x} ${y}`;

/** Gives a whole loop or line other vertices, one for one; what shared the old ones follows.
 *  @param {Drawing} drawing  @param {{region: number, loop: number}} place  @param {Point[]} to  @returns {Drawing} */
export function movePath(drawing, place, to) {
  const moved = new Map(pathOf(drawing, place).map((p, i) => [keyOf(p), to[i]]));
  const touches = (/** @type {Point[]} */ path) => path.some((p) => moved.has(keyOf(p)));
  return pathsOf(drawing).filter(({ points }) => touches(points)).reduce(
    (result, path) => withPath(result, path, path.points.map((p) => moved.get(keyOf(p)) ?? p)), drawing);
}

/** @param {Drawing} drawing  @param {{region: number, loop: number}} place  @param {number} dx  @param {number} dy */
export const shiftPath = (drawing, place, dx, dy) =>
  movePath(drawing, place, pathOf(drawing, place).map(([x, y]) => [x + dx, y + dy]));

/** Edges with the same two ends as that of a place, itself among them. @param {Drawing} drawing  @param {Place} place  @returns {Place[]} */
export function edgesWithEndsOf(drawing, place) {
  const path = pathOf(drawing, place);
  const a = path[place.vertex], b = path[(place.vertex + 1) % path.length];
  /** @type {Place[]} */
  const edges = [];
  for (const { region, loop, points } of pathsOf(drawing))
    for (let vertex = 0; vertex < points.length - (region >= 0 ? 0 : 1); ++vertex) {
      const p = points[vertex], q = points[(vertex + 1) % points.length];
      if ((samePlace(p, a) && samePlace(q, b)) || (samePlace(p, b) && samePlace(q, a))) edges.push({ region, loop, vertex });
    }
  return edges;
}

/** A vertex in the middle of an edge, in all that share it. @param {Drawing} drawing  @param {Place} place  the edge  @param {Point} at  @returns {Drawing} */
export function addVertex(drawing, place, at) {
  return edgesWithEndsOf(drawing, place).reduce((result, edge) => {
    const tags = tagsOf(result, edge);
    return withPath(result, edge, pathOf(result, edge).toSpliced(edge.vertex + 1, 0, at),
      tags.toSpliced(edge.vertex + 1, 0, tags[edge.vertex] ?? ''));
  }, drawing);
}

/** Without a vertex, in all that share it; what is left of too few goes too. @param {Drawing} drawing  @param {Place} place  @returns {Drawing} */
export function removeVertex(drawing, place) {
  const at = vertexAt(drawing, place);
  if (!at) return drawing;
  const places = placesAt(drawing, at).toSorted((p, q) => q.vertex - p.vertex);
  return withoutScraps(places.reduce((result, p) => removeHere(result, p), drawing));
}

/** @param {Drawing} drawing  @param {Place} place  @returns {Drawing} */
function removeHere(drawing, place) {
  if (place.region === pointRegion) return { ...drawing, points: drawing.points.toSpliced(place.loop, 1, { position: [NaN, NaN], tag: '' }) };
  const { vertex } = place;
  const path = pathOf(drawing, place), tags = tagsOf(drawing, place);
  const before = (vertex + path.length - 1) % path.length;
  // The edge before the vertex goes on to the next one and keeps its tag, if it has one.
  const kept = tags.length > 0 && !tags[before] ? tags.with(before, tags[vertex]) : tags;
  return withPath(drawing, place, path.toSpliced(vertex, 1), kept.toSpliced(vertex, 1));
}

/** Loops of fewer than three vertices, lines of fewer than two and regions without loops go. @param {Drawing} drawing  @returns {Drawing} */
function withoutScraps({ regions, polylines, points }) {
  return {
    regions: regions.map((region) => withLoops(region, (loop) => loop.length >= 3)).filter(({ loops }) => loops.length > 0),
    polylines: polylines.filter((line) => line.points.length >= 2),
    points: points.filter(({ position: [x] }) => !Number.isNaN(x)),
  };
}

/** @param {Region} region  @param {(loop: Point[], index: number) => boolean} keep  @returns {Region} */
function withLoops(region, keep) {
  if (region.loops.every(keep)) return region;
  const { loops, tags } = region;
  return { ...region, loops: loops.filter(keep), ...(tags && { tags: tags.filter((_, i) => keep(loops[i], i)) }) };
}

/** The loop of largest area bounds its region. @param {Region} region */
export function outlineOf({ loops }) {
  const areas = loops.map((loop) => Math.abs(signedArea(loop)));
  return areas.indexOf(Math.max(...areas));
}

/** Without a loop, line or point. With its outline a region goes. @param {Drawing} drawing  @param {{region: number, loop: number}} place  @returns {Drawing} */
export function removePath(drawing, { region, loop }) {
  if (region === lineRegion) return { ...drawing, polylines: drawing.polylines.toSpliced(loop, 1) };
  if (region === pointRegion) return { ...drawing, points: drawing.points.toSpliced(loop, 1) };
  const old = drawing.regions[region];
  if (!old) return drawing;
  if (outlineOf(old) === loop) return removeRegion(drawing, region);
  return { ...drawing, regions: drawing.regions.with(region, withLoops(old, (_, i) => i !== loop)) };
}

/** @param {Drawing} drawing  @param {number} region  @returns {Drawing} */
export const removeRegion = (drawing, region) => ({ ...drawing, regions: drawing.regions.toSpliced(region, 1) });

/** @param {Drawing} drawing  @param {Region} region  @returns {Drawing} */
const addRegion = (drawing, region) => ({ ...drawing, regions: [...drawing.regions, region] });

/** @param {Drawing} drawing  @param {number} region  @param {Point[]} loop  @returns {Drawing} */
export function addHole(drawing, region, loop) {
  const old = drawing.regions[region];
  const tags = old.tags && { tags: [...old.tags, loop.map(() => '')] };
  return { ...drawing, regions: drawing.regions.with(region, { ...old, loops: [...old.loops, loop], ...tags }) };
}

/** The region that has most of a loop inside, -1 if none. @param {Drawing} drawing  @param {Point[]} loop */
function regionAround({ regions }, loop) {
  return regions.findIndex((region) => {
    const outline = outlineOf(region);
    return shareInside(region.loops[outline], loop) > 0.5
      && !region.loops.some((hole, i) => i !== outline && shareInside(hole, loop) > 0.5);
  });
}

/**
 * Puts a loop where it makes sense: within a region it is a hole; elsewhere, also within a hole, a
 * region of its own; about other regions a region that has them as holes.
 * @param {Drawing} drawing  @param {Point[]} loop  @returns {Drawing}
 */
export function addLoop(drawing, loop) {
  const around = regionAround(drawing, loop);
  if (around >= 0) return addHole(drawing, around, loop);
  const outlines = drawing.regions.map((region) => region.loops[outlineOf(region)]);
  const within = outlines.filter((outline) => shareInside(loop, outline) === 1);
  const holes = within.filter((outline) => !within.some((other) => other !== outline && shareInside(other, outline) === 1));
  return addRegion(drawing, { name: '', loops: [loop, ...holes] });
}

/** Takes a loop out of its region and makes it one of its own. @param {Drawing} drawing  @param {{region: number, loop: number}} place  @returns {Drawing} */
export function makeRegion(drawing, { region, loop }) {
  const { loops, tags } = drawing.regions[region] ?? { loops: [] };
  if (loops.length < 2 || !loops[loop]) return drawing;
  const own = { name: '', loops: [loops[loop]], ...(tags && { tags: [tags[loop]] }) };
  const rest = withLoops(drawing.regions[region], (_, i) => i !== loop);
  return addRegion({ ...drawing, regions: drawing.regions.with(region, rest) }, own);
}

/** @param {Drawing} drawing  @param {Point[]} points  @param {string} [tag]  @returns {Drawing} */
export const addLine = (drawing, points, tag = '') => ({ ...drawing, polylines: [...drawing.polylines, { points, tag }] });

/** @param {Drawing} drawing  @param {Point} position  @param {string} [tag]  @returns {Drawing} */
export const addPoint = (drawing, position, tag = '') => ({ ...drawing, points: [...drawing.points, { position, tag }] });

/** Points that repeat the one before them go. @param {Drawing} drawing  @returns {Drawing} */
export function mergeRepeated(drawing) {
  let result = drawing;
  for (const { region, loop, points } of pathsOf(drawing))
    for (let i = points.length - 1; i >= (region >= 0 ? 0 : 1); --i) {
      const path = pathOf(result, { region, loop });
      if (path.length > 1 && samePlace(path[i], path[(i + path.length - 1) % path.length])) result = removeHere(result, { region, loop, vertex: i });
    }
  const seen = new Set();
  const points = result.points.filter(({ position }) => !seen.has(keyOf(position)) && seen.add(keyOf(position)));
  return withoutScraps({ ...result, points });
}

/** The longest edge of a region, of those that no other region shares if there are such. @param {Drawing} drawing  @param {number} region  @returns {Place | null} */
export function longestEdge(drawing, region) {
  const edges = (drawing.regions[region]?.loops ?? []).flatMap((points, loop) =>
    points.map((p, vertex) => ({ place: { region, loop, vertex }, length: distance(p, points[(vertex + 1) % points.length]) })));
  edges.sort((a, b) => b.length - a.length);
  const free = drawing.regions.length < 2 ? edges[0] : edges.find(({ place }) => edgesWithEndsOf(drawing, place).length === 1);
  return (free ?? edges[0])?.place ?? null;
}

/** The edge, of outlines and lines, whose middle is nearest. @param {Drawing} drawing  @param {Point} at  @returns {Place | null} */
export function edgeNear(drawing, at) {
  const edges = pathsOf(drawing).flatMap(({ region, loop, points }) =>
    points.slice(region >= 0 ? 0 : 1).map((_, vertex) => ({ region, loop, vertex })));
  const away = (/** @type {Place} */ edge) => distance(middleOf(drawing, edge), at);
  return edges.sort((a, b) => away(a) - away(b))[0] ?? null;
}

/** @param {Drawing} drawing  @param {Place} place  an edge  @returns {Point} */
export function middleOf(drawing, place) {
  const path = pathOf(drawing, place);
  return midpoint(path[place.vertex], path[(place.vertex + 1) % path.length]);
}

/** @param {Drawing} drawing  @returns {[left: number, bottom: number, right: number, top: number]} */
export const boxOfDrawing = (drawing) => boxOf(pathsOf(drawing).flatMap(({ points }) => points));

/** Of the box of all there is; 1 for nothing. @param {Drawing} drawing */
export function diagonalOf(drawing) {
  const [left, bottom, right, top] = boxOfDrawing(drawing);
  return left < Infinity ? Math.hypot(right - left, top - bottom) || 1 : 1;
}

/** Of the regions without their holes; 0 where those are more than there is. @param {Drawing} drawing */
export const areaOf = ({ regions }) => Math.max(0, regions.reduce((sum, region) => {
  const outline = outlineOf(region);
  return sum + region.loops.reduce((area, loop, i) => area + (i === outline ? 1 : -1) * extentOf(loop), 0);
}, 0));

/** The region a point lies in, -1 if in none. @param {Drawing} drawing  @param {Point} p */
export const regionAt = ({ regions }, p) =>
  regions.findIndex(({ loops }) => loops.filter((loop) => encloses(loop, p)).length % 2 === 1);
