// Which drives by hand count, without a page: the events of its sliders are made up.
import assert from 'node:assert/strict';
import { progressSlice } from '../../../www/lesson/state.js';
import { createTally } from '../../../www/lesson/tally.js';
import { test } from '../harness/once.js';
import { liveOf } from './live.js';

/** @typedef {import('../../../www/lesson/page.js').Live} Live */

test('what counts is a drive with other gains than the link opened, made in this experiment', (t) => {
  /** @type {Map<string, ((event: object) => void)[]>} */
  const heard = new Map();
  class Input {
    type = 'text';
    closest = () => this;
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
  /** How many there are after a frame. @param {Partial<Live['state']>} [patch] @param {boolean} [isTyped] */
  const counted = (patch, isTyped = true) => {
    if (isTyped) for (const act of heard.get('change') ?? []) act({ target: new Input(), type: 'change' });
    live = { ...live, state: { ...live.state, ...patch } };
    tally.count(live, /** @type {any} */ ({}));
    return progressSlice.of(live.state).tally.drives;
  };
  /** @param {number} kx @returns {Partial<Live['state']>} */
  const by = (kx) => ({ handGains: [kx, 1, 5], gainErrors: ['', '', ''] });

  assert.equal(counted({}), 0, 'what the link opened');
  assert.equal(counted({ gainErrors: ['no number', '', ''] }), 0, 'what was refused');
  assert.equal(counted(by(4)), 1);
  assert.equal(counted(by(4), false), 1, 'nothing was moved');
  assert.equal(counted(by(3)), 2, 'back to what the link opened');
  assert.equal(counted({ gainErrors: ['no number', '', ''] }), 2);
  assert.equal(counted({ ...by(6), page: 'curves' }), 2, 'where nothing counts');
  const experiment = structuredClone(live.state.experiment);
  assert.equal(
    counted({ ...by(7), page: 'lab', experiment }, false),
    2,
    'moved before, in another experiment',
  );
  assert.equal(counted(by(8)), 3);
});
