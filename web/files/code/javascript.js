// The project as a program for Node, and as the JSON that the command line reads.
/** @import { OptionInfo } from 'lpquad' */
/** @import { Drawing, Project, Region } from '../../types' */
import { exactJson } from '../../state/project_file.js';
import { chosen, hasTags, isPlain, nested } from './literals.js';

/** How members and texts are written in JavaScript, and in JSON. */
const javascript = { key: (/** @type {string} */ name) => name, text: (/** @type {string} */ value) => `'${exactJson(value).slice(1, -1).replaceAll('\\"', '"').replaceAll("'", "\\'")}'` };
const json = { key: (/** @type {string} */ name) => `"${name}"`, text: (/** @type {string} */ value) => exactJson(value) };

/** @typedef {typeof javascript} Notation */

/** @param {readonly (readonly number[])[]} rows  @param {string} indent */
const rows = (rows, indent) => nested('[', rows.map((row) => `[${row.map(exactJson).join(', ')}]`), ']', indent);

/** @param {string[]} items  @param {string} indent */
const list = (items, indent) => `[\n${items.map((item) => `${indent}  ${item},`).join('\n').replace(/,$/, '')}\n${indent}]`;

/** @param {Region} region  @param {string} indent  @param {Notation} as @returns {string[]} */
function regionMembers(region, indent, as) {
  const loops = list(region.loops.map((loop) => rows(loop, `${indent}  `)), indent);
  const tags = () => list((region.tags ?? []).map((row) => nested('[', row.map(as.text), ']', `${indent}  `)), indent);
  return [`${as.key('loops')}: ${loops}`, ...(hasTags(region) ? [`${as.key('tags')}: ${tags()}`] : [])];
}

/** @param {string[]} members  @param {string} indent */
const object = (members, indent) => `{\n${members.map((member) => `${indent}  ${member}`).join(',\n')}\n${indent}}`;

/** @param {Drawing} drawing  @param {Notation} as  @param {string[]} [more]  further members */
function domain(drawing, as, more = []) {
  if (isPlain(drawing)) return object([...regionMembers(drawing.regions[0], '  ', as), ...more], '');
  const { key, text } = as;
  const regions = drawing.regions.map((region) => object([`${key('name')}: ${text(region.name)}`, ...regionMembers(region, '      ', as)], '    '));
  const polylines = drawing.polylines.map(({ points, tag }) => `{ ${key('points')}: ${rows(points, '    ')}, ${key('tag')}: ${text(tag)} }`);
  const points = drawing.points.map(({ position, tag }) => `{ ${key('position')}: [${position.map(exactJson).join(', ')}], ${key('tag')}: ${text(tag)} }`);
  return object([
    `${key('regions')}: ${list(regions, '  ')}`,
    ...(polylines.length > 0 ? [`${key('polylines')}: ${list(polylines, '  ')}`] : []),
    ...(points.length > 0 ? [`${key('points')}: ${list(points, '  ')}`] : []),
    ...more,
  ], '');
}

/** The domain as the command line reads it. @param {Project} project */
export function domainJson({ drawing, sizes, guides, seedPoints }) {
  return domain(drawing, json, [
    ...(sizes.length > 0 ? [`"sizes": ${rows(sizes, '  ')}`] : []),
    ...(guides.length > 0 ? [`"guides": ${list(guides.map((guide) => rows(guide, '    ')), '  ')}`] : []),
    ...(seedPoints.length > 0 ? [`"seedPoints": ${rows(seedPoints, '  ')}`] : []),
  ]);
}

/** @param {Project} project  @param {OptionInfo[]} known  @param {string} file  name without ending */
export function toJavaScript(project, known, file) {
  const { sizes, guides, seedPoints } = project;
  const options = [
    ...chosen(project, known).map(([name, value]) => `${name}: ${typeof value === 'string' ? javascript.text(value) : exactJson(value)}`),
    ...(sizes.length > 0 ? [`sizes: ${rows(sizes, '  ')}`] : []),
    ...(guides.length > 0 ? [`guides: ${list(guides.map((guide) => rows(guide, '    ')), '  ')}`] : []),
    ...(seedPoints.length > 0 ? [`seedPoints: ${rows(seedPoints, '  ')}`] : []),
  ];
  const given = options.length === 0 ? '{}' : options.some((option) => option.includes('\n')) ? object(options, '') : nested('{ ', options, ' }');
  return `// npm install lpquad
import { writeFileSync } from 'node:fs';
import { createLpquad } from 'lpquad';

const domain = ${domain(project.drawing, javascript)};
const options = ${given};

const lpquad = await createLpquad();
const mesh = lpquad.meshDomain(domain, options);
console.log(\`\${mesh.quads.length / 4} quads, hash \${mesh.report.hash}\`);
writeFileSync('${file}.msh', lpquad.writeMesh(mesh, 'msh'));
`;
}
