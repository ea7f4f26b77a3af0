// A robot that does not know where it is: the controller says so in every language, and does not drive off at full speed.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { controllerOf } from '../../../www/share/code/controller.js';
import { languages } from '../../../www/share/code/languages.js';
import { comments } from '../../../www/share/code/words/en.js';
import { experiment, simulateAll } from '../harness/core.js';
import { test } from '../harness/once.js';
import { inFolder, runners } from './programs.js';

/** @typedef {import('../../../www/share/code/languages.js').LanguageName} LanguageName */

/** @type {import('../../../www/share/code/controller.js').Drive} */
const drive = (from, gains) => simulateAll(from, gains.flat());
const about = { version: '0.1.0', link: 'https://host/ep/#lab&v=1' };
const experiments = [
  experiment('velocity-limits'),
  experiment('acceleration-limits'),
  experiment('acceleration-limits', { law: 'kanayama', referenceVelocity: { linear: 0.5, angular: 0.1 } }),
  experiment('velocity-limits', { law: 'kanayama' }),
];

/** A pose and the velocity before it. @typedef {readonly [x: number, y: number, theta: number, v: number, w: number]} Asked */
/** @type {readonly Asked[]} */
const lost = [
  [Number.NaN, 0, 0, 0, 0],
  [0, Number.NaN, 0, 0, 0],
  [0, 0, Number.NaN, 0, 0],
];
/** @type {Asked} */
const unmoved = [0, 0, 0, Number.NaN, Number.NaN];
/** @type {Asked} */
const known = [-1, 0.5, 0.3, 0.1, 0.2];

const inPython = (/** @type {readonly Asked[]} */ asked) => `
from math import nan
import controller
for x, y, theta, v, w in ${JSON.stringify(asked).replaceAll('null', 'nan')}:
    print(*controller.command((x, y, theta), controller.GOAL, (v, w)))
`;
const inC = (/** @type {readonly Asked[]} */ asked) => `
#define main own_main
#include "controller.c"
#undef main
int main(void)
{
    const double asked[][5] = {${asked.map((one) => `{${one.map((value) => (Number.isNaN(value) ? 'NAN' : value)).join()}}`).join()}};
    for (int i = 0; i < ${asked.length}; i++) {
        const Velocity q = command((Pose){asked[i][0], asked[i][1], asked[i][2]}, GOAL, (Velocity){asked[i][3], asked[i][4]});
        printf("%.17g %.17g\\n", (double)q.v, (double)q.w);
    }
}
`;
// The pose stands as a column, as a filter has it, and the goal as a row.
const inMatlab = (/** @type {readonly Asked[]} */ asked, /** @type {number[]} */ goal) => `
control = controller;
for asked = [${asked.map((one) => one.join(' ')).join('; ')}]'
  q = control(asked(1:3), [${goal.join(' ')}], asked(4:5));
  printf('%.17g %.17g\\n', q);
end
`;

/** @type {Record<LanguageName, (folder: string, asked: readonly Asked[], goal: number[]) => string | Promise<string>>} */
const ask = {
  python: (cwd, asked) =>
    execFileSync(String(runners.python.program), ['-B', '-c', inPython(asked)], { cwd, encoding: 'utf8' }),
  c: (cwd, asked) => {
    writeFileSync(join(cwd, 'ask.c'), inC(asked));
    execFileSync(String(runners.c.program), ['-O0', 'ask.c', '-o', 'ask', '-lm'], { cwd });
    return execFileSync(join(cwd, 'ask'), { encoding: 'utf8' });
  },
  matlab: (cwd, asked, goal) =>
    execFileSync(String(runners.matlab.program), ['--no-gui', '--norc', '--eval', inMatlab(asked, goal)], {
      cwd,
      encoding: 'utf8',
    }),
  javascript: async (folder, asked, [x, y, theta]) => {
    const { command } = await import(pathToFileURL(join(folder, 'controller.mjs')).href);
    return asked
      .map(([px, py, pt, v, w]) => command({ x: px, y: py, theta: pt }, { x, y, theta }, { v, w }))
      .map(({ v, w }) => `${v} ${w}`)
      .join('\n');
  },
};

for (const [language, commands] of Object.entries(ask)) {
  const { write, ending } = languages[/** @type {LanguageName} */ (language)];
  const options = {
    skip: !runners[/** @type {LanguageName} */ (language)].program && `there is no program for ${language}`,
  };
  test(
    `in ${language} a pose that is not a number commands no velocity, and a known one does`,
    options,
    async () => {
      for (const from of experiments) {
        const controller = { ...controllerOf(drive, from, [3, 1, 4], about), name: 'controller' };
        const asked = [known, ...lost, ...(from.limits.acceleration === null ? [] : [unmoved])];
        const { x, y, theta } = from.goal;
        const text = await inFolder((folder) => {
          writeFileSync(join(folder, `controller.${ending}`), write(controller, comments));
          return commands(folder, asked, [x, y, theta]);
        });
        const [first, ...more] = text
          .trim()
          .split('\n')
          .map((line) => line.split(' ').map((word) => Number(word.replace(/^[-+]?nan$/i, 'NaN'))));
        assert.ok(first.length === 2 && first.every(Number.isFinite), text);
        assert.deepEqual(more, Array(asked.length - 1).fill([Number.NaN, Number.NaN]), text);
      }
    },
  );
}
