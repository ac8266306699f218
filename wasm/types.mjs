// The types that come from the option tables in C++: generated.d.ts, from what the built library
// says about itself. usage: node wasm/types.mjs [--check]
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const target = fileURLToPath(new URL('js/generated.d.ts', import.meta.url));
const packed = fileURLToPath(new URL('../dist/generated.d.ts', import.meta.url));

const header = fileURLToPath(new URL('../core/base/result.h', import.meta.url));

const quoted = (names) => names.map((name) => `'${name}'`).join(' | ');

const typeOf = (option) =>
  option.type === 'choice' ? quoted(option.choices)
    : option.type === 'boolean' ? 'boolean' : 'number';

function comment(option) {
  const facts = [option.help];
  if (option.type === 'integer') facts.push('A whole number.');
  if (option.unit) facts.push(`Unit: ${option.unit}.`);
  if (option.min !== undefined) facts.push(`Range: ${option.min} to ${option.max}.`);
  return [...facts, `@default ${JSON.stringify(option.default)}`].map((line) => `   * ${line}`);
}

const table = (name, options) => [`export interface ${name} {`,
  ...options.flatMap((option) =>
    ['  /**', ...comment(option), '   */', `  ${option.name}?: ${typeOf(option)};`]), '}', ''];

/** What the header says of each code. */
function meanings() {
  const [, list] = readFileSync(header, 'utf8').match(/enum class ErrorCode \{(.*?)\n\};/s);
  return new Map([...list.matchAll(/^ +(\w+),? +\/\/ (.*)$/gm)].map(([, name, text]) => [name.toUpperCase(), text]));
}

function errorCodes(codes) {
  const said = meanings();
  const lines = codes.map((code) => {
    if (!said.has(code)) throw new Error(`core/base/result.h does not say what ${code} is`);
    return ` * - \`${code}\`: ${said.get(code)}`;
  });
  return ['/**', ' * What is wrong:', ...lines, ' */', `export type ErrorCode =\n  | ${codes.map((c) => `'${c}'`).join('\n  | ')};`, ''];
}

export function generatedTypes(description) {
  return ['// Made by wasm/types.mjs from the option tables of the core; do not edit.', '',
    ...table('MeshOptions', description.options), ...table('SurfaceOptions', description.surfaceOptions),
    ...table('WriteOptions', description.writeOptions),
    ...errorCodes(description.errorCodes),
    `export type MeshFormat = ${quoted(description.meshFormats)};`, '',
    `export type DomainFormat = ${quoted(description.domainFormats)};`, '',
    `export type SurfaceFormat = ${quoted(description.surfaceFormats)};`, '',
    `export type SurfaceMeshFormat = ${quoted(description.surfaceMeshFormats)};`, ''].join('\n');
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { createLpquad } = await import(new URL('../dist/node.js', import.meta.url).href);
  const text = generatedTypes(await createLpquad());
  if (!process.argv.includes('--check')) for (const file of [target, packed]) writeFileSync(file, text);
  else if (readFileSync(target, 'utf8') !== text) {
    console.error('generated.d.ts is not what the library says; run: node wasm/types.mjs');
    process.exitCode = 1;
  }
}
