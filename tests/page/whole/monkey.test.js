// Whatever somebody presses without a thought: nothing is thrown, the page goes on, and no number is none.
//
//   npm run monkey -- [rounds] [first seed]   so many rounds in each engine; what fails is told with its seed
import assert from 'node:assert/strict';
import { engineTest } from '../harness/browsers.js';
import { links as corpus } from '../link/fuzz.js';
import { monkey } from './monkey.js';

const [rounds, first] = [Number(process.env.MONKEY_ROUNDS ?? 1), Number(process.env.MONKEY_SEED ?? 1)];
const actions = 100;
/** Another language loads the page again. */
const links = corpus.filter((link) => !link.includes('lang'));

for (let seed = first; seed < first + rounds; seed++)
  engineTest(
    `a hundred thoughtless actions, seed ${seed}`,
    async (page) => {
      await page.open(seed % 2 === 1 ? '' : '#lab');
      /** Without waiting for what is drawn: it waits for nothing. @param {string} script @param {unknown[]} args @returns {Promise<any>} */
      const run = (script, ...args) => page.driver.executeScript(`return ${script}`, ...args);
      /** @type {string[]} */
      const done = [];
      for (let part = 0; part < 10; part++) {
        done.push(...(await run(`(${monkey})(...arguments)`, 1000 * seed + part, actions / 10, links)));
        assert.deepEqual(await run('window.collectedProblems'), [], `after\n${done.join('\n')}`);
      }
      // A task may say whatever somebody has typed, and a program, which may still come, has its own words: at once.
      const { text, works } = await run(`(() => {
        document.querySelectorAll('#task, #code-text').forEach((one) => one.replaceChildren());
        return {
          text: document.body.innerText,
          works: !document.getElementById('instead')?.checkVisibility(),
        };
      })()`);
      assert.ok(works, `the page has given up after\n${done.join('\n')}`);
      // What somebody has typed is told in quotes.
      const [nonsense] = /.*(?:(?<!“)\bNaN\b|undefined|\[object).*/.exec(text) ?? [];
      assert.equal(nonsense, undefined, `“${nonsense}” stands there after\n${done.join('\n')}`);
      await page.open('#lab');
      assert.equal(await page.text('#generation'), '0');
    },
    { moves: true },
  );
