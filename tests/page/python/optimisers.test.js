// The examples for DEAP, pycma and pymoo run, and what they found is what the core says of it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { areBuilt, python } from '../../../.tasks/examples.mjs';
import { ask, top } from '../../../.tasks/run.mjs';
import { evaluate, simulate } from '../harness/core.js';
import { test } from '../harness/once.js';

const goal = { goal: { x: 3, y: 1, theta: 0 } };

/** What a few generations print: a number after each name, and the gains. @param {string} file @param {number} generations */
function found(file, generations) {
  const program = join(top, 'examples', 'optimisers', file);
  const text = execFileSync(python, ['-B', program, String(generations)], { encoding: 'utf8' });
  return text
    .trimEnd()
    .split('\n')
    .map((line) => {
      const words = line.split(' ');
      const at = words.indexOf('gains');
      return { numbers: words.slice(0, at).map(Number), gains: words.slice(at + 1).map(Number) };
    });
}

/** @param {string} name @param {string} library */
const options = (name, library) => ({
  skip:
    !(
      areBuilt() &&
      ask(python, ['-c', `assert __import__('importlib.util').util.find_spec('${library}')`]) !== null
    ) && `there is no Python with ${name}`,
});

for (const [name, library] of [
  ['DEAP', 'deap'],
  ['pycma', 'cma'],
])
  test(
    `${name} finds gains better than 10, 10, 10, with the J that the core has for them`,
    options(name, library),
    () => {
      const [{ numbers, gains }, ...more] = found(`with_${name.toLowerCase()}.py`, 8);
      assert.deepEqual(more, []);
      const [cost, byHand] = evaluate(goal, [...gains, 10, 10, 10]);
      assert.equal(numbers[1], cost);
      assert.ok(cost < byHand, `${cost} ${byHand}`);
    },
  );

test(
  'pymoo finds robots of which none is both sooner there and cheaper than another',
  options('pymoo', 'pymoo'),
  () => {
    const front = found('with_pymoo.py', 8);
    assert.ok(front.length > 2);
    for (const { numbers, gains } of front) {
      const run = simulate(goal, gains);
      assert.ok(run.arrived);
      assert.deepEqual([numbers[1], numbers[3]], [run.finalTime, run.cost.energy]);
    }
    front.slice(1).forEach(({ numbers: [, time, , energy] }, i) => {
      const [, before, , dearer] = front[i].numbers;
      assert.ok(time > before && energy < dearer, `${time} ${before} ${energy} ${dearer}`);
    });
  },
);

test('the problem of each example takes few lines', () => {
  const lines = (/** @type {string} */ file) => {
    const text = readFileSync(join(top, 'examples', 'optimisers', file), 'utf8');
    const problem = /# The problem\.\n(.*?)\n\n(?! )/s.exec(text)?.[1] ?? '';
    return problem.split('\n').filter((line) => line.trim() !== '').length;
  };
  assert.deepEqual(['with_deap.py', 'with_pycma.py', 'with_pymoo.py'].map(lines), [5, 4, 5]);
});
