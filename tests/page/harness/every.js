// Files of tests of the page in one process, so that a browser starts once for all of them: those that are named, or all.
import { readdirSync } from 'node:fs';
import { test } from 'node:test';

/** @type {() => void} */
let ready = () => {};
// The first tests could end before the last file is loaded, and what they have started would be ended with them.
test('every file of tests is loaded', () => new Promise((resolve) => (ready = () => resolve())));

const folder = new URL('..', import.meta.url);
const all = () =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.test.js'))
    .sort();
const named = process.argv.slice(2);
for (const name of named.length > 0 ? named : all()) await import(`../${name}`);
ready();
