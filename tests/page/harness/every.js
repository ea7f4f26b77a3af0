// Every test of the page in one process, so that a browser starts once for all of them.
import { readdirSync } from 'node:fs';
import { test } from 'node:test';

/** @type {() => void} */
let ready = () => {};
// The first tests could end before the last file is loaded, and what they have started would be ended with them.
test('every file of tests is loaded', () => new Promise((resolve) => (ready = () => resolve())));

const files = readdirSync(new URL('..', import.meta.url), { recursive: true, encoding: 'utf8' }).filter(
  (name) => name.endsWith('.test.js'),
);
for (const name of files.sort()) await import(`../${name}`);
ready();
