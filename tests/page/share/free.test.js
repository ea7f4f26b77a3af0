// What looks free in an exercise is free: where all is locked, whatever can still be pressed does what it looks like.
import assert from 'node:assert/strict';
import { groupNames } from '../../../www/run/exercise.js';
import { pageTest } from '../harness/browsers.js';
import { views } from '../whole/views.js';

/** Of each part, the controls that change nothing that an exercise could lock. @type {Record<string, readonly string[]>} */
const freeInPart = {
  curves: [
    'curves-numbers',
    'curves-view-compare',
    'curves-view-numbers',
    'curves-view-stability',
    'curves-view-time',
    'stability-log',
    'stability-table',
  ],
  disturbance: [],
  generation: [
    'generation-phases-drive',
    'generation-phases-mutation',
    'generation-phases-parents',
    'generation-phases-ranking',
    'generation-phases-survivors',
    'generation-phases-tournament',
    'generation-picture',
    'generation-table',
  ],
  lab: [],
  landscape: ['landscape-follows', 'landscape-table', 'landscape-third', 'landscape-x', 'landscape-y'],
  luck: [
    'contest-budget',
    'contest-reading-course',
    'contest-reading-ends',
    'contest-reading-targets',
    'contest-seeds',
    'contest-target',
    'contest-target-line',
    'contest-until-line',
    'contest-usual',
    'contestant-2',
    'contestant-3',
    'contestant-4',
    'luck-count',
    'luck-generations',
    'luck-view-contest',
    'luck-view-seeds',
  ],
  park: ['park-again', 'park-close', 'park-next', 'park-previous'],
  robustness: [
    'robustness-half',
    'robustness-headings-all',
    'robustness-headings-one',
    'robustness-quantity-cost',
    'robustness-quantity-share',
    'robustness-quantity-time',
    'robustness-rose',
    'robustness-table',
  ],
  training: ['training-generations'],
};

/** Works every control that looks free, once, also those that come with it. Links are tried elsewhere. @param {string} part */
async function workAll(part) {
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const selector = 'button, input, select, summary, [tabindex="0"]';
  /** @type {Set<Element>} */
  const worked = new Set();
  const fresh = () =>
    [...document.querySelectorAll(selector)].filter(
      (element) =>
        !worked.has(element) &&
        element.checkVisibility() &&
        !element.matches(':disabled, [aria-disabled="true"]') &&
        !element.closest('[inert]'),
    );
  /** @param {Element} element */
  const work = (element) => {
    const tell = (/** @type {string} */ type) => element.dispatchEvent(new Event(type, { bubbles: true }));
    if (element instanceof HTMLSelectElement) {
      element.selectedIndex = (element.selectedIndex + 1) % element.options.length;
      tell('change');
    } else if (element instanceof HTMLInputElement && element.type === 'range') {
      element.value = String((Number(element.min) + Number(element.max)) / 2);
      tell('input');
      tell('change');
    } else if (element instanceof HTMLInputElement && /text|number/.test(element.type)) {
      element.value = '3';
      tell('input');
      tell('change');
    } else if (element instanceof HTMLElement) {
      for (const key of ['ArrowRight', 'Enter'])
        element.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
      element.click();
    }
    for (const dialog of document.querySelectorAll('dialog')) dialog.close();
  };
  const reason = /** @type {HTMLElement} */ (document.getElementById('exercise-locks'));
  const nameOf = (/** @type {Element} */ { id, textContent }) => id || textContent?.trim();
  /** @type {string[]} */
  const found = [];
  /** @type {string[]} */
  const own = [];
  for (let some = fresh(); some.length > 0 && worked.size < 500; some = fresh()) {
    for (const element of some) {
      worked.add(element);
      if (element.id && element.closest(`section.${part}`)) own.push(element.id);
      if (element.isConnected) work(element);
    }
    for (let i = 0; i < 3; i += 1) await frame();
    if (reason.getAnimations().length > 0) found.push(some.map(nameOf).join(', '));
    for (const animation of reason.getAnimations()) animation.cancel();
  }
  return { found, own };
}

pageTest('where all is locked no control looks free that is not', async (page) => {
  /** @type {string[]} */
  const flaws = [];
  for (const view of views) {
    await page.open(`#${view}&lock=${groupNames.join(',')}&task=Stay`);
    const part = view.split('&')[0];
    const { found, own } = await page.evaluate(workAll, part);
    flaws.push(...found.map((some) => `${view}: one of ${some} is not free`));
    const known = freeInPart[part] ?? [];
    flaws.push(...own.filter((id) => !known.includes(id)).map((id) => `${view}: #${id} is free`));
  }
  assert.deepEqual(flaws, [], 'a part locks it in its places');
});
