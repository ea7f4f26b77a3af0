// What a link carries beside the experiment: one row a key, which says how it is written and how it is read.
/** @import { Engine, Experiment } from '../core/engine.js' */
/** @import { Places } from '../run/actions/basis.js' */
/** @import { Opened } from '../run/actions/page.js' */
/** @import { Pin } from '../run/pins.js' */
/** @import { State } from '../run/state.js' */
/** @import { Slice } from '../run/store.js' */
import { plainText } from '../kit/text.js';
import { lastGeneration } from '../run/pace.js';
import { styles } from '../run/pins.js';
import { drivers, finds } from '../run/state.js';
import { link as words } from '../words/index.js';
import { changesText, withChanges } from './experiment.js';
import { PartlyRead } from './together.js';
import {
  disturbanceOf,
  disturbanceText,
  numberText,
  oneOf,
  posture,
  postureText,
  triple,
  wholeNumber,
} from './values.js';

/** All that a link is written from; `work` null: nothing has been done yet. @typedef {Omit<Opened, 'parts'> & Pick<State, 'slices'> & { work?: State['work'] | null, history?: State['history'] }} Linked */
/** A row: null is left out of links. A value that is refused throws an Error that says what it must be. @typedef {{ key: string, text: (state: Linked, usual: Experiment) => string | null, read: (opened: Opened, text: string, engine: Engine) => Opened }} Key */
/** A row of something that a part of the page shows; with `stays` a link that says nothing of it leaves it as it is. @typedef {Key & { slice: Slice<any>, field: string, stays?: boolean }} PartKey */

/**
 * @template {object} S @template {keyof S & string} F
 * @param {string} key @param {Slice<S>} slice @param {F} field @param {(text: string) => S[F]} read @param {(value: NonNullable<S[F]>) => string} [text]
 * @returns {PartKey}
 */
export function partKey(key, slice, field, read, text = String) {
  const textOf = (/** @type {S} */ state) => {
    const value = state[field];
    return value === null || value === undefined ? null : text(value);
  };
  return {
    key,
    slice,
    field,
    text(state) {
      const own = textOf(slice.of(state));
      return own === textOf(slice.first) ? null : own;
    },
    read(opened, text) {
      const having = (/** @type {unknown} */ value) => {
        const { parts } = opened;
        return { ...opened, parts: { ...parts, [slice.name]: { ...parts[slice.name], [field]: value } } };
      };
      try {
        return having(read(text));
      } catch (error) {
        throw error instanceof PartlyRead ? new PartlyRead(error.message, having(error.opened)) : error;
      }
    },
  };
}

/** What is tried stands in the links of the parts that try it. @param {Pick<Places, 'triesStarts' | 'triesDisturbance'>} places @returns {readonly Key[]} */
export const driveKeys = ({ triesStarts, triesDisturbance }) => [
  {
    key: 'generation',
    text: ({ generation }) => (generation > 0 ? String(generation) : null),
    read: (opened, text) => ({ ...opened, generation: wholeNumber(text, lastGeneration) }),
  },
  {
    key: 'drives',
    text: ({ driver }) => (driver === 'evolved' ? null : driver),
    read: (opened, text) => ({ ...opened, driver: oneOf(drivers, text) }),
  },
  {
    key: 'gains',
    text: ({ handGains }) => (handGains ? handGains.map(numberText).join(',') : null),
    read(opened, text, engine) {
      const handGains = triple(text);
      // The core knows which gains cannot be driven.
      engine.check(opened.experiment, handGains);
      return { ...opened, handGains };
    },
  },
  {
    key: 'found',
    text: ({ handGains, found }) => (handGains && found !== 'hand' ? found : null),
    read: (opened, text) => ({ ...opened, found: oneOf(finds, text) }),
  },
  {
    key: 'from',
    text: ({ trial, page }) => (trial.start && triesStarts(page) ? postureText(trial.start) : null),
    read(opened, text, engine) {
      const start = posture(text);
      engine.experiment({ starts: [start] });
      return { ...opened, trial: { ...opened.trial, start } };
    },
  },
  {
    key: 'under',
    text: ({ trial, page }) =>
      trial.disturbance && triesDisturbance(page) ? disturbanceText(trial.disturbance) : null,
    read(opened, text, engine) {
      const { disturbance } = engine.experiment({ disturbance: disturbanceOf(text) });
      return { ...opened, trial: { ...opened.trial, disturbance } };
    },
  },
];

/** @type {readonly Key[]} */
export const pinKeys = styles.map((_, slot) => ({
  key: `pin${slot + 1}`,
  text({ pins }, usual) {
    const pin = pins.find((one) => one.slot === slot);
    return pin ? pinText(pin, usual) : null;
  },
  read(opened, text, engine) {
    const pin = pinOf(text, slot, engine.experiment(opened.preset), engine);
    return { ...opened, pins: [...opened.pins, pin].sort((a, b) => a.slot - b.slot) };
  },
}));

/** How links name the steps of the lesson; one that is not there has a nearest. @typedef {{ named: (text: string) => { number: number, isThere: boolean }, textOf: (step: number) => string, linkOf: (step: number) => string }} Steps */

/** @param {Steps} steps @returns {Key} */
export const lessonKey = (steps) => ({
  key: 'lesson',
  text: ({ lesson }) => (lesson > 0 ? steps.textOf(lesson) : null),
  read: (opened, text) => ({ ...opened, lesson: steps.named(text).number }),
});

/** A pinned drive: its name, gains, and what its experiment has different. @param {Pin} pin @param {Experiment} usual */
function pinText({ name, gains, experiment }, usual) {
  const changes = changesText(experiment, usual);
  return [name, gains.map(numberText).join(','), ...changes].join('~');
}

/** @param {string} text @param {number} slot @param {Experiment} usual @param {Engine} engine @returns {Pin} */
function pinOf(text, slot, usual, engine) {
  const [name, gainsText, ...changes] = text.split('~');
  if (gainsText === undefined) throw new Error(words.expected(words.aPin, text));
  const gains = triple(gainsText);
  const experiment = engine.experiment(withChanges(usual, changes));
  engine.check(experiment, gains);
  return { slot, name: plainText(name.slice(0, 80)), experiment, gains };
}
