// Files of tests of the page in one process, so that a browser starts once for all of them: those that are named, or all;
// or, where processes share them, one after the other as they are handed out.
import { once } from 'node:events';
import { readdirSync } from 'node:fs';
import { test } from 'node:test';

/**
 * A test, which nobody counts, that lasts until it is told to end: else the first tests could end before the last file is loaded,
 * and what they have started would be ended with them.
 * @returns {{ begun: Promise<void>, end: () => void }}
 */
function hold() {
  let end = () => {};
  /** @type {Promise<void>} */
  const begun = new Promise((begin) => {
    test('files of tests are loaded', () => {
      begin();
      return new Promise((resolve) => (end = () => resolve()));
    });
  });
  return { begun, end: () => end() };
}

const folder = new URL('..', import.meta.url);
const all = () =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.test.js'))
    .sort();

/** One file after the other, until there are none. */
async function* handedOut() {
  for (;;) {
    const answer = once(process, 'message');
    process.send?.('next');
    const [name] = await answer;
    if (name === '') break;
    yield [name];
  }
  process.disconnect();
}

const named = process.argv.slice(2);
let holding = hold();
await holding.begun;
for await (const names of process.send ? handedOut() : [named.length > 0 ? named : all()]) {
  for (const name of names)
    await import(`../${name}`).catch((error) => {
      test(`${name} is loaded`, () => {
        throw error;
      });
    });
  const following = hold();
  holding.end();
  holding = following;
  // Until their tests are done.
  await holding.begun;
}
holding.end();
