// What tests have to know of a part of the page: a file in samples/, called like the part.
import { pageNames } from '../../../www/parts/parts.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/run/exercise.js').Group} Group */
/** A picture: some of its texts, and how many shapes (`path`) there are at least. Apart: other things stand between its parts. @typedef {{ name: string, key: string, texts: readonly string[], lines: number, apart?: boolean }} Pictured */
/**
 * @typedef {object} Sample
 * @property {readonly string[]} [views] What stands behind a choice and looks different, as its links say it.
 * @property {readonly string[]} [more] What looks much the same, which fewer tests open.
 * @property {object} [slice] What it keeps, so that none of its keys is left out of a link.
 * @property {Readonly<Record<string, string>>} [tables] By what a link says beside the part, the id of what opens a table.
 * @property {readonly { lead: (page: Page) => Promise<unknown>, id: string }[]} [done] How one comes to what is there only when work is done, and one control of it.
 * @property {readonly string[]} [free] The controls that change nothing that an exercise could lock.
 * @property {Partial<Record<Group, readonly (readonly [view: string, selector: string])[]>>} [controls] Where a group that an exercise can hide has its controls in it: what a link says beside the part, and the controls. By hand, so that it does not know what the page believes to be its controls.
 * @property {readonly [picture: string, control: string]} [essentials] What of it stays in sight in a small figure, where it is not the first of each.
 * @property {Readonly<Record<string, string>>} [lasting] What of it no link carries, and stays when one is opened, with its reason.
 * @property {{ place: string, text: string }} [computed] Where and how it says that workers are done; without it, it asks for none when it is opened.
 * @property {readonly [view: string, id: string] | null} readout What of it says in words what drives; null: it has words of its own for that, and tests of its own, or none.
 * @property {readonly { setUp?: (page: Page) => Promise<unknown>, pictures: readonly Pictured[] }[]} pictures What it offers as files, after what.
 */

/** @type {Readonly<Record<string, Sample>>} */
export const samples = Object.fromEntries(
  await Promise.all(pageNames.map(async (name) => [name, (await import(`./samples/${name}.js`)).sample])),
);

/** @param {'views' | 'more'} which */
export const linksTo = (which) =>
  pageNames.flatMap((name) => (samples[name][which] ?? []).map((view) => `${name}&v=1&${view}`));
