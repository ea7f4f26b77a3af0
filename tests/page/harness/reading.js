// What a person reads on the page, in one look.
import assert from 'node:assert/strict';
import { evolve, experiment } from './core.js';

/** @typedef {import('./browsers.js').Page} Page */
/** @typedef {{ x: number, y: number, degrees: number }} PostureText */

/** Reads the page once it has drawn what happened last. @param {Page} page */
export function read(page) {
  return page.evaluate(() => {
    /** @param {string} id */
    const element = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
    /** @param {string} id */
    const numbers = (id) =>
      (
        element(id)
          .innerText.replaceAll('−', '-')
          .match(/-?\d+(\.\d+)?/g) ?? []
      ).map(Number);
    /** @param {string} id */
    const posture = (id) => {
      const [x, y, degrees] = numbers(id);
      return { x, y, degrees };
    };
    /** @param {string} id */
    const chosen = (id) =>
      /** @type {HTMLInputElement} */ (document.querySelector(`#${id} input:checked`)).value;
    const [time, finalTime] = numbers('clock');

    return {
      generation: element('generation').innerText,
      seed: element('seed').innerText,
      cost: element('cost-total').innerText,
      gains: ['kx', 'ky', 'ktheta'].map(
        (gain) => /** @type {HTMLInputElement} */ (element(`gain-${gain}`)).value,
      ),
      driver: chosen('drives'),
      preset: chosen('preset'),
      time,
      finalTime,
      start: posture('start-text'),
      goal: posture('goal-text'),
    };
  });
}

/** What evolution shows, which the robot's clock must not touch. @param {Page} page */
export async function readEvolution(page) {
  const { generation, seed, cost, gains } = await read(page);
  return { generation, seed, cost, gains };
}

/** What it shows of a generation of seed 1. @param {number} generation */
export const seedOne = (generation) => ({
  generation: String(generation),
  seed: '1',
  ...evolve(experiment('velocity-limits'), generation).shown,
});

/** Waits until the robots' clock shows their final time. @param {Page} page */
export const arrival = (page) =>
  page.until('the robots arrive', () => {
    const [time, finalTime] = document.getElementById('clock')?.innerText.match(/\d+\.\d+/g) ?? [];
    return time !== undefined && time === finalTime;
  });

/** The middle of an element, in pixels from the top left corner of another one. @param {Page} page @param {string} id @param {string} [within] */
export function middleOf(page, id, within = 'plane-robots') {
  return page.evaluate(
    (one, other) => {
      const [box, around] = [one, other].map((name) =>
        /** @type {HTMLElement} */ (document.getElementById(name)).getBoundingClientRect(),
      );
      return { x: box.left + box.width / 2 - around.left, y: box.top + box.height / 2 - around.top };
    },
    id,
    within,
  );
}

/** Waits until the page has checked its own numbers, or has said why it cannot. @param {Page} page */
export const checked = (page) =>
  page.until('the checks have ended', () => {
    const { open } = /** @type {HTMLDialogElement} */ (document.getElementById('checks'));
    return open && document.getElementById('checks-progress')?.hidden;
  });

/** What is read as a number. @param {string} text */
export const numberOf = (text) => Number(text.replaceAll('−', '-').replace(/[^\d.e-]/g, ''));

/** The text of an element that is in sight, once what happened last is drawn. @param {Page} page @param {string} selector */
export const textOf = (page, selector) =>
  page.evaluate((one) => {
    const element = /** @type {HTMLElement} */ (document.querySelector(one));
    return element.checkVisibility() ? element.innerText.trim() : 'not in sight';
  }, selector);

/** How many of these points of a canvas have their colour within two pixels. @param {Page} page @param {string} selector @param {{ x: number, y: number, token: string }[]} points */
export const coloured = (page, selector, points) =>
  page.evaluate(
    (name, places) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(name));
      const context = canvas.getContext('2d');
      const style = getComputedStyle(document.documentElement);
      return places.filter(({ x, y, token }) => {
        const wanted = (style.getPropertyValue(token).match(/[\da-f]{2}/g) ?? []).map((part) =>
          Number.parseInt(part, 16),
        );
        const { data } = /** @type {CanvasRenderingContext2D} */ (context).getImageData(
          Math.round(x * devicePixelRatio) - 2,
          Math.round(y * devicePixelRatio) - 2,
          5,
          5,
        );
        return Array.from({ length: 25 }, (_, i) => i).some(
          (i) =>
            data[4 * i + 3] > 60 &&
            wanted.every((part, channel) => Math.abs(part - data[4 * i + channel]) <= 40),
        );
      }).length;
    },
    selector,
    points,
  );

/** How many pixels of a canvas have a colour. @param {Page} page @param {string} selector @param {string} token */
export const pixelsOf = (page, selector, token) =>
  page.evaluate(
    (name, property) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(name));
      const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      const hex = getComputedStyle(document.documentElement).getPropertyValue(property);
      const wanted = (hex.match(/[\da-f]{2}/g) ?? []).map((part) => Number.parseInt(part, 16));
      let count = 0;
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 3] > 60 && wanted.every((part, channel) => Math.abs(part - data[i + channel]) <= 12))
          count += 1;
      return count;
    },
    selector,
    token,
  );

/** What a student sees and hears of some controls. @param {Page} page @param {...string} selectors */
export const waysOf = (page, ...selectors) =>
  page.evaluate((wanted) => {
    const reason = document.getElementById('exercise-locks')?.textContent ?? '';
    return wanted.map((selector) => {
      const element = document.querySelector(selector);
      if (!element?.checkVisibility()) return 'hidden';
      const isDisabled = element.matches(':disabled, [aria-disabled="true"]');
      const holder = element.closest('[data-locked]');
      const isTold = holder?.getAttribute('aria-describedby')?.split(' ').includes('exercise-locks');
      return isDisabled && isTold && reason !== '' ? 'locked' : isDisabled ? 'disabled' : 'free';
    });
  }, selectors);

/** Opens a table and reads its cells, the head first. @param {Page} page @param {string} button */
export async function readTable(page, button) {
  await page.click(`#${button}`);
  const cells = await page.evaluate(() =>
    [.../** @type {HTMLTableElement} */ (document.getElementById('table-rows')).rows].map((row) =>
      [...row.cells].map((cell) => cell.innerText),
    ),
  );
  assert.deepEqual(await page.obstacles('#table'), []);
  await page.click('#table-close');
  return cells;
}
