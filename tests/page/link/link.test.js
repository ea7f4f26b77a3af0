import assert from 'node:assert/strict';
import { asksSomething, groupNames, noExercise, withWay } from '../../../www/run/exercise.js';
import { links } from '../../../www/lesson/links.js';
import { luckSlice } from '../../../www/parts/luck/state.js';
import { renamed, withPin } from '../../../www/run/pins.js';
import { preparedAs } from '../../../www/run/prepared.js';
import { finds, presets } from '../../../www/run/state.js';
import { drawnFor, nobody } from '../../../www/run/variant.js';
import { createEngine, experiment, fields, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';
import { samples } from '../parts/samples.js';
import { createChance } from '../share/any-drive.js';

/** @typedef {import('../../../www/run/exercise.js').Exercise} Exercise */
/** @typedef {import('../../../www/link/keys.js').Linked} Linked */

const velocityLimits = experiment('velocity-limits');
const engine = createEngine();
const { linkOf, openLink } = links;
const open = (/** @type {string} */ link) => openLink(link, engine);

/** A link's content as the page holds it. @param {ReturnType<typeof open>['opened']} opened @returns {Linked} */
const linked = ({ parts, ...run }) => ({ ...run, slices: parts });
const plain = linked(open('lab').opened);

const ways = /** @type {const} */ (['free', 'locked', 'hidden']);

/** A task in any letters, and each group of controls free, locked or hidden. @param {() => number} next @returns {Exercise} */
const wildExercise = (next) =>
  groupNames.reduce(
    (exercise, group) => withWay(exercise, group, ways[Math.floor(3 * next())]),
    next() < 0.2 ? noExercise : { ...noExercise, task: 'J < 8 & kθ = 0? 100 % “so”, 과제 #1; <b>🤖</b>~a=b' },
  );

test('what a preset has is not in the link', () => {
  assert.equal(linkOf(plain, experiment), 'lab');
  assert.equal(
    linkOf(
      { ...plain, preset: 'acceleration-limits', experiment: experiment('acceleration-limits') },
      experiment,
    ),
    'lab&v=1&preset=acceleration-limits',
  );
});

test('a link is short, and reads like what it says', () => {
  const goal = { x: 1.5, y: 2, theta: (30 * Math.PI) / 180 };
  const changed = { ...velocityLimits, goal, evolution: { ...velocityLimits.evolution, seed: 7 } };
  assert.equal(
    linkOf(
      { ...plain, page: 'landscape', experiment: changed, generation: 24, driver: 'paper-ep' },
      experiment,
    ),
    'landscape&v=1&goal.x=1.5&goal.theta=30deg&seed=7&generation=24&drives=paper-ep',
  );
});

test('every field of the core, number or word, is read as it is written', () => {
  const values = [
    ...fields().map(({ path, min, max, integer }) => {
      const value = min + (max - min) * 0.37;
      return { path: path.replace('[]', '.0'), value: integer ? Math.round(value) : value };
    }),
    ...wordFields().flatMap(({ path, words }) => words.map((value) => ({ path, value }))),
  ];
  assert.ok(values.length > 30);
  for (const { path, value } of values) {
    const changed = structuredClone(velocityLimits);
    const keys = path.split('.');
    const last = keys.pop() ?? '';
    /** @type {any} */ (keys.reduce((inner, key) => /** @type {any} */ (inner)[key], changed))[last] = value;
    // As long as it may be with a short sample time, and the other way round.
    const own = {
      ...changed,
      ...(path === 'horizon' && { sampleTime: 1 }),
      ...(path === 'sampleTime' && { horizon: 10 }),
    };
    const link = linkOf({ ...plain, experiment: own }, experiment);
    const { opened, problems } = open(link);
    assert.deepEqual(problems, [], link);
    assert.deepEqual(opened.experiment, own, link);
  }
});

const slices = Object.fromEntries(
  Object.entries(samples).flatMap(([name, { slice }]) => (slice ? [[name, slice]] : [])),
);

test('every key of a link is read as it is written', () => {
  const written = linkOf(
    {
      ...plain,
      page: 'disturbance',
      preset: 'acceleration-limits',
      experiment: drawnFor(experiment('acceleration-limits'), ['goal'], 's4711'),
      lesson: 3,
      generation: 4,
      driver: 'hand',
      handGains: [3, 0.5, 4],
      found: 'map',
      trial: {
        start: { x: 1, y: 0, theta: 0 },
        disturbance: { kind: 'slip', linear: 0.2, angular: 0.1, seed: 3 },
      },
      pins: [0, 1, 2, 3].map((slot) => ({
        slot,
        name: `pin ${slot}`,
        experiment: velocityLimits,
        gains: [1, 2, 3],
      })),
      exercise: {
        task: 'Park.',
        locked: ['run'],
        hidden: ['seed'],
        aim: { wanted: { kind: 'cost', below: 8.1 }, drives: 4000 },
        scale: { values: [9, 7.75], points: [0, 10] },
        vary: ['goal'],
      },
      student: {
        who: 's4711',
        base: {
          preset: 'acceleration-limits',
          experiment: experiment('acceleration-limits'),
          prepared: { driver: null, gains: null, generation: 12 },
        },
        handin: '',
        of: '',
        spent: 7,
      },
      slices,
    },
    experiment,
  );
  for (const { key } of links.keys.filter((row) => row.key !== 'park'))
    assert.ok(
      written.includes(`&${key}=`),
      `${key} is not written: it needs a value in tests/page/parts/samples/`,
    );
  const { opened, problems } = open(written);
  assert.deepEqual(problems, []);
  assert.equal(linkOf(linked(opened), experiment), written);
});

test('the name of a pin turns nothing around', () => {
  const { pins } = open('curves&v=1&pin1=A%E2%80%AEevil%01~10,10,10').opened;
  assert.equal(pins[0].name, 'Aevil ');
});

test('whatever pins are called, their link has their gains, and they are called so', () => {
  const driven = { experiment: velocityLimits, gains: /** @type {const} */ ([1, 2, 3]) };
  const two = withPin(withPin([], driven, 'a-b-c'), driven, 'a~b~c');
  for (const pins of [two, renamed(two, 0, 'd~e'), renamed(two, 0, 'a~b-c (2)')]) {
    assert.equal(new Set(pins.map(({ name }) => name)).size, 2);
    assert.deepEqual(open(linkOf({ ...plain, pins }, experiment)).opened.pins, pins);
  }
});

test('every angle may be in degrees', () => {
  const { opened, problems } = open('lab&v=1&goal.theta=90deg&start=0,0,45deg&tolerance.heading=180deg');
  assert.deepEqual(problems, []);
  const { goal, starts, tolerance } = opened.experiment;
  assert.deepEqual([goal.theta, starts[0].theta, tolerance.heading], [Math.PI / 2, Math.PI / 4, Math.PI]);
  // Written as ever: the digits of an exercise are those of its link.
  assert.match(linkOf(linked(opened), experiment), /&tolerance\.heading=3\.14159/);
});

test('a start that is tried stands in the links of the parts that try one', () => {
  const state = linked(open('robustness&from=2,0,0').opened);
  assert.equal(linkOf(state, experiment), 'robustness&v=1&from=2,0,0deg');
  assert.equal(linkOf({ ...state, page: 'curves' }, experiment), 'curves');
});

test('every experiment comes back from its link to the bit', () => {
  for (let seed = 1; seed <= 200; seed += 1) {
    const next = createChance(seed);
    const between = (/** @type {number} */ low, /** @type {number} */ high) => low + (high - low) * next();
    const maybe = (/** @type {number} */ value) => (next() < 0.3 ? null : value);
    const posture = () => ({ x: between(-9, 9), y: between(-9, 9), theta: between(-3, 3) });
    const wild = experiment({
      law: next() < 0.5 ? 'kanayama' : 'shim-kim',
      starts: Array.from({ length: 1 + Math.floor(3 * next()) }, posture),
      goal: posture(),
      referenceVelocity: { linear: between(-1, 1), angular: between(-1, 1) },
      horizon: between(1, 20),
      limits: {
        speed: maybe(between(0.1, 5)),
        turnRate: maybe(between(0.1, 5)),
        acceleration: maybe(between(0.1, 5)),
        turnAcceleration: maybe(between(0.1, 5)),
      },
      weights: { final: [between(0, 9), 1, 1], velocity: [1, between(0, 9)], penalty: between(0, 9e3) },
      disturbance: { kind: 'slip', linear: between(-0.1, 0.1), angular: -0, seed: Math.floor(1e9 * next()) },
      evolution: { population: 2 + Math.floor(50 * next()), initialRange: [between(-1, 0), between(0.1, 9)] },
    });
    const gains = /** @type {[number, number, number]} */ ([
      between(-1, 9),
      between(0, 1e-7),
      between(0, 1e7),
    ]);
    const preset = presets[next() < 0.5 ? 0 : 1];
    const exercise = wildExercise(next);
    const drive = /** @type {const} */ ({
      generation: Math.floor(1000 * next()),
      driver: 'hand',
      handGains: gains,
    });
    const prepared = preparedAs(drive, exercise);
    /** @type {Linked} */
    const state = {
      page: 'robustness',
      lesson: 0,
      preset,
      experiment: wild,
      ...drive,
      found: finds[Math.floor(4 * next())],
      trial: { start: posture(), disturbance: null },
      pins: [{ slot: 2, name: 'mine & others, 100 % = #1', experiment: wild, gains }],
      exercise,
      student: { ...nobody, base: asksSomething(exercise) ? { preset, experiment: wild, prepared } : null },
      slices: {
        ...plain.slices,
        ...slices,
        generation: { ...slices.generation, chosen: Math.floor(40 * next()) },
        landscape: { ...slices.landscape, third: between(-1, 1) },
      },
    };
    const link = linkOf(state, experiment);
    assert.match(link, /^[\w.,;=&%~-]+$/);
    const { opened, problems } = open(link);
    assert.deepEqual(problems, []);
    assert.deepEqual(opened.experiment, wild);
    assert.deepEqual(linked(opened), state);
    assert.equal(linkOf(linked(opened), experiment), link);
  }
});

test('what is wrong is named with what it must be, and the rest is used', () => {
  const rows = /** @type {const} */ ([
    ['nowhere', /“nowhere”.*lab, .*landscape/],
    ['lab&seed=-1', /seed.*evolution\.seed must be a whole number from 0 to 4294967295/],
    ['lab&goal.x=1e9', /goal\.x.*goal\.x must be .*, but was 1000000000\.$/],
    ['lab&goal.x=abc', /goal\.x.*must be a number.*“abc”/],
    ['lab&goal.x=NaN', /goal\.x.*must be a number/],
    ['lab&goal=1,2', /goal was left out.*no such setting/],
    ['lab&start=1,2', /start.*three values/],
    ['lab&limits.speed=fast', /limits\.speed.*must be a number/],
    ['lab&law=newton', /law.*'shim-kim'/],
    ['lab&v=2', /version 2.*version 1/],
    ['lab&generation=1.5', /generation.*whole number from 0 to/],
    ['lab&drives=nobody', /drives.*one of evolved, hand/],
    ['lab&drives=hand', /drives.*gains/],
    ['lab&gains=1,2', /gains.*three numbers/],
    ['lab&from=1e9,0,0', /from.*starts\[0\]\.x/],
    ['lab&under=wind,1,1,1', /under.*disturbance\.kind/],
    ['lab&x=kz', /x was left out.*one of kx, ky, ktheta/],
    ['lab&x=ky&y=ky', /y was left out.*another gain/],
    ['lab&pin1=mine', /pin1.*name~kx,ky,kθ/],
    ['lab&pin2=mine~1,2,3~goal.x:far', /pin2.*must be a number/],
    ['lab&phase=lunch', /phase.*one of parents/],
    ['lab&heading=18', /heading.*whole number from 0 to 17/],
    ['lab&__proto__=1', /__proto__.*no such setting/],
    ['lab&constructor.name=1', /constructor\.name.*no such setting/],
    ['lab&lock=gains,windows', /lock was used in part.*one of gains, drives, .*“windows”/],
    ['lab&hide=', /hide was left out.*one of gains/],
    ['lab&aim=J>8', /aim was left out.*J<number, parks:k\/n.*“J>8”/],
    ['lab&aim=J<-1', /aim was left out/],
    ['lab&aim=parks:33/32', /aim was left out.*n up to 1000/],
    ['lab&aim=unseen:1.5', /aim was left out.*up to 1/],
    ['lab&aim=J<8;drives<4000', /aim was left out.*drives<=number up to 1000000000/],
    ['lab&aim=J<8&points=9:0', /points was left out.*value:points/],
    ['lab&aim=J<8&points=9:0,9:1', /points was left out/],
    ['lab&aim=J<8&points=9:0,8:1001', /points was left out.*0 to 1000 points/],
    ['lab&points=9:0,8:10', /points was left out.*aim/],
    ['luck&contestants=de,random,wind', /contestants was left out.*one of cauchy, .*“wind”/],
    ['luck&contestants=de,random,fixed,cauchy', /contestants was used in part.*at most 3 names.*“de,random,/],
    ['lab&vary=goal,wind', /vary was used in part.*one of goal, starts, seed.*“wind”/],
    [`lab&who=${'x'.repeat(81)}`, /who was left out.*at most 80/],
    ['lab&hide=paper&drives=paper-ep', /drives was left out.*hidden/],
    ['lab&hide=paper&lesson=law', /lesson was left out.*paper’s gains/],
    [`lab&task=${'x'.repeat(301)}`, /task was left out.*at most 300 characters, but has 301/],
    ['lab&preset=none', /preset.*one of velocity-limits/],
    ['lab&%E0%A4%A=1', /no such setting/],
  ]);
  for (const [link, message] of rows) {
    const { opened, problems } = open(`${link}&evolution.initialSigma=0.5`);
    assert.equal(problems.length, 1, `${link}: ${problems}`);
    assert.match(problems[0], message);
    assert.equal(opened.experiment.evolution.initialSigma, 0.5, link);
  }
  assert.equal(open('lab&found=map').opened.found, 'hand');
  assert.match(open('lab&a=1&b=1&c=1&d=1&e=1&f=1').problems[5], /^One more/);
  const many = open('luck&contestants=de,random,fixed,cauchy').opened;
  assert.deepEqual(luckSlice.of({ slices: many.parts }).others, ['de', 'random', 'fixed']);
});
