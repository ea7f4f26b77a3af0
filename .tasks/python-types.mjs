// The types of python/, written from those of JavaScript, which tests/types.rs writes from the tables in the Rust sources.
//
//   node .tasks/python-types.mjs   writes them anew
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { isProgram, top } from './run.mjs';

const source = join(top, 'src/wasm/interface.d.ts');
export const target = join(top, 'python/ep_locomotion/types.py');

/** @typedef {{ about: readonly string[], name: string, isOptional: boolean, type: string }} Field */
/** @typedef {{ about: readonly string[], name: string, fields: readonly Field[] }} Dict */
/** @typedef {{ about: readonly string[], name: string, type: string }} Alias */

/** No field of a class has such a name. */
const keywords = ['from'];
const plain = new Map([
  ['number', 'float'],
  ['string', 'str'],
  ['boolean', 'bool'],
  ['Float64Array', 'List[float]'],
  ['Uint8Array', 'List[bool]'],
]);
/** Fields of whole numbers, which JavaScript has no type for. */
const whole = [
  ...['seed', 'seeds', 'population', 'opponents', 'generation', 'generations', 'donors', 'wins', 'ranking'],
  ...['survivors', 'corners', 'rows', 'part', 'count', 'headings', 'drives'],
];
/** Python takes more for gains than JavaScript. */
const gains = `#: Three gains (kx, ky, kθ), or rows of three: at most a million in one call, fewer where drives are long.
Gains = Union[Sequence[float], Sequence[Union[Sequence[float], Array]], Array]
`;

const head = `"""What goes into the core, and what comes back, as dicts.

Written by .tasks/python-types.mjs from the core's own tables.
"""

from __future__ import annotations

from typing import Any, List, Literal, Optional, Protocol, Sequence, TypedDict, Union


class Listed(Protocol):
    """An array of numpy, a series of pandas and the like."""

    def tolist(self) -> Any: ...


class Table(Protocol):
    """A table of pandas and the like."""

    def to_numpy(self) -> Any: ...


#: Numbers of numpy, pandas and the like.
Array = Union[Listed, Table]
`;

const comment = String.raw`(?: *\/\*\*((?:(?!\*\/)[^])*)\*\/\n)?`;
const declared = new RegExp(
  String.raw`${comment}export (?:interface (\w+) \{\n([^]*?)\n\}|type (\w+) = ([^{;]+);)`,
  'g',
);
const field = new RegExp(String.raw`${comment} *(\w+)(\?)?: ([^;]+);`, 'g');

/** What a comment says, in lines. @param {string} [text] */
const said = (text = '') =>
  text
    .split('\n')
    .map((line) =>
      line
        .replace(/^ *\* ?/, '')
        .trim()
        .replaceAll('`', '``')
        .replace('wordFields', 'word_fields'),
    )
    .filter((line) => line !== '');

/** @param {string} text */
function read(text) {
  /** @type {Dict[]} */
  const dicts = [];
  /** @type {Alias[]} */
  const aliases = [];
  for (const [, about, dict, body, alias, type] of text.matchAll(declared))
    if (alias) aliases.push({ about: said(about), name: alias, type });
    else
      dicts.push({
        about: said(about),
        name: dict,
        fields: [...body.matchAll(field)].map(([, told, name, optional, kind]) => ({
          about: said(told),
          name,
          isOptional: optional !== undefined,
          type: pythonOf(whole.includes(name) ? kind.replaceAll('number', 'int') : kind),
        })),
      });
  return { dicts, aliases };
}

/** @param {string} type @returns {string} */
function pythonOf(type) {
  if (/^'/.test(type)) return `Literal[${type.replaceAll("'", '"').replaceAll(' |', ',')}]`;
  if (type.endsWith(' | null')) return `Optional[${pythonOf(type.slice(0, -' | null'.length))}]`;
  if (type.endsWith('[]')) return `List[${pythonOf(type.slice(0, -2))}]`;
  if (type.startsWith('[')) return type.includes('int') ? 'Sequence[int]' : 'Sequence[float]';
  return plain.get(type) ?? type;
}

/** @param {string} name @param {string} base @param {readonly string[]} about @param {readonly Field[]} fields */
function classOf(name, base, [first, ...more], fields) {
  const rest = more.length > 0 ? `\n    ${more.join('\n    ')}\n    ` : '';
  const told = first ? `    """${first}${rest}"""\n\n` : '';
  const lines = fields.flatMap((one) => [
    ...one.about.map((line) => `    #: ${line}\n`),
    `    ${one.name}: ${one.type}\n`,
  ]);
  return `class ${name}(${base}):\n${told}${lines.join('')}`;
}

/** @param {Dict} dict */
function dictOf({ name, about, fields }) {
  const given = fields.filter(({ isOptional }) => !isOptional);
  const left = fields.filter(({ isOptional }) => isOptional);
  const needed = left.length > 0 ? `_${name}` : name;
  const isClass = given.every((one) => !keywords.includes(one.name));
  const pairs = given.map((one) => `"${one.name}": ${JSON.stringify(one.type)}`);
  const first = isClass
    ? classOf(needed, 'TypedDict', left.length > 0 ? [] : about, given)
    : `${needed} = TypedDict("${needed}", {${pairs.join(', ')}})\n`;
  return left.length > 0 ? [first, classOf(name, `${needed}, total=False`, about, left)] : [first];
}

/** An experiment of which any field may be left out, in its objects too. @param {readonly Dict[]} dicts */
function partialsOf(dicts) {
  const named = (/** @type {string} */ name) => /** @type {Dict} */ (dicts.find((one) => one.name === name));
  const { fields } = named('Experiment');
  const inner = [...new Set(fields.map(({ type }) => type).filter(named))];
  /** In place of a whole part stands any of its fields. @param {string} type */
  const given = (type) => {
    if (type === 'List[Posture]')
      return `Union[Sequence[Union[Posture, PartialPosture, Sequence[float], Array]], Array]`;
    return inner.includes(type) ? `Union[${type}, Partial${type}]` : type;
  };
  const partial = (/** @type {string} */ name, /** @type {readonly Field[]} */ own) =>
    classOf(
      `Partial${name}`,
      'TypedDict, total=False',
      [`Any fields of \`\`${name}\`\`.`],
      own.map((one) => ({ ...one, about: [] })),
    );
  return [
    ...inner.map((name) => partial(name, named(name).fields)),
    partial(
      'Experiment',
      fields.map((one) => ({ ...one, type: given(one.type) })),
    ),
  ];
}

/** The module of types. */
export function pythonTypes() {
  const { dicts, aliases } = read(readFileSync(source, 'utf8'));
  const short = aliases.map(({ about, name, type }) => {
    const lines = about.map((line) => `#: ${line}\n`);
    return name === 'Gains' ? gains : `${lines.join('')}${name} = ${pythonOf(type)}\n`;
  });
  return [head, short.join(''), ...dicts.flatMap(dictOf), ...partialsOf(dicts)].join('\n\n');
}

if (isProgram(import.meta.url)) writeFileSync(target, pythonTypes());
