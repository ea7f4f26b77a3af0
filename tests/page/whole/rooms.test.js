// The page's floor plan: each room imports only from rooms below it, types too.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, normalize, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { test } from '../harness/once.js';

const www = fileURLToPath(new URL('../../../www/', import.meta.url));

/** The rooms, and on which floor each is; those of one floor do not know each other. @type {Readonly<Record<string, number>>} */
const floors = {
  core: 1,
  kit: 1,
  words: 2,
  run: 3,
  lab: 4,
  settings: 4,
  link: 4,
  parts: 5,
  embed: 5,
  lesson: 6,
  share: 7,
  'main.js': 9,
  'page.js': 8,
  'instead.js': 7,
};

const files = readdirSync(www, { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.js'))
  .map((name) => name.split(sep).join('/'));

/** What a file imports, types too, as paths from www/. @param {string} name */
function importsOf(name) {
  const text = readFileSync(join(www, name), 'utf8');
  const specifiers = [
    ...text.matchAll(/(?:from\s+|import\(\s*|import\s+|new URL\(\s*)['"](\.[^'"?]*)[^'"]*['"]/g),
    // As comments have them.
    ...text.matchAll(/@import\s+[^'"]*['"](\.[^'"]*)['"]/g),
  ].map(([, path]) => path);
  return [...new Set(specifiers)].map((path) =>
    normalize(join(dirname(name), path))
      .split(sep)
      .join('/'),
  );
}

/** @param {string} name */
const roomOf = (name) => name.split('/')[0];

test('every file has a room', () => {
  assert.ok(files.length > 150);
  for (const name of files) assert.ok(roomOf(name) in floors, name);
});

test('each room imports only from rooms below it, and no part of the page from another', () => {
  const wrong = files.flatMap((name) =>
    importsOf(name)
      .filter((path) => !path.startsWith('..'))
      .filter((path) => {
        const [own, other] = [roomOf(name), roomOf(path)];
        if (own !== other) return !(floors[other] < floors[own]);
        const [, part] = name.split('/');
        const [, otherPart] = path.split('/');
        return (
          own === 'parts' && name.split('/').length > 2 && path.split('/').length > 2 && part !== otherPart
        );
      })
      .map((path) => `${name} → ${path}`),
  );
  assert.deepEqual(wrong, []);
});

test('only core/ knows the compiled core', () => {
  for (const name of files)
    if (roomOf(name) !== 'core')
      for (const path of importsOf(name)) assert.ok(!path.startsWith('../pkg'), `${name} imports ${path}`);
});

test('nothing that is built rests on the tests, but for the list of known values', () => {
  for (const name of files)
    for (const path of importsOf(name))
      assert.ok(!path.startsWith('../tests') || path === '../tests/golden.json', `${name} imports ${path}`);
});

test('run/ knows no document', () => {
  for (const name of files.filter((one) => roomOf(one) === 'run')) {
    const text = readFileSync(join(www, name), 'utf8').replace(/\/\*\*.*?\*\/|\/\/.*$/gms, '');
    assert.doesNotMatch(text, /\b(document|window|matchMedia|requestAnimationFrame|HTML\w*Element)\b/, name);
  }
});

/** The style sheets, each with its text. */
const sheets = readdirSync(www, { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.css'))
  .map((name) => ({ name, text: readFileSync(join(www, name), 'utf8') }));

test('what size a screen has is asked by name', () => {
  const asking = sheets.filter(({ text }) => /@media[^{]*(width|height)/.test(text));
  assert.deepEqual(
    asking.map(({ name }) => name),
    [],
  );
});

test('what lights up under a pointer does so only for one that hovers: a finger that has left lights nothing', () => {
  const within = /@media \(hover: hover\) \{\n( *)[\s\S]*?\n(?!\1)/g;
  const lasting = sheets.filter(({ text }) => text.replace(within, '').includes(':hover'));
  assert.deepEqual(
    lasting.map(({ name }) => name),
    [],
  );
});
