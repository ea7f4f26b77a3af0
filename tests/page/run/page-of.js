// The state and the actions of a page, without the page.
import { links } from '../../../www/lesson/links.js';
import { places } from '../../../www/parts/parts.js';
import { createActions } from '../../../www/run/actions/actions.js';
import { atEnd } from '../../../www/run/clock.js';
import { firstState } from '../../../www/run/first.js';
import { createStore } from '../../../www/run/store.js';
import { createEngine } from '../harness/core.js';

const atRest = { finalTime: () => 1, isStill: () => true };

/** A page on which a link was opened. @param {string} link @param {typeof atRest} [clock] */
export function pageOf(link, clock = atRest) {
  const engine = createEngine();
  const store = createStore(firstState(engine, 'velocity-limits', atEnd), () => {});
  const means = { engine, store, paper: engine.paper(), ...clock, places };
  const actions = createActions(means);
  // On a slow machine a run comes only a part of its way at once.
  const goOn = () => actions.evolve(() => store.get().catchingUp !== null);
  for (const name of /** @type {const} */ (['undo', 'redo', 'backToExercise'])) {
    const act = actions[name];
    actions[name] = () => {
      act();
      goOn();
    };
  }
  const open = (/** @type {string} */ text) => {
    const { opened, problems } = links.openLink(text, engine);
    actions.openLinked(opened, problems);
    goOn();
  };
  open(link);
  return { engine, store, actions, open };
}
