// The program's checks of its own numbers: all pass, and each of them fails when what it checks is wrong.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { groupNames } from '../../../www/core/checks/check.js';
import { resultsOf } from '../../../www/core/checks/checks.js';
import { allResults } from '../../../www/core/checks/run.js';
import * as en from '../../../www/share/checks/words/en.js';
import * as ko from '../../../www/share/checks/words/ko.js';
import * as core from '../harness/core.js';
import { onceOnly, test } from '../harness/once.js';
import { sabotages } from './sabotages.js';

/** @typedef {import('../../../www/core/checks/check.js').Core} Core */
/** @typedef {import('../../../www/core/checks/check.js').Golden} Golden */
/** @typedef {import('../../../www/core/checks/check.js').Result} Result */
/** @typedef {import('../../../www/core/engine.js').Engine} Engine */

const goldenText = await readFile(new URL('../../golden.json', import.meta.url), 'utf8');
/** @type {Golden} */
const golden = JSON.parse(goldenText);

/** @param {Core} [from] @param {Golden} [known] */
const results = (from = core, known = golden) => groupNames.flatMap((group) => resultsOf(from, group, known));

/** The names of those that fail, each once. @param {Result[]} all */
const failing = (all) => [...new Set(all.filter(({ passed }) => !passed).map(({ name }) => name))];

/** The names of the checks of each group. */
const namesIn = onceOnly(async () =>
  groupNames.map((group) => ({
    group,
    names: resultsOf(core, group, golden).map(({ name }) => name),
  })),
);

test('every check passes in Node, and says in both languages what it is', () => {
  const all = results();
  assert.ok(all.length >= 20);
  assert.deepEqual(
    all.filter(({ passed }) => !passed),
    [],
  );
  const names = new Set([...all.map(({ name }) => name), 'worker']);
  for (const words of [en, ko]) {
    assert.deepEqual(Object.keys(words.sentences).sort(), [...names].sort());
    const sentences = all.map(({ name, about }) =>
      /** @type {(...about: any[]) => readonly string[]} */ (words.sentences[name])(...about),
    );
    assert.equal(new Set(sentences.map(([law]) => law)).size, all.length, 'no two say the same');
    for (const result of all) {
      const said = [words.expectedText(result), words.valuesText(result.found, result)];
      for (const text of [...said, ...sentences.flat()])
        assert.match(text, /^(?!.*(undefined|NaN|null|Infinity)).+$/);
    }
  }
});

test('every known value is looked at: if it were another, its check would fail, and no other', () => {
  const rows = golden.runs.rows.flatMap(({ end }, i) => [
    ['runs', 'rows', i, 'cost'],
    ['runs', 'rows', i, 'finalTime'],
    ...(end ?? []).map((_, j) => ['runs', 'rows', i, 'end', j]),
  ]);
  const { opponents, parent, gains, sigmas, noise } = golden.draws;
  const triples = Object.entries({ opponents, parent, gains, sigmas, noise });
  /** @type {(readonly [string, (string | number)[][]])[]} */
  const places = [
    [
      'command',
      golden.commands.rows.flatMap((_, i) => [0, 1].map((j) => ['commands', 'rows', i, 'command', j])),
    ],
    ['run', rows],
    [
      'draws',
      [['draws', 'common'], ...triples.flatMap(([name, all]) => all.map((_, i) => ['draws', name, i]))],
    ],
    ['hash', golden.evolutions.map((_, i) => ['evolutions', i, 'hash'])],
  ];
  // Each evolution is one more of the same: so short it is looked at as well.
  const short = {
    ...golden,
    evolutions: golden.evolutions.map((one) => {
      const evolution = new core.Evolution(core.experiment(one.preset, one.changes));
      evolution.step();
      return { ...one, generations: 1, hash: evolution.hash() };
    }),
  };
  for (const [name, paths] of places)
    for (const path of paths) {
      const changed = structuredClone(short);
      /** @type {any} */
      let holder = changed;
      for (const key of path.slice(0, -1)) holder = holder[key];
      const last = path[path.length - 1];
      const value = holder[last];
      holder[last] =
        typeof value === 'string'
          ? value.replace(/^./, (digit) => (digit === '0' ? '1' : '0'))
          : value * 1.00001 + 1e-9;
      const group = /** @type {const} */ ({ command: 'motion', run: 'cost', draws: 'bits', hash: 'bits' })[
        name
      ];
      assert.ok(group);
      const failed = resultsOf(core, group, changed).filter(({ passed }) => !passed);
      assert.deepEqual(
        failed.map((one) => one.name),
        [name],
        path.join('.'),
      );
    }
  for (const cost of /** @type {const} */ ([
    [7.0, 7.6],
    [7.75, 7.8],
  ])) {
    const changed = { ...short, optimum: { ...golden.optimum, cost } };
    assert.deepEqual(failing(results(core, changed)), ['optimum']);
  }
});

for (const [what, [broken, names]] of Object.entries(sabotages))
  test(`a core with a fault is found out: ${what}`, async () => {
    const groups = (await namesIn()).filter((one) => names.some((name) => one.names.includes(name)));
    const found = failing(groups.flatMap(({ group }) => resultsOf(broken, group, golden)));
    for (const name of names) assert.ok(found.includes(name), `${name} passes; these fail: ${found}`);
  });

test('there is a fault for every check', async () => {
  const found = new Set(Object.values(sabotages).flatMap(([, names]) => names));
  const all = (await namesIn()).flatMap(({ names }) => names);
  assert.deepEqual(
    all.filter((name) => !found.has(name)),
    [],
  );
});

test('what is no number passes nowhere', () => {
  const silent = { ...core, evaluate: () => new Float64Array(1).fill(Number.NaN) };
  const found = failing(results(silent));
  for (const name of /** @type {const} */ (['paperOrder', 'lanes', 'offspringCosts']))
    assert.ok(found.includes(name));
});

test('a worker that computes something else is found out', async () => {
  for (const [hash, passed] of /** @type {const} */ ([
    ['here', true],
    ['there', false],
  ])) {
    const surveys = { channel: () => ({}), checks: async () => [[], []], evolve: async () => ({ hash }) };
    const engine = { surveys, hashOf: () => 'here', experiment: core.experiment };
    const groups = await allResults(/** @type {Engine} */ (/** @type {unknown} */ (engine)), golden, {});
    assert.deepEqual(
      groups.flat().map((one) => [one.name, one.passed]),
      [['worker', passed]],
    );
  }
});
