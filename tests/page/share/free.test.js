// What looks free in an exercise is free: where all is locked, whatever can still be pressed does what it looks like.
import assert from 'node:assert/strict';
import { groupNames } from '../../../www/run/exercise.js';
import { pageTest } from '../harness/browsers.js';
import { samples } from '../parts/samples.js';
import { follow } from '../whole/surround.js';
import { views } from '../whole/views.js';

/** Works every control that looks free, once, also those that come with it, and points at every picture. Links are tried elsewhere. @param {string} part */
async function workAll(part) {
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
    await pageFrames.settled();
    if (reason.getAnimations().length > 0) found.push(some.map(nameOf).join(', '));
    for (const animation of reason.getAnimations()) animation.cancel();
  }
  // Of a pointer that there is not.
  Element.prototype.setPointerCapture = () => {};
  for (const picture of document.querySelectorAll(`section.${part} [data-picture]`)) {
    picture.scrollIntoView({ block: 'center' });
    const { left, top, width, height } = picture.getBoundingClientRect();
    const place = { clientX: left + width / 3, clientY: top + height / 2 };
    const hit = document.elementFromPoint(place.clientX, place.clientY) ?? picture;
    if (hit.closest('[aria-disabled="true"]')) continue;
    for (const type of ['pointermove', 'pointerdown', 'pointermove', 'pointerup'])
      hit.dispatchEvent(
        new PointerEvent(type, {
          bubbles: true,
          ...place,
          pointerType: 'mouse',
          buttons: Number(type !== 'pointerup'),
        }),
      );
    await pageFrames.settled();
    if (reason.getAnimations().length > 0) found.push(`${picture.id || picture.className}, pointed at`);
    for (const animation of reason.getAnimations()) animation.cancel();
  }
  return { found, own };
}

pageTest('where all is locked no control looks free that is not', async (page) => {
  /** @type {string[]} */
  const flaws = [];
  /** @type {Set<string>} */
  const worked = new Set();
  const locked = `lock=${groupNames.join(',')}&task=Stay`;
  await page.open(`#lab&v=1&${locked}`);
  for (const view of views) {
    await follow(page, `${view}&${locked}`);
    const part = view.split('&')[0];
    const { found, own } = await page.evaluate(workAll, part);
    flaws.push(...found.map((some) => `${view}: one of ${some} is not free`));
    const known = samples[part]?.free ?? [];
    flaws.push(...own.filter((id) => !known.includes(id)).map((id) => `${view}: #${id} is free`));
    for (const id of own) worked.add(id);
  }
  assert.deepEqual(
    flaws,
    [],
    'a part locks it in its places, or it is in `free` of its file in tests/page/parts/samples/',
  );
  // Where nothing could be pressed nothing would be found.
  const idle = Object.keys(samples).filter((name) => samples[name].free?.every((id) => !worked.has(id)));
  assert.deepEqual(idle, [], 'of each part something that is free was pressed');
});

pageTest('nor where work is done, which alone is not locked', async (page) => {
  const locked = groupNames.filter((name) => name !== 'run').join(',');
  for (const [part, { done = [] }] of Object.entries(samples))
    for (const { lead, id } of done) {
      await page.open(`#${part}&lock=${locked}&task=Stay`);
      await lead(page);
      const { found, own } = await page.evaluate(workAll, part);
      assert.deepEqual(found, [], part);
      assert.ok(own.includes(id), `#${id} was pressed`);
    }
});
