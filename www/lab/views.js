// The elements of the page, each given to the view that draws in it.
/** @import { Actions } from '../run/actions/actions.js' */
import { createEvolutionBar, createPauseButton, createRobotBar } from './bars.js';
import { createCost } from './cost.js';
import { createCurve } from './fitness.js';
import { byId, write } from '../kit/elements.js';
import { createGains } from './gains.js';
import { createHandles } from './handles.js';
import { createNotes } from './notes.js';
import { createPlane } from './plane.js';
import { createSegmented, listed } from '../kit/segmented.js';
import { createSigmas } from './sigmas.js';
import { sigmas as sigmaWords, lab as strings, texts } from '../words/index.js';
import { language } from '../words/language.js';
import { createPages } from './navigation.js';
import { labSlice } from './state.js';

/** @typedef {ReturnType<typeof createHead>} Head */
/** @typedef {ReturnType<typeof createViews>} Views */

/** @param {string} text */
export function showMessage(text) {
  const message = byId('message');
  write(message, text);
  message.hidden = text === '';
}

/** Fills in those of index.html that are known, each by its name; what belongs to a part that is not there yet stays empty. @param {Readonly<Record<string, string>>} texts */
function fillTexts(texts) {
  for (const name of ['data-text', 'data-label', 'data-content'])
    for (const element of document.querySelectorAll(`[${name}]`)) {
      const text = texts[element.getAttribute(name) ?? ''];
      if (text === undefined) continue;
      if (name === 'data-text') element.textContent = text;
      else element.setAttribute(name === 'data-label' ? 'aria-label' : 'content', text);
    }
}

/** What index.html leaves to the language. */
export function sayTexts() {
  document.documentElement.lang = language;
  document.title = texts.pageTitle;
  fillTexts(texts);
}

/** What stands above all parts. @param {Actions} actions @param {readonly string[]} pages @param {Record<string, import('./navigation.js').Named>} named @param {() => void} onLesson */
export const createHead = (actions, pages, named, onLesson) => ({
  pages: createPages(pages, named, byId('pages'), byId('tagline'), actions.openPage, onLesson),
  preset: createSegmented('preset', strings.presetLegend, listed(strings.presets), actions.choosePreset),
  pauseButton: createPauseButton(byId('pause-evolution'), actions),
});

/** @param {import('../run/store.js').Store} store @param {Actions} actions */
export const createViews = (store, actions) => ({
  drivers: createSegmented('drives', strings.driverLegend, listed(strings.drivers), actions.chooseDriver),
  plane: createPlane(byId('plane-paths'), byId('plane-robots')),
  handles: createHandles(byId('handles'), {
    postureOf: actions.postureOf,
    onMove: actions.movePosture,
    onRelease: actions.releasePosture,
  }),
  notes: createNotes({ onRestore: actions.restorePostures }),
  robotBar: createRobotBar(byId('robot-clock'), actions),
  cost: createCost(byId('cost'), byId('gains-cost')),
  curve: createCurve(byId('curve')),
  sigmas: createSigmas(byId('sigmas')),
  curveChoice: createSegmented(
    'curve-choice',
    sigmaWords.curveLegend,
    listed(sigmaWords.curveChoices),
    (curve) => labSlice.update(store, { curve }),
  ),
  evolutionBar: createEvolutionBar(byId('evolving'), actions),
  gains: createGains(byId('gains'), byId('gains-note'), {
    onSlide: actions.slideGain,
    onSlid: actions.driveAgain,
    onType: actions.typeGain,
  }),
});
