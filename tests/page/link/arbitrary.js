// What links and experiments hold that nobody would write.
import fc from 'fast-check';
import { groupNames } from '../../../www/run/exercise.js';
import { links } from '../../../www/lesson/links.js';
import { finds, presets } from '../../../www/run/state.js';
import { pageNames } from '../../../www/parts/parts.js';
import { experiment, fields, wordFields } from '../harness/core.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {Experiment['evolution']} Evolution */
/** The settings of evolution that are words. @typedef {{ [Name in keyof Evolution]: Evolution[Name] extends string ? Name : never }[keyof Evolution]} Word */

const numbers = fc.oneof(
  fc.double().map(String),
  fc.double({ min: -20, max: 20 }).map((value) => value.toFixed(2)),
  fc.integer({ min: -2, max: 40 }).map(String),
  fc.constantFrom(
    'NaN',
    '-Infinity',
    '-0',
    '1e308',
    '5e-324',
    '1e-5',
    '0x10',
    '1e5',
    '−1',
    '1,5',
    ' 7 ',
    '',
    'off',
    '4294967295',
  ),
);
const angles = fc.oneof(
  numbers,
  numbers.map((text) => `${text}deg`),
);
const lists = (/** @type {number} */ most) =>
  fc.array(numbers, { maxLength: most }).map((all) => all.join(','));
const postures = fc.tuple(numbers, numbers, angles).map((all) => all.join(','));
const words = fc.constantFrom(
  ...[
    ...wordFields().flatMap(({ words: all }) => all),
    'velocity-limits',
    'acceleration-limits',
    'hand',
    'paper-ep',
  ],
  ...[
    'evolved',
    'kx',
    'ky-log',
    'ktheta',
    'cost',
    'time',
    'share',
    'sigmas',
    'log',
    'en',
    'ko',
    '1',
    '__proto__',
  ],
);
const names = fc
  .oneof(
    fc.string({ maxLength: 9 }),
    fc.integer({ min: 76, max: 80 }).map((length) => `${'n'.repeat(length)}😀`),
  )
  .map(encodeURIComponent);

/** @param {string} path */
const wordOf = (path) =>
  fc.constantFrom(...wordFields().flatMap((field) => (field.path === path ? field.words : [])));
/** The fields of an object of the experiment that are words. @param {string} object */
const wordsIn = (object) =>
  Object.fromEntries(
    wordFields()
      .map(({ path }) => path)
      .filter((path) => path.startsWith(`${object}.`))
      .map((path) => [path.slice(object.length + 1), wordOf(path)]),
  );
/** The paths of an experiment's fields, as links have them. */
const paths = [...new Set([...fields(), ...wordFields()].map(({ path }) => path.replace(/\[\].*/, '')))];
const keys = fc.constantFrom(
  ...paths,
  ...links.keys.map(({ key }) => key),
  'given',
  ...['start', 'seed', 'population', 'opponents', 'v', 'lang', 'step', 'pin5', 'limits', 'starts[0].x', ''],
  ...[
    '__proto__',
    'constructor.prototype',
    'goal.__proto__',
    'toString',
    'limits.speed.x',
    'weights.final.length',
  ],
);
const values = fc.oneof(
  { weight: 4, arbitrary: numbers },
  { weight: 2, arbitrary: words },
  { weight: 1, arbitrary: angles },
  { weight: 1, arbitrary: lists(4) },
  { weight: 1, arbitrary: fc.array(postures, { minLength: 1, maxLength: 3 }).map((all) => all.join(';')) },
  { weight: 1, arbitrary: fc.tuple(words, lists(3)).map((all) => all.join(',')) },
);
const change = fc.tuple(keys, values).map(([key, value]) => `${key}:${value}`);
const pin = fc
  .tuple(names, lists(3), fc.array(change, { maxLength: 4 }))
  .map(([name, gains, changes]) => [name, gains, ...changes].join('~'));
const pair = fc.tuple(keys, fc.oneof({ weight: 9, arbitrary: values }, { weight: 1, arbitrary: pin }));
/** Pairs that have the right form more often than chance would have it. */
const rightPair = fc.oneof(
  fc.tuple(fc.constantFrom(...paths), numbers),
  fc.tuple(fc.constantFrom('gains', 'weights.final'), fc.tuple(numbers, numbers, numbers).map(String)),
  fc.tuple(fc.constantFrom('start', 'from'), postures),
  fc.tuple(fc.constantFrom('pin1', 'pin2', 'pin3', 'pin4'), pin),
  fc.tuple(fc.constant('under'), fc.tuple(wordOf('disturbance.kind'), numbers, numbers, numbers).map(String)),
  fc.tuple(
    fc.constantFrom('lock', 'hide'),
    fc.array(fc.constantFrom(...groupNames, 'all'), { maxLength: 4 }).map(String),
  ),
  fc.tuple(fc.constant('task'), names),
  fc
    .tuple(fc.constantFrom(...presets), fc.array(change, { maxLength: 3 }))
    .map(([name, changes]) => ['given', [name, ...changes].join('~')]),
  fc.tuple(fc.constant('found'), fc.constantFrom(...finds)),
);
export const linkText = fc
  .tuple(
    fc.constantFrom(...pageNames, 'lesson', '', 'nowhere'),
    fc.array(fc.oneof(pair, rightPair), { maxLength: 4 }),
  )
  .map(([page, pairs]) => [page, ...pairs.map((parts) => parts.join('='))].join('&'));

/** What a text is made longer with. */
const pieces = fc.oneof(
  fc.constantFrom(
    '&',
    '=',
    '~',
    ':',
    ';',
    ',',
    '%',
    '%E0%A4',
    '%00',
    '%F0%9F%98%80',
    '#',
    '.',
    'deg',
    '\u0000',
    '\ud800',
    '😀',
  ),
  fc.constantFrom(
    '"',
    '{',
    '[',
    ']',
    '}',
    'null',
    '1e999',
    '\\u0000',
    '"__proto__":',
    '&__proto__=',
    '&v=1',
    '&start=0,0,0',
  ),
  keys.map((key) => `&${key}=`),
  fc.string({ maxLength: 5 }),
);
/** A place in the text, how much is cut there, what is put there instead, and how often. */
const mutation = fc.record({
  at: fc.double({ min: 0, max: 1, noNaN: true }),
  cut: fc.oneof(fc.nat(3), fc.nat(200)),
  piece: pieces,
  times: fc.oneof(
    { weight: 400, arbitrary: fc.constantFrom(0, 1, 1) },
    { weight: 1, arbitrary: fc.nat(6000) },
  ),
});
/** @param {fc.Arbitrary<string>} texts */
export const mutated = (texts) =>
  fc.tuple(texts, fc.array(mutation, { maxLength: 4 })).map(([text, mutations]) =>
    mutations.reduce((before, { at, cut, piece, times }) => {
      const place = Math.floor(at * before.length);
      return before.slice(0, place) + piece.repeat(times) + before.slice(place + cut);
    }, text),
  );

/** @param {number} low @param {number} high */
const from = (low, high) => fc.double({ min: low, max: high, noNaN: true });
const aPosture = fc.record({ x: from(-1000, 1000), y: from(-1000, 1000), theta: from(-100, 100) });
const aWeight = from(0, 1e6);
const aLimit = fc.option(from(0, 1e6));
const aSeed = fc.nat({ max: 2 ** 32 - 1 });
/** Any experiment that the core allows, from the smallest numbers to the largest. */
export const anyExperiment = fc
  .record(
    /** @satisfies {Record<keyof Experiment, unknown>} */ ({
      law: wordOf('law'),
      starts: fc.array(aPosture, { minLength: 1, maxLength: 5 }),
      goal: aPosture,
      referenceVelocity: fc.record({ linear: from(-100, 100), angular: from(-100, 100) }),
      sampleTime: fc.oneof(from(1e-5, 10), fc.constant(1e-5)),
      horizon: fc.oneof(from(1e-5, 10), from(10, 1e5)),
      limits: fc.record({ speed: aLimit, turnRate: aLimit, acceleration: aLimit, turnAcceleration: aLimit }),
      tolerance: fc.record({
        position: from(0, 1000),
        heading: from(0, 100),
        speed: aLimit,
        turnRate: aLimit,
      }),
      weights: fc.record({
        final: fc.tuple(aWeight, aWeight, aWeight),
        velocity: fc.tuple(aWeight, aWeight),
        penalty: aWeight,
      }),
      disturbance: fc.record({
        kind: wordOf('disturbance.kind'),
        linear: from(-100, 100),
        angular: from(-100, 100),
        seed: aSeed,
      }),
      evolution: fc.record({
        ...wordsIn('evolution'),
        .../** @satisfies {Record<Exclude<keyof Evolution, Word>, unknown>} */ ({
          population: fc.integer({ min: 1, max: 2000 }),
          opponents: fc.integer({ min: 1, max: 1000 }),
          seed: aSeed,
          initialRange: fc.tuple(from(-1e6, 0), from(1e-9, 1e6)),
          initialSigma: aWeight,
          adaptation: from(0, 10),
          sigmaFloor: aWeight,
          crossover: from(0, 1),
        }),
      }),
    }),
    { requiredKeys: [] },
  )
  .map((partial) => {
    try {
      return experiment(/** @type {any} */ (partial));
    } catch {
      return experiment('acceleration-limits');
    }
  });
