// What links carry of an exercise: when it is solved, what is drawn for each student, and who works on it.
import assert from 'node:assert/strict';
import fc from 'fast-check';
import { links } from '../../../www/lesson/links.js';
import { aimOf, aimText, scaleOf, scaleText } from '../../../www/link/exercise.js';
import { takeAlong, takeUp } from '../../../www/link/crossing.js';
import { withExercise } from '../../../www/link/link.js';
import { isSealed, sealOf } from '../../../www/link/seal.js';
import { judged } from '../../../www/run/aim.js';
import { firstMaker, mostOfTask } from '../../../www/run/exercise.js';
import { presets } from '../../../www/run/state.js';
import { drawnFor } from '../../../www/run/variant.js';
import { createEngine, experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { anyExperiment } from './arbitrary.js';

const engine = createEngine();
const { linkOf, openLink } = links;

/** @param {string} link @param {string} [who] */
const open = (link, who) => {
  const { opened, problems } = openLink(link, engine, who);
  assert.deepEqual(problems, [], link);
  return opened;
};

/** As the page holds it. @param {ReturnType<typeof open>} opened */
const linked = ({ parts, ...run }) => ({ ...run, slices: parts });

/** @param {string} link */
const again = (link) => linkOf(linked(open(link)), experiment);

test('an aim and its points are read as they are written', () => {
  for (const text of ['J<8.1', 'parks:28/32', 'unseen:1', 'J<7.75;drives<=4000', 'parks:1/1;drives<=1'])
    assert.equal(aimText(aimOf(text)), text);
  for (const text of ['9.016:0,7.75:10', '20:1,32:1000']) assert.equal(scaleText(scaleOf(text)), text);
  for (const text of [
    '',
    'J<',
    'J<0',
    'parks:0/3',
    'parks:1/1001',
    'unseen:0',
    'J<8;drives<=0',
    'J<8;',
    'J<8;drives<=1;',
  ])
    assert.throws(() => aimOf(text), /must be J<number/, text);
});

test('an answer meets its aim only within its budget; points lie on the line between two values', () => {
  const aim = aimOf('J<8;drives<=100');
  const scale = scaleOf('9:0,7.75:10');
  const of = (/** @type {number} */ value, drives = 100) => judged(aim, scale, { value, drives });
  assert.deepEqual(of(7.9), {
    isMet: true,
    points: 8.8,
    most: 10,
  });
  assert.equal(of(8).isMet, false);
  assert.deepEqual([of(7).points, of(9).points, of(10).points], [10, 0, 0]);
  assert.deepEqual(of(7, 101), { isMet: false, points: 0, most: 10 });
  assert.equal(judged(aim, scaleOf('9:2,7.75:10'), { value: 7, drives: 101 }).points, 2);
  for (const lost of [Number.POSITIVE_INFINITY, Number.NaN])
    assert.deepEqual([of(lost).isMet, of(lost).points], [false, 0]);
  const parks = (/** @type {number} */ value) =>
    judged(aimOf('parks:28/32'), null, { value, drives: 1 }).isMet;
  assert.deepEqual([27, 28, 32].map(parks), [false, true, true]);
});

test('points never fall as the answer gets better, and stay within their two values', () => {
  fc.assert(
    fc.property(
      fc.double({ min: 0.1, max: 1e6, noNaN: true }),
      fc.double({ min: 0.1, max: 1e6, noNaN: true }),
      (a, b) => {
        const points = (/** @type {number} */ value) =>
          Number(judged(aimOf('J<8'), scaleOf('9:0,7.75:10'), { value, drives: 1 }).points);
        const [better, worse] = [Math.min(a, b), Math.max(a, b)];
        assert.ok(points(better) >= points(worse) && points(worse) >= 0 && points(better) <= 10);
      },
    ),
  );
});

test('what is drawn follows from the number alone, as two people would write it', () => {
  const base = experiment('velocity-limits');
  const all = /** @type {const} */ (['goal', 'starts', 'seed']);
  const drawn = drawnFor(base, all, 'S4711');
  for (const same of ['s4711', ' S4711 ', 'ｓ4711']) assert.deepEqual(drawnFor(base, all, same), drawn);
  assert.equal(drawnFor(base, all, 's47\u206311').evolution.seed, 699630048);
  // The rule that the documents tell, worked out by hand once: whoever changes it breaks every course under way.
  assert.deepEqual(
    [drawn.goal, drawn.starts[0], drawn.evolution.seed],
    [
      { x: 2.17, y: 2.24, theta: base.goal.theta },
      { x: -0.11, y: 0.12, theta: (12 * Math.PI) / 180 },
      32343148,
    ],
  );
  const seeds = new Set();
  const goals = new Set();
  for (let i = 0; i < 400; i += 1) {
    const one = drawnFor(base, all, `s${4000 + i}`);
    seeds.add(one.evolution.seed);
    goals.add(JSON.stringify(one.goal));
    assert.ok(Math.abs(one.goal.x - base.goal.x) <= 0.2501 && Math.abs(one.goal.y - base.goal.y) <= 0.2501);
    assert.ok(Math.abs(one.starts[0].theta) <= (15.01 * Math.PI) / 180);
    assert.deepEqual({ ...one, goal: base.goal, starts: base.starts, evolution: base.evolution }, base);
    engine.experiment(one);
  }
  assert.equal(seeds.size, 400);
  assert.ok(goals.size > 330, `only ${goals.size} goals among 400 students`);
  assert.deepEqual(drawnFor(base, [], 's4711'), base);
});

test('a variant is the exercise as it was given, with who works on it; once it is left the link says what leads back', () => {
  const link = 'lab&v=1&goal.x=1.5&task=Park&vary=goal,seed&who=s4711';
  const opened = open(link);
  assert.notDeepEqual(opened.experiment.goal.x, 1.5);
  assert.equal(again(link), link);
  // Nobody yet: nothing is drawn.
  const blank = 'lab&v=1&goal.x=1.5&task=Park&vary=goal,seed';
  assert.equal(open(blank).experiment.goal.x, 1.5);
  assert.deepEqual(open(blank, 's4711'), opened);
  const moved = { ...opened.experiment, goal: { x: 1, y: 1, theta: 0 } };
  const changed = linkOf({ ...linked(opened), experiment: moved }, experiment);
  assert.match(
    changed,
    /goal\.x=1&goal\.y=1&.*&vary=goal,seed&who=s4711&given=velocity-limits~goal\.x%3A1\.5$/,
  );
  assert.deepEqual(open(changed), { ...opened, experiment: moved });
  // Who begins only then begins what was given.
  assert.deepEqual(open(changed.replace('&who=s4711', '')).student.base, opened.student.base);
});

test('whatever is changed in an exercise, its link has the run, and the exercise as it was given', () => {
  const given = open('lab&v=1&preset=acceleration-limits&weights.penalty=7&lock=seed&task=Park.&aim=J%3C9');
  const { base } = given.student;
  const prepared = { driver: null, gains: null, generation: null };
  assert.deepEqual(base, { preset: 'acceleration-limits', experiment: given.experiment, prepared });
  fc.assert(
    fc.property(anyExperiment, fc.constantFrom(...presets), (any, preset) => {
      const run = { ...linked(given), preset, experiment: experiment(any) };
      const link = linkOf(run, experiment);
      const back = open(link);
      assert.deepEqual(
        [back.experiment, back.preset, back.student.base],
        [run.experiment, preset, base],
        link,
      );
      assert.equal(again(link), link);
    }),
    { numRuns: 200 },
  );
  // What is back is the exercise.
  assert.equal(linkOf(linked(given), experiment).includes('given'), false);
  // A seed that is free to choose leaves nothing.
  const free = open('lab&v=1&task=Park.&aim=J%3C9');
  const seeded = experiment({ evolution: { seed: 7 } });
  assert.equal(
    linkOf({ ...linked(free), experiment: seeded }, experiment),
    'lab&v=1&seed=7&task=Park.&aim=J%3C9',
  );
  const locked = open('lab&v=1&lock=seed&task=Park.&aim=J%3C9');
  assert.match(linkOf({ ...linked(locked), experiment: seeded }, experiment), /&given=velocity-limits$/);
  // Where nothing is asked there is nothing to lead back to.
  assert.equal(open('lab&v=1&lock=gains&given=velocity-limits~goal.x:1').student.base, null);
  const { problems } = openLink('lab&task=Park.&given=velocity~goal.x:1', engine);
  assert.match(problems.join(' '), /given.*velocity-limits/);
  assert.match(openLink('lab&task=Park.&given=velocity-limits~goal.x:no', engine).problems[0], /given/);
});

test('a step of the lesson that is opened within an exercise stands as it says, whatever is drawn for a student', () => {
  const exercise = 'lab&v=1&lock=gains&task=Park&vary=goal,starts,seed&who=s4711';
  const { exercise: own, student } = open(exercise);
  for (const step of [links.linkOfStep(1), links.linkOfStep(2), links.linkOfStep(7)]) {
    const within = open(withExercise(step, { exercise: own, student }, experiment));
    assert.deepEqual(within.experiment, open(step).experiment, step);
    // Of the exercise all is there, and the way back to it.
    assert.deepEqual([within.exercise, within.student], [own, student]);
    // And so it is when its own link is opened again.
    assert.deepEqual(open(linkOf(linked(within), experiment)).experiment, within.experiment, step);
    // An exercise that is a step itself is drawn.
    const given = open(`${step}&task=Park&vary=goal,starts,seed&who=s4711`);
    assert.deepEqual(given.experiment, drawnFor(open(step).experiment, own.vary, 's4711'), step);
  }
});

test('who drives in an exercise, and which generation, is known again where a step of the lesson has others', () => {
  const byHand = '&drives=hand&gains=3,1,4';
  for (const [exercise, told] of [
    [`lab&v=1${byHand}&lock=gains,drives&task=Park.`, '~drives%3Ahand~gains%3A3,1,4'],
    [`lab&v=1${byHand}&lock=gains&task=Park.`, '~drives%3Ahand~gains%3A3,1,4'],
    ['lab&v=1&drives=paper-ep&lock=drives&task=Park.', '~drives%3Apaper-ep'],
    ['lab&v=1&generation=12&lock=gains,drives,run&task=Park.', '~drives%3Aevolved~generation%3A12'],
    // Nothing of it is locked.
    [`lab&v=1&generation=12${byHand}&task=Park.`, ''],
  ]) {
    const given = open(exercise);
    for (const step of [2, 3, 7].map(links.linkOfStep)) {
      const within = open(withExercise(step, given, experiment));
      assert.deepEqual(within.student.base, given.student.base, exercise);
      const link = linkOf(linked(within), experiment);
      assert.ok(link.endsWith(`&given=velocity-limits${told}`) === link.includes('&given='), link);
      assert.deepEqual(open(link).student.base, given.student.base, link);
      // The same experiment, driven by others, is none that was given.
      const lesser = { ...linked(within), preset: given.preset, experiment: given.experiment };
      if (told.includes('hand')) assert.match(linkOf(lesser, experiment), /&given=/, link);
    }
    assert.equal(linkOf(linked(given), experiment), exercise);
  }
  // Older links say nothing of it.
  const older = open('lab&v=1&seed=3&lock=gains,drives,seed&task=Park.&given=velocity-limits');
  assert.deepEqual(older.student.base?.prepared, { driver: null, gains: null, generation: null });
  for (const wrong of ['drives:nobody', 'gains:1,2', 'gains:1e999,0,1', 'generation:-1'])
    assert.match(openLink(`lab&task=Park.&given=velocity-limits~${wrong}`, engine).problems.join(), /given/);
});

test('a link out of HTML, and one to whose end a learning platform adds its variables', () => {
  const link = 'lab&v=1&seed=7&task=Park.';
  assert.deepEqual(open(link.replaceAll('&', '&amp;')), open(link));
  for (const end of ['?who=77', '&who=77']) assert.deepEqual(open(link + end), open(`${link}&who=77`));
  assert.equal(open(`${link}?who=77`).exercise.task, 'Park.');
  assert.equal(open('lab&task=Why%3Fwho=1').exercise.task, 'Why?who=1');
});

test('a step of the lesson alone keeps what a learning platform adds to it', () => {
  const step = links.linkOfStep(3);
  for (const [link, same] of [
    ['lesson', links.linkOfStep(1)],
    ['lesson&step=3', step],
    ['lesson&v=1&step=3&lang=ko', step],
    ['lesson&lang=en&step=law', step],
    ['lesson&step=3&who=77', `${step}&who=77`],
    ['lesson&who=77&step=3', `${step}&who=77`],
    ['lesson?who=77', `${links.linkOfStep(1)}&who=77`],
    ['lesson&step=3?who=77', `${step}&who=77`],
    ['lesson&amp;step=3&amp;seed=7', `${step}&seed=7`],
  ])
    assert.deepEqual(open(link), open(same), link);
  const { opened, problems } = links.openLink('lesson&step=3?forceview=1', engine);
  assert.deepEqual(opened, open(step));
  assert.match(problems.join(' '), /forceview.*left out/);
});

test('digits hold for the link alone, however it was written on its way', () => {
  const link = 'lab&v=1&seed=7&drives=hand&gains=3.5,0,4&task=Park%2C%20please.';
  const sealed = `1~8.5~${sealOf(link, '1~8.5')}`;
  for (const same of [link.replaceAll(',', '%2C'), `${link}&lang=ko`, link.replace('&v=1', '')])
    assert.ok(isSealed(same, sealed), same);
  for (const other of [link.replace('3.5', '3.4'), link.slice(0, -1), link.replace('lab', 'curves')])
    assert.ok(!isSealed(other, sealed), other);
  assert.ok(!isSealed(link, sealed.replace('8.5', '8.4')) && !isSealed(link, '') && !isSealed(link, '~'));
  // It goes on in the link as long as the run is that one.
  const whole = `${link}&handin=${sealed}`;
  assert.equal(again(whole), `${again(link)}&handin=${sealed}`);
  // What was cut or changed is told to whoever loads it again too.
  const cut = whole.slice(0, -3);
  assert.equal(again(cut), `${again(link)}&handin=${sealed.slice(0, -3)}`);
  const changed = (/** @type {string} */ text) => text.replace('3.5', '3.4');
  assert.equal(again(changed(whole)), `${again(changed(link))}&handin=${sealed}`);
});

test('who works here and what was driven before stand only beside what asks for them', () => {
  assert.equal(again('lab&who=s4711'), 'lab');
  for (const nothing of ['%E3%85%A4%E2%80%8B', '%20%E2%81%A3']) {
    assert.equal(open(`lab&aim=J<8&who=${nothing}`).student.who, '');
    assert.equal(open('lab&aim=J<8', decodeURIComponent(nothing)).student.who, '');
  }
  // What was drawn for it stays.
  assert.equal(open('lab&aim=J<8&who=s47%E2%81%A311').student.who, 's47\u206311');
  assert.equal(open('lab&aim=J<8;drives<=9&spent=7').student.spent, 7);
  assert.equal(open('lab&aim=J<8&spent=7').student.spent, 0);
});

test('a task may be as long as its field lets it be', () => {
  const task = 'x'.repeat(mostOfTask);
  assert.equal(open(`lab&task=${task}`).exercise.task, task);
});

test('of what was evolved in an exercise another language makes again what its link says', (t) => {
  const history = {
    state: /** @type {unknown} */ (null),
    replaceState: (/** @type {unknown} */ to) => (history.state = to),
  };
  Object.assign(globalThis, { history });
  t.after(() => Reflect.deleteProperty(globalThis, 'history'));
  const state = { evolving: true, catchingUp: { newest: 9 }, history: [], maker: firstMaker };
  for (const [aim, newest] of /** @type {const} */ ([
    ['', 9],
    ['&aim=J<8', 3],
  ])) {
    takeAlong(/** @type {any} */ (state), []);
    const taken = takeUp(open(`lab&generation=3${aim}`));
    // What catches up goes on by itself.
    assert.deepEqual([taken.newest, taken.evolving], [newest, false]);
  }
});
