// The project as a C++ program.
/** @import { OptionInfo } from 'lpquad' */
/** @import { Project, Region } from '../../types' */
import { chosen, hasTags, nested } from './literals.js';

/** A literal of type double: 1 alone would be an int, which knows no -0 and not every size. @param {number} value */
const number = (value) => (Object.is(value, -0) ? '-0.0' : /[.e]/.test(String(value)) ? String(value) : `${value}.0`);

/** Bytes beyond ASCII as octal escapes, which end after three digits. @param {string} value */
function text(value) {
  const bytes = [...new TextEncoder().encode(value)];
  return `"${bytes.map((byte) => (byte >= 32 && byte < 127 && byte !== 34 && byte !== 92 ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, '0')}`)).join('')}"`;
}

/** @param {readonly (readonly number[])[]} rows  @param {string} [indent] */
const rows = (rows, indent) => nested('{', rows.map((row) => `{${row.map(number).join(', ')}}`), '}', indent);

/** @param {Region} region  @returns {string[]} statements */
function regionLines(region) {
  return [
    'region = {};',
    ...(region.name === '' ? [] : [`region.name = ${text(region.name)};`]),
    ...region.loops.map((loop) => `region.loops.push_back(${rows(loop, '  ')});`),
    ...(hasTags(region) ? (region.tags ?? []).map((row) => `region.tags.push_back(${nested('{', row.map(text), '}', '  ')});`) : []),
    'domain.regions.push_back(region);',
  ];
}

/** @param {[string, any]} option */
function optionLine([name, value]) {
  const member = name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
  const written = typeof value === 'string' ? `lpq::${name[0].toUpperCase()}${name.slice(1)}::${value.replaceAll('-', '_')}`
    : typeof value === 'number' && !Number.isInteger(value) ? number(value) : String(value);
  return `options.${member} = ${written};`;
}

/** @param {Project} project  @returns {string[]} */
function userLines({ sizes, guides, seedPoints }) {
  return [
    ...(sizes.length > 0 ? [`user.sizes = ${nested('{', sizes.map(([x, y, h]) => `{{${number(x)}, ${number(y)}}, ${number(h)}}`), '}', '  ')};`] : []),
    ...guides.map((guide) => `user.guides.push_back(${rows(guide, '  ')});`),
    ...(seedPoints.length > 0 ? [`user.seeds = ${rows(seedPoints, '  ')};`] : []),
  ];
}

/** @param {Project} project  @param {OptionInfo[]} known  @param {string} file  name without ending */
export function toCpp(project, known, file) {
  const { regions, polylines, points } = project.drawing;
  const user = userLines(project);
  const lines = [
    'lpq::DomainInput domain;',
    'lpq::DomainInput::Region region;',
    ...regions.flatMap(regionLines),
    ...polylines.map(({ points: along, tag }) => `domain.polylines.push_back({${rows(along, '  ')}, ${text(tag)}});`),
    ...points.map(({ position, tag }) => `domain.points.push_back({{${position.map(number).join(', ')}}, ${text(tag)}});`),
    'lpq::Options options;',
    ...chosen(project, known).map(optionLine),
    ...(user.length > 0 ? ['lpq::UserFields user;', ...user] : []),
  ];
  return `// find_package(lpquad REQUIRED)
// target_link_libraries(app PRIVATE lpquad::lpquad lpquad::lpquad_io)
#include <lpquad.h>

#include <cinttypes>
#include <cstdio>
#include <fstream>

#include "io/mesh/msh.h"

int main() {
${lines.map((line) => `  ${line}`).join('\n')}

  const auto result = lpq::mesh_domain(domain, options${user.length > 0 ? ', {}, nullptr, user' : ''});
  if (!result) {
    std::fprintf(stderr, "%s\\n", result.error().message.c_str());
    return 1;
  }
  std::printf("%zu quads, hash %016" PRIx64 "\\n", result->mesh.faces.size(), result->report.hash);
  std::ofstream("${file}.msh") << lpq::write_msh(result->mesh);
}
`;
}
