// Every word of the page in each language: the common ones, and those that each part has in its own folder.
import { readdirSync } from 'node:fs';
import * as commonEnglish from '../../../www/words/en/index.js';
import * as commonKorean from '../../../www/words/ko/index.js';

/** The folder of a part's words, and the part. */
const folder = /(\w+)[\\/]words[\\/]en\.js$/;

const www = new URL('../../../www/', import.meta.url);
const names = readdirSync(www, { recursive: true, encoding: 'utf8' }).filter((name) => folder.test(name));

/** @param {string} language @returns {Promise<Record<string, Record<string, unknown>>>} */
async function partsIn(language) {
  const parts = names.map(async (name) => [
    folder.exec(name)?.[1],
    await import(new URL(name.replace(/en\.js$/, `${language}.js`), www).href),
  ]);
  return Object.fromEntries(await Promise.all(parts));
}

/** The lesson has some words before it is loaded. @template {Record<string, any>} C @param {C} common @param {string} language @returns {Promise<C>} */
async function allIn(common, language) {
  const { lesson, ...parts } = await partsIn(language);
  return { ...common, ...parts, lesson: { ...common.lesson, ...lesson } };
}

export const en = await allIn(commonEnglish, 'en');
export const ko = await allIn(commonKorean, 'ko');

/** @satisfies {Record<import('../../../www/words/language.js').Language, unknown>} */
export const inEach = { en, ko };

/** Shorter ones are symbols and units. */
export const latinWord = /[A-Za-z]{3,}/;
/** Names, keys, units and functions that stay as they are, and the title of the paper. */
export const sameInBoth =
  /Kim and H\.-S\. Shim, “Evolutionary Programming-Based [^”]*”, Proceedings [^,]*, MIT Press|\b(CITATION\.cff|self-\u2060?adaptation|unicycle|nonholonomic|saturation|disturbance|chattering|elitism|generalisation|overfitting|local optimum|log-\u2060?normal|Python|JavaScript|MATLAB|Octave|CSV|ERT|PNG|SVG|SCORM|Moodle|Kim|Shim|Kanayama|Fogel|Schwefel|Brockett|Enter|Shift|Alt|Ctrl|Esc|Tab|PageDown|PageUp|CMA-\u2060?ES|min|max|rad|cos|sin|exp|WebAssembly|Node|ep-locomotion|Chrome|Firefox|Safari|[0-9a-f]{8,})\b/g;
