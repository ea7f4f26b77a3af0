// The example in MuJoCo: its controllers are what the page exports, and a robot with mass parks with those that are good.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { controllerFiles, folder } from '../../../.tasks/controllers.mjs';
import { python as examplesPython } from '../../../.tasks/examples.mjs';
import { ask, top } from '../../../.tasks/run.mjs';
import { links } from '../../../www/lesson/links.js';
import { createEngine, paper } from '../harness/core.js';
import { gainsOf } from '../../../www/run/drivers.js';
import { test } from '../harness/once.js';
import { controllerOf } from '../../../www/share/code/controller.js';
import { python as writePython } from '../../../www/share/code/python.js';
import { comments } from '../../../www/share/code/words/en.js';
import { inFolder, runners } from './programs.js';

const files = controllerFiles();
const anyPython = runners.python.program;
const python = [examplesPython, 'python3', 'python'].find(
  (program) => ask(program, ['-c', 'import mujoco']) !== null,
);

test("the example's controllers are those that the page exports", () => {
  for (const { file, text } of files)
    assert.equal(
      readFileSync(join(folder, file), 'utf8').replaceAll('\r', ''),
      text,
      `${file} is another: node .tasks/controllers.mjs writes it`,
    );
});

test("a controller's link opens its drive", () => {
  const engine = createEngine();
  for (const { link, gains, experiment } of files) {
    const { opened, problems } = links.openLink(link.split('#')[1], engine);
    assert.deepEqual(problems, []);
    assert.deepEqual(opened.experiment, experiment);
    if (opened.generation > 0) continue;
    const state = /** @type {import('../../../www/run/state.js').State} */ (
      /** @type {unknown} */ ({ ...opened, population: [] })
    );
    assert.deepEqual([...gainsOf(state, opened.driver, paper())], [...gains]);
  }
});

/** The example with these files and another mujoco. @param {string} cwd @param {string[]} given @param {string} [stub] */
function runExample(cwd, given, stub = '') {
  const run = `
import math, runpy, sys, types
mujoco = sys.modules["mujoco"] = types.ModuleType("mujoco")
${stub}
sys.argv = ${JSON.stringify(['park.py', ...given])}
runpy.run_path(${JSON.stringify(join(top, 'examples/mujoco/park.py'))}, run_name="__main__")`;
  return spawnSync(String(anyPython), ['-B', '-c', run], { cwd, encoding: 'utf8' });
}

/** What the example says of these files, before anything is simulated. @param {string} cwd @param {string[]} given */
function refusal(cwd, ...given) {
  const { stderr, status } = runExample(cwd, given);
  assert.equal(status, 1);
  return stderr.trim();
}

/** One in which every robot stands at the goal after a sample. */
const atOnce = `
def step(model, data, steps):
    data.qpos = [2, 2, 0.05, math.cos(math.pi / 8), 0, 0, math.sin(math.pi / 8)]
one = types.SimpleNamespace
mujoco.MjModel = one(from_xml_path=lambda path: one(opt=one(timestep=0.01)))
mujoco.MjData = lambda model: one(qpos=[0] * 7, actuator=lambda name: one())
mujoco.mj_forward = lambda model, data: None
mujoco.mj_step = step`;

test(
  'in the example a robot that has to be slow parks where it is near and slow',
  {
    skip: !anyPython && 'there is no Python',
  },
  () =>
    inFolder((cwd) => {
      const { drive, experiment } = createEngine();
      const about = { version: '1', link: '' };
      for (const [name, tolerance] of Object.entries({
        anyhow: {},
        slow: { speed: 0.1 },
        straight: { turnRate: 0.1 },
      })) {
        const controller = controllerOf(drive, experiment({ tolerance }), [3, 1, 4], about);
        writeFileSync(join(cwd, `${name}.py`), writePython({ ...controller, name }, comments));
      }
      const { stdout, stderr } = runExample(cwd, ['anyhow.py', 'slow.py', 'straight.py'], atOnce);
      const times = [...stdout.matchAll(/parks in (\S+) s \(/g)].map(([, time]) => time);
      assert.deepEqual(times, ['0.01', '0.02', '0.02'], stdout + stderr);
    }),
);

test('of a controller whose goal moves the example says that it never parks', {
  skip: !anyPython && 'there is no Python',
}, () => {
  const { drive, experiment } = createEngine();
  const from = experiment({ law: 'kanayama', referenceVelocity: { linear: 0.5, angular: 0 } });
  const moving = controllerOf(drive, from, [3, 1, 4], { version: '1', link: '' });
  return inFolder((cwd) => {
    writeFileSync(join(cwd, 'moving.py'), writePython({ ...moving, name: 'moving' }, comments));
    assert.equal(refusal(cwd, 'moving.py'), 'moving.py follows a goal that moves, and never parks.');
  });
});

test(
  'of a file that is no controller, or cannot be read, the example says so in a sentence',
  {
    skip: !anyPython && 'there is no Python',
  },
  () =>
    inFolder((cwd) => {
      assert.match(refusal(cwd, 'nope.py'), /^nope\.py cannot be read: .+\.$/);
      for (const [name, text] of [
        ['other.py', 'import math\n'],
        ['controller.c', 'int main(void)\n{\n}\n'],
        ['bytes.py', 'a = 1\0'],
        ['run.json', '{"a": null}\n'],
      ]) {
        writeFileSync(join(cwd, name), text);
        assert.equal(refusal(cwd, name), `${name} is not a controller that the page exported as Python.`);
      }
    }),
);

test('in MuJoCo the gains of the paper and of evolution park, 10, 10, 10 under acceleration limits do not', {
  skip: !python && 'there is no Python with mujoco',
}, () => {
  const paths = files.map(({ file }) => join(folder, file));
  const text = execFileSync(String(python), ['-B', join(top, 'examples/mujoco/park.py'), ...paths], {
    encoding: 'utf8',
  });
  const said = new Map(
    text
      .trim()
      .split('\n')
      .map((line) => /** @type {[string, string]} */ (line.trim().split(': '))),
  );
  for (const [name, least, most] of /** @type {const} */ ([
    ['paper', 1.9, 2.15],
    ['evolved', 1.91, 2.4],
    ['ten', 1.47, 2],
  ])) {
    const time = Number(/^parks in (\S+) s/.exec(said.get(name) ?? '')?.[1]);
    assert.ok(time >= least && time <= most, text);
  }
  assert.match(said.get('ten_accelerating') ?? '', /^does not park/);
});
