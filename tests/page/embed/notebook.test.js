// The widget for notebooks: built as a wheel, installed, and shown as anywidget would; what Python has in the end is what
// the page's own table has.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { areBuilt, python } from '../../../.tasks/examples.mjs';
import { pageTest } from '../harness/browsers.js';
import { experiment } from '../harness/core.js';
import { serveHost } from '../harness/host.js';
import { test } from '../harness/once.js';
import { saved } from '../harness/saved.js';
import { give, has, notebook, sentBy } from './notebook.js';

/** @typedef {{ traits: Record<string, any>, history: Record<string, number>[], error: string, refused: string }} Answer */

const guide = await readFile(new URL('../../../docs/python.md', import.meta.url), 'utf8');
const example = /```python\n(from ep_locomotion import EpLocomotion\n.*?)```/s.exec(guide)?.[1] ?? '';

/** Starts Python, in which `w` is a widget. */
function startKernel() {
  const child = spawn(python, [fileURLToPath(new URL('notebook.py', import.meta.url))], {
    stdio: ['pipe', 'pipe', 'inherit'],
  });
  const lines = createInterface(child.stdout)[Symbol.asyncIterator]();
  return {
    /** @param {string} code @param {object | null} [traits] from the browser, before the code runs @returns {Promise<Answer>} */
    async run(code, traits = null) {
      child.stdin.write(`${JSON.stringify({ code, traits })}\n`);
      const { value, done } = await lines.next();
      assert.ok(!done, 'Python has ended');
      return JSON.parse(value);
    },
    end: () => child.stdin.end(),
  };
}

/** The rows of numbers of a table. @param {string} text */
const rowsOf = (text) => {
  const [, ...rows] = text
    .trim()
    .split('\r\n')
    .filter((line) => !line.startsWith('#'));
  return rows.map((row) => row.split(',').map(Number));
};

test('what is misspelt or no gains is refused by Python at once', {
  skip: !areBuilt() && 'npm test builds the wheel where Python is',
}, async () => {
  const kernel = startKernel();
  try {
    const begun = await kernel.run(example);
    assert.equal(begun.refused, '');
    for (const [code, message] of /** @type {const} */ ([
      ['w.experiment = {"flavour": "red"}', /^ValueError: experiment must be .* one with 'flavour'$/],
      ['w.experiment = {"goal": {"x": 1e9}}', /^ValueError: goal\.x must be a number from -1000 to 1000 m/],
      ['EpLocomotion(experiment={"flavour": "red"})', /^ValueError: .*'flavour'/],
      ['EpLocomotion(experimant={})', /^AttributeError: a figure has no 'experimant'/],
      ['w.gain = [1, 2, 3]', /^AttributeError: a figure has no 'gain': it has link, experiment and gains$/],
      ['w.gains = [1, 2]', /^ValueError: gains must be three numbers/],
      ['w.gains = [[1, 2, 3]]', /^ValueError: gains must be three numbers/],
      ['w.gains = [1, float("nan"), 2]', /^ValueError: ky must be a finite number/],
      ['w.gains = ["1", 2, 3]', /^ValueError: kx must be a finite number/],
      ['w.step("a")', /^ValueError: generations must be a whole number from 1, but was 'a'$/],
      ['w.step(None)', /^ValueError: generations must be .*, but was None$/],
      ['w.step(1.5)', /^ValueError: generations must be .*, but was 1\.5$/],
      ['w.step(-5)', /^ValueError: generations must be .*, but was -5$/],
    ])) {
      const { refused, traits } = await kernel.run(code);
      assert.match(refused, message, code);
      assert.deepEqual(traits.experiment, begun.traits.experiment);
      assert.equal(traits.gains, null);
      assert.equal(traits._wanted, 30);
    }
    const driven = await kernel.run('w.gains = (1, 2, 3)');
    assert.equal(driven.refused, '');
    assert.deepEqual(driven.traits.gains, [1, 2, 3]);
  } finally {
    kernel.end();
  }
});

if (areBuilt())
  pageTest('the history of a widget is the table that the page saves, value by value', async (page) => {
    const kernel = startKernel();
    const host = await serveHost(notebook);
    try {
      const begun = kernel.run(example);
      await page.open('#lab&v=1&goal.x=3&goal.y=1&goal.theta=0&seed=7&generation=30');
      await page.click('#keep-button');
      const table = rowsOf(await saved(page, '#keep-generations'));

      await page.visit(host.address);
      await give(page, 'show', (await begun).traits);
      const { history, error } = await kernel.run('', await sentBy(page, has(30)));
      assert.equal(error, '');
      assert.deepEqual(
        history.map((one) => Object.values(one)),
        table,
      );
      assert.deepEqual(Object.keys(history[0]).slice(0, 6), [
        'generation',
        'drives',
        'best',
        'median',
        'worst',
        'kx',
      ]);

      // On from there, then anew, then what cannot be.
      const further = await kernel.run('w.step(); w.step(2)');
      await give(page, 'receive', further.traits);
      const more = await kernel.run('', await sentBy(page, has(33)));
      assert.deepEqual(more.history.slice(0, 31), history);

      const anew = await kernel.run('w.experiment = {"evolution": {"seed": 8}}; w.step(4)');
      assert.deepEqual(anew.history, []);
      await give(page, 'receive', anew.traits);
      const other = await kernel.run(
        '',
        await sentBy(page, `${has(4)} && sent.state.experiment.evolution.seed === 8`),
      );
      assert.deepEqual(
        other.history.map(({ drives }) => drives),
        [20, 40, 60, 80, 100],
      );

      // By hand, and back.
      const driven = await kernel.run('w.gains = (10, 10, 10)');
      await give(page, 'receive', driven.traits);
      const byHand = await sentBy(page, `${has(4)} && sent.state.drive.gains[0] === 10`);
      assert.deepEqual(byHand.state.drive.gains, [10, 10, 10]);
      assert.equal(byHand.state.hash, other.traits.state.hash);
      const back = await kernel.run('w.gains = None', byHand);
      await give(page, 'receive', back.traits);
      await sentBy(page, `${has(4)} && sent.state.drive.gains[0] === ${other.history[4].kx}`);

      // As from a Python that cannot compute, and so cannot refuse.
      await give(page, 'receive', { ...back.traits, experiment: { flavour: 'red' } });
      assert.match((await kernel.run('', await sentBy(page, 'sent.error'))).error, /flavour/);
      assert.match(await page.text('#cell > p'), /flavour/);
      const linked = await kernel.run(
        'w.experiment = {}; w.link = "curves&v=1&seed=9&goal.x=1000000"; w.step()',
      );
      await give(page, 'receive', linked.traits);
      const curves = await sentBy(page, `${has(1)} && /goal/.test(sent.error)`);
      assert.equal(curves.state.link, 'curves&v=1&seed=9&generation=1');

      assert.equal(
        await page.evaluate(() => {
          Reflect.get(window, 'leave')();
          return document.getElementById('cell')?.childElementCount;
        }),
        0,
      );
    } finally {
      kernel.end();
      await page.leave();
      await host.close();
    }
  });
else test('the widget for notebooks', { skip: 'npm test builds it where Python is' }, () => {});

if (areBuilt())
  pageTest(
    'a widget has the experiment of its link with some fields other, and any number of generations',
    async (page) => {
      const kernel = startKernel();
      const host = await serveHost(notebook);
      try {
        const link =
          'lab&v=1&preset=acceleration-limits&seed=9&population=4&opponents=2&horizon=1&sampleTime=0.1';
        const { traits } = await kernel.run(
          `${example.split('\n')[0]}\nw = EpLocomotion(link="${link}", experiment={"goal": {"x": 3}})\nw.step(6000); w.step(6000)`,
        );
        await page.visit(host.address);
        await give(page, 'show', traits);
        const text = await page.until('all generations are there', () => {
          const { state, _statistics: all } = Reflect.get(window, 'sent');
          return state?.generations === 12_000 && all.length === 12_001 && JSON.stringify(state.experiment);
        });
        assert.deepEqual(
          JSON.parse(text),
          experiment('acceleration-limits', {
            goal: { x: 3 },
            horizon: 1,
            sampleTime: 0.1,
            evolution: { seed: 9, population: 4, opponents: 2 },
          }),
        );
        assert.equal(await page.evaluate(() => document.querySelector('#cell > p')?.textContent), '');
      } finally {
        kernel.end();
        await page.leave();
        await host.close();
      }
    },
  );
