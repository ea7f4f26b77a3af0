// Which drives by hand count, without a page: the events of its sliders are made up.
import assert from 'node:assert/strict';
import { noTally, progressSlice } from '../../../www/lesson/state.js';
import { createTally, talliesBut, tallyOf, taskText } from '../../../www/lesson/duel/tally.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { liveOf } from './live.js';

/** @typedef {import('../../../www/lesson/page.js').Live} Live */

/** Hands and gains without a page. @param {import('node:test').TestContext} t */
function createHands(t) {
  /** @type {Map<string, ((event: object) => void)[]>} */
  const heard = new Map();
  class Input {
    closest = () => this;
    constructor(type = 'text') {
      this.type = type;
    }
  }
  const globals = /** @type {any} */ (globalThis);
  globals.HTMLInputElement = Input;
  globals.addEventListener = (/** @type {string} */ type, /** @type {() => void} */ act) =>
    heard.set(type, [...(heard.get(type) ?? []), act]);
  t.after(() => {
    delete globals.HTMLInputElement;
    delete globals.addEventListener;
  });

  let live = liveOf('lab&drives=hand&gains=3,1,5');
  const store = /** @type {any} */ ({
    get: () => live.state,
    keep: (/** @type {string} */ name, /** @type {unknown} */ slice) => {
      live = { ...live, state: { ...live.state, slices: { ...live.state.slices, [name]: slice } } };
    },
    redraw() {},
  });
  const tally = createTally(store);
  /** An event that the window hears. @param {string} type @param {object} target */
  const fire = (type, target, pointerId = 1) => {
    const more = type.startsWith('pointer') && { pointerId };
    for (const act of heard.get(type) ?? []) act({ type, target, currentTarget: globals, ...more });
  };
  /** How many there are after a frame. @param {Partial<Live['state']>} [patch] @param {boolean} [isTyped] */
  const counted = (patch, isTyped = true) => {
    if (isTyped) fire('change', new Input());
    const { experiment = live.scene.experiment } = patch ?? {};
    live = { ...live, state: { ...live.state, ...patch }, scene: { ...live.scene, experiment } };
    tally.count(live, /** @type {any} */ ({}));
    return progressSlice.of(live.state).tallies[0]?.drives ?? 0;
  };
  return {
    counted,
    fire,
    window: globals,
    createSlider: () => new Input('range'),
    createField: () => new Input(),
    experiment: live.state.experiment,
  };
}

/** @param {number} kx @returns {Partial<Live['state']>} */
const by = (kx) => ({ handGains: [kx, 1, 5], gainErrors: ['', '', ''] });

test('what counts is a drive with other gains than the link opened, made in this experiment', (t) => {
  const { counted, fire, createField, experiment: first } = createHands(t);
  assert.equal(counted({}), 0, 'what the link opened');
  assert.equal(counted({ gainErrors: ['no number', '', ''] }), 0, 'what was refused');
  assert.equal(counted({ gainErrors: ['', '', ''] }), 0, 'what the link opened, typed once more');
  assert.equal(counted(by(4)), 1);
  assert.equal(counted(by(4), false), 1, 'nothing was moved');
  assert.equal(counted(by(3)), 2, 'back to what the link opened');
  assert.equal(counted({ gainErrors: ['no number', '', ''] }), 2);
  assert.equal(counted({ ...by(6), page: 'curves' }), 2, 'where nothing counts');
  const experiment = structuredClone(first);
  assert.equal(
    counted({ ...by(7), page: 'lab', experiment }, false),
    2,
    'moved before, in another experiment',
  );
  assert.equal(counted(by(8)), 3);
  const other = structuredClone(first);
  other.goal.x += 1;
  assert.equal(counted({ experiment: other }, false), 3, 'nothing was driven there');
  assert.equal(counted(by(2)), 1, 'of another experiment');
  assert.equal(counted({ experiment: first }, false), 1);
  assert.equal(counted(by(5)), 4, 'what was driven in this one stays');
  fire('input', createField());
  assert.equal(counted(by(9), false), 4, 'what is still being typed');
});

test('what a slider passes through does not count, whatever had the focus before; where it is let go does', (t) => {
  const { counted, fire, window, createSlider } = createHands(t);
  const [before, slider] = [createSlider(), createSlider()];
  let drives = 0;
  /** Holds the slider, and counts nothing. @param {string} press @param {number[]} passed */
  const hold = (press, passed) => {
    fire(press, slider);
    fire('blur', before);
    for (const kx of passed) {
      fire('input', slider);
      assert.equal(counted(by(kx), false), drives, `${press}, at ${kx}`);
    }
  };
  for (const [press, end, target] of /** @type {const} */ ([
    ['pointerdown', 'pointerup', slider],
    ['pointerdown', 'pointercancel', slider],
    ['keydown', 'keyup', slider],
    ['pointerdown', 'blur', slider],
    ['pointerdown', 'blur', window],
  ])) {
    hold(press, [4, 5, 6 + drives]);
    fire(end, target);
    drives += 1;
    assert.equal(counted({}, false), drives, `${press}, ${end}`);
  }
});

test('while one hand holds a slider, what another presses counts nothing, there or elsewhere', (t) => {
  const { counted, fire, createSlider, createField } = createHands(t);
  const [slider, other] = [createSlider(), createSlider()];
  for (const pressed of [other, createField()]) {
    const before = counted({}, false);
    fire('pointerdown', slider, 1);
    fire('input', slider);
    fire('pointerdown', pressed, 2);
    fire('pointerup', pressed, 2);
    for (const kx of [4, 5 + before]) {
      fire('input', slider);
      assert.equal(counted(by(kx), false), before);
    }
    fire('pointerup', slider, 1);
    assert.equal(counted({}, false), before + 1);
  }
});

test('who begins a contest anew forgets what was driven in it, and nothing else', () => {
  const [first, second] = [0, 1].map((x) => experiment({ goal: { x, y: 2, theta: 0 } }));
  const tallies = [first, second].map((one) => ({ ...noTally, experiment: taskText(one), drives: 3 }));
  assert.deepEqual(talliesBut(tallies, first), [tallies[1]]);
  assert.deepEqual(tallyOf(talliesBut(tallies, first), first), noTally);
});
