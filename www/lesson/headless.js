// The lesson without a page, under Node: what a link of it sets up, and what runs then.
import { createEngine } from '../core/headless.js';
import { createAnatomy, createChosenDrives } from '../parts/generation/record.js';
import { places } from '../parts/parts.js';
import { atEnd } from '../run/clock.js';
import { gainsOf } from '../run/drivers.js';
import { firstState } from '../run/first.js';
import { createScene } from '../run/scene.js';
import { links } from './links.js';

/** @import { Engine } from '../core/engine.js' */
/** @import { Live } from './page.js' */

/** What a link asks for; it must not have anything wrong. @param {string} link @param {Engine} [engine] */
export function openedBy(link, engine = createEngine()) {
  const { opened, problems } = links.openLink(link, engine);
  if (problems.length > 0) throw new Error(problems.join(' '));
  return opened;
}

/** What the page knows once a link is opened, its evolution is there, and the robots stand at the start; no part of the page computes. @param {string} link @returns {Live} */
export function liveOf(link) {
  const engine = createEngine();
  const run = openedBy(link, engine);
  const first = firstState(engine, run.preset, atEnd);
  const history = [engine.begin(run.experiment).statistics];
  while (history.length <= run.generation) history.push(engine.step());
  const { parts, ...rest } = run;
  const slices = Object.fromEntries(
    places.slices.map((slice) => [slice.name, slice.opened(first, parts[slice.name])]),
  );
  const population = engine.population(run.generation);
  const state = { ...first, ...rest, slices, page: 'lab', history, population };
  const paper = engine.paper();
  const chosenDrives = createChosenDrives(createAnatomy(engine.record));
  const scene = createScene(engine.drive, paper, chosenDrives)(state);
  const samples = engine.samples(scene.experiment, scene.gains);
  const sample = samples.at(0);
  const gains = gainsOf(state, state.driver, paper);
  return { engine, state, scene, paper, gains, samples, at: 0, sample, decided: sample };
}
