// The panel of settings, as a person works it.
import assert from 'node:assert/strict';
import { Key } from './browsers.js';
import { evolve } from './core.js';
import { read } from './reading.js';

/** @typedef {import('./browsers.js').Page} Page */

/** Opens a group of the open panel, as with a press on its name. @param {Page} page @param {string} group */
export const openGroup = (page, group) => page.click(`#settings-${group}:not([open]) summary`);

/** @param {Page} page */
export const openSettings = (page) => page.click('#settings-button');

/** Types into a setting over what it holds. @param {Page} page @param {string} id @param {string} text */
export async function type(page, id, text) {
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.focus(`#setting-${id}`);
  await page.press(...text, Key.ENTER);
}

/** What a person reads about a setting. @param {Page} page @param {string} id */
export const setting = (page, id) =>
  page.evaluate(async (name) => {
    const field = /** @type {HTMLInputElement} */ (document.getElementById(`setting-${name}`));
    const row = /** @type {HTMLElement} */ (field.closest('.setting'));
    const error = /** @type {HTMLElement} */ (row.querySelector('.field-error'));
    const back = /** @type {HTMLElement} */ (row.querySelector('.back'));
    const distance = error.getBoundingClientRect().top - field.getBoundingClientRect().bottom;
    return {
      value: field.value,
      isEnabled: !field.disabled,
      error: error.checkVisibility() && Math.abs(distance) < 60 ? error.innerText : '',
      back: back.checkVisibility() ? (back.getAttribute('aria-label') ?? '') : null,
    };
  }, id);

/** @param {Page} page */
export const summary = (page) =>
  page.evaluate(async () => {
    const element = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
    return {
      button: element('settings-button').innerText,
      changed: element('settings-changed').innerText,
      isPresetOffered: element('settings-preset').checkVisibility(),
      canUndo: element('settings-undo').getAttribute('aria-disabled') === 'false',
      canRedo: element('settings-redo').getAttribute('aria-disabled') === 'false',
    };
  });

/** @param {Page} page @param {string} modifiers @param {string} key */
export const chord = async (page, modifiers, key) => {
  let actions = page.driver.actions();
  for (const modifier of modifiers) actions = actions.keyDown(modifier);
  actions = actions.keyDown(key).keyUp(key);
  for (const modifier of modifiers) actions = actions.keyUp(modifier);
  await actions.perform();
};

/** That generation 0 of this experiment is on screen. @param {Page} page @param {import('./core.js').Experiment} from */
export async function assertBegun(page, from) {
  const { generation, cost, gains } = await read(page);
  assert.deepEqual({ generation, cost, gains }, { generation: '0', ...evolve(from).shown });
}
