// What the controls do, without the controls.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { places } from '../../../www/parts/parts.js';
import { createActions } from '../../../www/run/actions/actions.js';
import { atEnd } from '../../../www/run/clock.js';
import { firstState, noErrors } from '../../../www/run/first.js';
import { createStore } from '../../../www/run/store.js';
import { createEngine } from '../harness/core.js';
import { test } from '../harness/once.js';

/** A page on which a link was opened. @param {string} link */
function pageOf(link) {
  const engine = createEngine();
  const store = createStore(firstState(engine, 'velocity-limits', atEnd), () => {});
  const means = { engine, store, paper: engine.paper(), finalTime: () => 1, isStill: () => true, places };
  const actions = createActions(means);
  const open = (/** @type {string} */ text) => actions.openLinked(links.openLink(text, engine).opened, []);
  open(link);
  return { store, actions, open };
}

test('a generation to stop at is refused once it has passed, and beyond what a link can say', () => {
  const { store, actions } = pageOf('lab&generation=6');
  for (const text of ['6', '1', '0', '6.5', 'x', '', '100001', 'Infinity']) {
    actions.setUntil('generation', text);
    assert.match(store.get().untilError, /from 7 to 100000/, text);
    assert.equal(store.get().until.kind, 'every');
  }
  for (const text of ['7', '100000']) {
    actions.setUntil('generation', text);
    assert.deepEqual(
      [store.get().until, store.get().untilError],
      [{ kind: 'generation', value: Number(text) }, ''],
    );
  }
});

test('what was refused of the gains is gone with them when a link is opened', () => {
  const { store, actions, open } = pageOf('lab&drives=hand&gains=3,1,5');
  actions.typeGain(0, 'x');
  assert.match(store.get().gainErrors[0], /number/);
  open('lab&drives=hand&gains=3,1,4');
  assert.deepEqual(store.get().gainErrors, noErrors);
});

test('a start that a link tries is tried where one can be', () => {
  const start = { x: 2, y: 0, theta: 0 };
  assert.deepEqual(pageOf('robustness&from=2,0,0').store.get().trial.start, start);
  assert.equal(pageOf('curves&from=2,0,0').store.get().trial.start, null);
});
