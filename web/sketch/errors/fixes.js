// What can be done about an error: one step of undo each, or an action of the page.
/** @import { Drawing, Point, Project, Run } from '../../types' */
/** @import { Place } from '../model/drawing.js' */
/** @typedef {NonNullable<Run['error']>} Problem */
import { withSize } from '../../mesh/options.js';
import { askedSize } from '../../run/preview.js';
import { findMeetings } from '../crossings.js';
import { emptyDrawing } from '../../state/project.js';
import * as model from '../model/drawing.js';
import { centreOf, distance, midpoint, samePlace, shareInside } from '../model/geometry.js';
import { simplifiedLoop } from '../model/smooth.js';
import { withDrawing } from '../sketch.js';

/** @typedef {{label: string, change: (project: Project) => Partial<Project>} | {label: string, action: string}} Fix */

/** @param {string} label  @param {(drawing: Drawing, project: Project) => Drawing} change  @returns {Fix} */
const redraw = (label, change) => ({ label, change: (project) => withDrawing(project, change(project.drawing, project)) });

/** @param {string} label  @param {(project: Project) => Project['options']} options  @returns {Fix} */
const choose = (label, options) => ({ label, change: (project) => ({ options: { ...project.options, ...options(project) } }) });

const undo = { label: 'Undo', action: 'edit.undo' }, again = { label: 'Run again', action: 'run.again' };
const open = { label: 'Open another file', action: 'file.open' };

/** @param {Problem} problem  @returns {Point | null} */
const given = ({ where: { x, y } }) => x === undefined || y === undefined ? null : [x, y];

/** @param {Problem} problem  @returns {{region: number, loop: number} | null} */
const pathIn = ({ where: { region, loop } }) => loop === undefined ? null : { region: region ?? model.lineRegion, loop };

/** The vertex an error names, or the one at its place. @param {Problem} problem  @param {Drawing} drawing  @returns {Place | null} */
function vertexIn(problem, drawing) {
  const at = given(problem), path = pathIn(problem);
  const there = at && model.placesAt(drawing, at)[0];
  return there ?? (path && { ...path, vertex: problem.where.edge ?? 0 });
}

/** The meeting an error is about, with full names. @param {Problem} problem  @param {Drawing} drawing */
function meetingOf(problem, drawing) {
  const at = given(problem), meetings = findMeetings(drawing);
  return at ? meetings.toSorted((a, b) => distance(a.at, at) - distance(b.at, at))[0] : meetings[0];
}

/** @typedef {{region: number, loop: number, edge: number}} EdgeName */
const startOf = (/** @type {EdgeName} */ { region, loop, edge }) => ({ region, loop, vertex: edge });
const endOf = (/** @type {Drawing} */ drawing, /** @type {EdgeName} */ { region, loop, edge }) =>
  ({ region, loop, vertex: (edge + 1) % model.pathOf(drawing, { region, loop }).length });

/** The change after which the fewest edges meet. @param {Drawing[]} changes  @param {Drawing} otherwise */
const best = (changes, otherwise) =>
  changes.toSorted((a, b) => findMeetings(a).length - findMeetings(b).length)[0] ?? otherwise;

/** Without the one vertex that helps most. @param {Problem} problem  @returns {(drawing: Drawing) => Drawing} */
const removeBest = (problem) => (drawing) => {
  const meeting = meetingOf(problem, drawing);
  const places = meeting ? [...model.placesAt(drawing, meeting.at), ...[meeting.one, meeting.two].flatMap((edge) => [endOf(drawing, edge), startOf(edge)])]
    : [vertexIn(problem, drawing)].filter((place) => place !== null);
  return best(places.map((place) => model.removeVertex(drawing, place)), drawing);
};

/** Reverses the way between two crossing edges of one loop. @param {Problem} problem  @returns {(drawing: Drawing) => Drawing} */
const untangle = (problem) => (drawing) => {
  const meeting = meetingOf(problem, drawing);
  if (!meeting) return drawing;
  const { one, two } = meeting, path = model.pathOf(drawing, one);
  const between = path.slice(one.edge + 1, two.edge + 1).toReversed();
  return model.replacePath(drawing, one, [...path.slice(0, one.edge + 1), ...between, ...path.slice(two.edge + 1)]);
};

/** The outline of less area of the two that meet, gone. @param {Problem} problem  @returns {(drawing: Drawing) => Drawing} */
const removeLesser = (problem) => (drawing) => {
  const meeting = meetingOf(problem, drawing);
  if (!meeting) return removeNamed(problem)(drawing);
  const { one, two } = meeting;
  const size = (/** @type {EdgeName} */ name) => name.region < 0 ? -1 : model.extentOf(model.pathOf(drawing, name));
  return model.removePath(drawing, size(one) < size(two) ? one : two);
};

/** @param {Problem} problem  @returns {(drawing: Drawing) => Drawing} */
const removeNamed = (problem) => (drawing) => {
  const place = pathIn(problem) ?? vertexIn(problem, drawing);
  return place ? model.removePath(drawing, place) : drawing;
};

/** @param {Problem} problem  @returns {(drawing: Drawing) => Drawing} */
const separate = (problem) => (drawing) => {
  const path = pathIn(problem);
  return path && path.region >= 0 ? model.makeRegion(drawing, path) : drawing;
};

/** The touching point becomes a corner of both. @param {Problem} problem  @returns {(drawing: Drawing) => Drawing} */
const joinThere = (problem) => (drawing) => {
  const meeting = meetingOf(problem, drawing), at = meeting?.at ?? given(problem);
  const path = pathIn(problem);
  const edges = meeting ? [meeting.one, meeting.two].map(startOf) : path ? [{ ...path, vertex: problem.where.edge ?? 0 }] : [];
  if (!at) return drawing;
  const carrier = edges.find((edge) => {
    const points = model.pathOf(drawing, edge);
    return !samePlace(points[edge.vertex], at) && !samePlace(points[(edge.vertex + 1) % points.length], at);
  });
  return carrier ? model.addVertex(drawing, carrier, at) : drawing;
};

/** The touching vertex moves a little towards the middle of its neighbours. @param {Problem} problem  @returns {(drawing: Drawing) => Drawing} */
const moveAway = (problem) => (drawing) => {
  const meeting = meetingOf(problem, drawing), at = meeting?.at ?? given(problem);
  if (!at) return drawing;
  const moves = model.placesAt(drawing, at).filter(({ region }) => region >= 0).flatMap((place) => {
    const path = model.pathOf(drawing, place), n = path.length;
    const middle = midpoint(path[(place.vertex + n - 1) % n], path[(place.vertex + 1) % n]);
    return [0.1, -0.1].map((t) => model.movePlaces(drawing, [place], [at[0] + t * (middle[0] - at[0]), at[1] + t * (middle[1] - at[1])]));
  });
  return best([...moves, removeBest(problem)(drawing)], drawing);
};

/** One region within another becomes its inclusion. @param {Drawing} drawing  @returns {Drawing} */
function cutHoles(drawing) {
  const outlines = drawing.regions.map((region) => region.loops[model.outlineOf(region)]);
  return outlines.reduce((result, inner, i) => {
    const around = outlines.findIndex((outer, k) => k !== i && shareInside(outer, inner) === 1
      && !result.regions[k].loops.some((hole) => hole !== outer && (hole === inner || shareInside(hole, inner) > 0.5)));
    return around < 0 ? result : model.addHole(result, around, inner);
  }, drawing);
}

/** @param {Problem} problem  @returns {(drawing: Drawing) => Drawing} */
const removeConflicting = (problem) => (drawing) => {
  const meeting = meetingOf(problem, drawing);
  const region = meeting ? Math.max(meeting.one.region, meeting.two.region) : problem.where.region ?? drawing.regions.length - 1;
  return model.removeRegion(drawing, region);
};

/** @param {Drawing} drawing  @returns {Drawing} */
function onlyNumbers(drawing) {
  let result = drawing;
  for (let bad = firstBad(result); bad; bad = firstBad(result)) result = model.removeVertex(model.movePlaces(result, [bad], [1e300, 1e300]), bad);
  return result;
}

/** @param {Drawing} drawing */
const firstBad = (drawing) => model.pathsOf(drawing).flatMap(({ region, loop, points }) =>
  points.flatMap(([x, y], vertex) => Number.isFinite(x) && Number.isFinite(y) ? [] : [{ region, loop, vertex }]))[0];

const good = (/** @type {number[]} */ numbers) => numbers.every(Number.isFinite);

/** @param {Project} project  @returns {Partial<Project>} */
const withoutBadNumbers = (project) => ({
  ...withDrawing(project, onlyNumbers(project.drawing)), sizes: project.sizes.filter(good),
  guides: project.guides.filter((line) => line.every(good)), seedPoints: project.seedPoints.filter(good),
});

/** @param {Drawing} drawing */
export const fittingSize = (drawing) => Number((model.diagonalOf(drawing) / 40).toPrecision(2));

/** @param {Project} project  @param {number} factor */
const sizeTimes = (project, factor) =>
  Number(((askedSize(project) || Math.sqrt(model.areaOf(project.drawing) / 1000) || fittingSize(project.drawing)) * factor).toPrecision(3));

/** Few enough elements for a browser, and painted sizes not far below. @param {Project} project  @returns {Partial<Project>} */
function larger(project) {
  const size = Math.max(sizeTimes(project, 2), Number(Math.sqrt(model.areaOf(project.drawing) / 5000).toPrecision(2)));
  return { options: withSize(project.options, size), sizes: project.sizes.map(([x, y, h]) => [x, y, Math.max(h, size / 4)]) };
}

/** Moved to the origin, without digits that mean nothing. @param {Project} project  @returns {Partial<Project>} */
function toOrigin({ drawing, sizes, guides, seedPoints }) {
  const [cx, cy] = centreOf(model.pathsOf(drawing).flatMap(({ points }) => points));
  const step = 2 ** Math.floor(Math.log2(model.diagonalOf(drawing) * 1e-12));
  /** @param {Point} p  @returns {Point} */
  const move = ([x, y]) => [Math.round((x - cx) / step) * step, Math.round((y - cy) / step) * step];
  return {
    preset: '', drawing: model.mapVertices(drawing, move), guides: guides.map((line) => line.map(move)), seedPoints: seedPoints.map(move),
    sizes: sizes.map(([x, y, h]) => [...move([x, y]), h]),
  };
}

/** @param {Drawing} drawing  @returns {Drawing} */
const simpler = (drawing) => ({ ...drawing, regions: drawing.regions.map((region) => ({
  name: region.name, loops: region.loops.map((loop) => simplifiedLoop(loop, model.diagonalOf(drawing) / 3000)),
})) });

/** Where the error says so, which it does where lines divide a region. @param {Problem} problem  @param {Project} project */
function splitLongest(problem, { drawing }) {
  const at = given(problem);
  const edge = at ? model.edgeNear(drawing, at) : model.longestEdge(drawing, problem.where.region ?? 0);
  return edge ? model.addVertex(drawing, edge, model.middleOf(drawing, edge)) : drawing;
}

/** @type {Record<string, (problem: Problem, project: Project) => Fix[]>} */
const fixes = {
  PARSE_ERROR: () => [open],
  BAD_OPTION: () => [
    { label: 'Use the default options', change: ({ options: { size = 0 } }) => ({ options: size > 0 ? { size } : {} }) },
    { label: 'Forget the guides', change: ({ guides }) => ({ guides: guides.length > 0 ? [] : guides }) },
    { label: 'Forget the edge names', change: (project) => withDrawing(project, model.withoutTags(project.drawing)) },
  ],
  NON_FINITE: () => [{ label: 'Remove what is not a number', change: withoutBadNumbers }],
  EMPTY: () => [redraw('Begin with a square', (drawing) => model.addLoop({ ...emptyDrawing, polylines: drawing.polylines }, [[0, 0], [1, 0], [1, 1], [0, 1]])),
    { label: 'Draw an outline', action: 'tool.polygon' }],
  TOO_FEW_POINTS: (problem) => [redraw('Remove it', removeNamed(problem)), undo],
  DUPLICATE_POINT: () => [{ label: 'Merge the points', change: (project) =>
    ({ ...withDrawing(project, model.mergeRepeated(project.drawing)), options: { ...project.options, strict: false } }) }],
  ZERO_AREA: (problem) => [redraw('Remove it', removeNamed(problem)), undo],
  SELF_INTERSECTION: (problem, { drawing }) => {
    const { one, two } = meetingOf(problem, drawing) ?? {};
    const same = one && two && one.region === two.region && one.loop === two.loop && one.region >= 0;
    return [redraw('Remove this vertex', removeBest(problem)),
      same ? redraw('Untangle', untangle(problem)) : redraw('Remove the smaller outline', removeLesser(problem)), undo];
  },
  OVERLAPPING_EDGES: (problem) => [redraw('Remove this vertex', removeBest(problem)), redraw('Remove the smaller outline', removeLesser(problem)), undo],
  TOUCHING: (problem, { drawing }) => {
    const { one, two } = meetingOf(problem, drawing) ?? {};
    const apart = one && two && one.region === two.region && one.region >= 0;  // loops of a region never touch
    return [...(apart ? [] : [redraw('Join them there', joinThere(problem))]),
      redraw('Move it away', moveAway(problem)), redraw('Remove this vertex', removeBest(problem)), undo];
  },
  HOLE_OUTSIDE: (problem) => [redraw('Make it a region of its own', separate(problem)), redraw('Remove it', removeNamed(problem)),
    { label: 'Forget the given start', change: ({ seedPoints }) => ({ seedPoints: seedPoints.length > 0 ? [] : seedPoints }) }],
  NESTED_OR_DUPLICATE_HOLE: (problem) => [redraw('Make it a region of its own', separate(problem)), redraw('Remove it', removeNamed(problem))],
  REGION_CONFLICT: (problem) => [redraw('Cut a hole for the inner one', cutHoles), redraw('Remove one of them', removeConflicting(problem)), undo],
  BAD_SIZE: () => [{ label: 'Use a size that fits', change: ({ drawing, options, sizes }) =>
    ({ options: withSize(options, fittingSize(drawing)), sizes: sizes.filter(([, , h]) => h > 0) }) }],
  ODD_BOUNDARY: (problem) => [redraw('Add a node here', (_, project) => splitLongest(problem, project)),
    choose('Allow one added point', () => ({ allowAddedPoint: true })), choose('Allow one triangle', () => ({ elements: 'one-triangle' }))],
  TOO_NARROW: (problem) => [redraw('Remove this vertex', removeBest(problem)), redraw('Simplify the outline', simpler), undo],
  LOST_PRECISION: () => [{ label: 'Move it to the origin', change: toOrigin }, { label: 'Use a larger size', change: larger }],
  TOO_MANY_ELEMENTS: () => [{ label: 'Use a larger size', change: larger }],
  TOO_LARGE: () => [redraw('Simplify the outline', simpler), open],
  NO_VALID_MESH: () => [{ label: 'Use a smaller size', change: (project) => ({ options: withSize(project.options, sizeTimes(project, 0.7)) }) },
    choose('Allow triangles', () => ({ elements: 'quad-dominant' })), choose('Let the boundary be divided', () => ({ keepBoundary: false }))],
  OUT_OF_MEMORY: () => [{ label: 'Use a larger size', change: larger }, again],
  CANCELLED: () => [again],
  IO_ERROR: () => [open],
};

/** @param {Project} project  @param {Partial<Project>} change  whether it changes anything */
function matters(project, change) {
  const wanted = /** @type {Record<string, unknown>} */ (change), now = /** @type {Record<string, unknown>} */ ({ ...project });
  const differs = (/** @type {string} */ key) => key === 'options' ? JSON.stringify(wanted[key]) !== JSON.stringify(now[key]) : wanted[key] !== now[key];
  return Object.keys(wanted).some((key) => key !== 'preset' && differs(key));
}

/** Names only what is there. @param {Problem} problem  @param {Drawing} drawing  @returns {Problem} */
function sound(problem, drawing) {
  const at = given(problem), path = pathIn(problem);
  const { edge, region } = problem.where;
  const size = path ? model.pathOf(drawing, path).length : 0;
  return { ...problem, where: {
    ...(region !== undefined && region < drawing.regions.length && { region }),
    ...(size > 0 && { loop: path?.loop }),
    ...(edge !== undefined && edge < size && { edge }),
    ...(at?.every(Number.isFinite) && { x: at[0], y: at[1] }),
  } };
}

/** What can be done, at least one thing; nothing that would change nothing. @param {Problem} problem  @param {Project} project  @returns {Fix[]} */
export function fixesFor(problem, project) {
  const all = (fixes[problem.code] ?? (() => [again]))(sound(problem, project.drawing), project);
  const useful = all.filter((fix) => !('change' in fix) || matters(project, fix.change(project)));
  return useful.length > 0 ? useful : [undo, again];
}

/** Where to look: the place of the error, or what its fix would touch. @param {Problem} problem  @param {Project} project  @returns {Point | null} */
export function placeOf(problem, { drawing }) {
  const known = sound(problem, drawing);
  const at = given(known), path = pathIn(known), { region, edge } = known.where;
  if (at) return at;
  const shown = problem.code === 'ODD_BOUNDARY' ? model.longestEdge(drawing, region ?? 0)
    : path && edge !== undefined ? { ...path, vertex: edge } : null;
  const middle = shown ? model.middleOf(drawing, shown) : path && model.pathOf(drawing, path)[0];
  return middle?.every(Number.isFinite) ? middle : null;
}
