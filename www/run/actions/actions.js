// What the controls do: each action takes the page from one good state to the next, or leaves it and says why.
/** @import { Means } from './basis.js' */
import { createBasis } from './basis.js';
import { createClock, createDrive } from './drive.js';
import { createEvolution } from './evolution.js';
import { createExperiments } from './experiment.js';
import { createOpenPage, createOpening, createPage } from './page.js';
import { createPins } from './pins.js';

/** @typedef {ReturnType<typeof createActions>} Actions */

/** @param {Means} means */
export function createActions(means) {
  const basis = { ...means, ...createBasis(means) };
  const openPage = createOpenPage(basis);
  const { catchUp, ...evolution } = createEvolution(basis, openPage);
  return {
    ...evolution,
    whenIdle: basis.whenIdle,
    ...createExperiments(basis, catchUp),
    ...createDrive(basis),
    ...createClock(basis),
    ...createPins(basis),
    ...createOpening(basis, catchUp),
    ...createPage(basis, openPage),
  };
}
