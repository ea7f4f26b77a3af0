// What there is to read, in one language, for who cannot run the page: why that is, what the picture shows, and the lesson
// as an article, with what the core comes to in the place of the running numbers. Writes the HTML of each.
//
//   node .tasks/article.mjs ko
import { parseHTML } from 'linkedom';

const [language] = process.argv.slice(2);
const { document, Element } = parseHTML('<html></html>');
// What is imported below asks for these.
Object.assign(globalThis, { document, Element, location: { hash: `#lab&lang=${language}`, search: '' } });
globalThis.navigator ??= /** @type {Navigator} */ ({});

const { createSpec } = await import('../www/parts/disturbance/request.js');
const { disturbanceSlice } = await import('../www/parts/disturbance/state.js');
const { landscapeSlice } = await import('../www/parts/landscape/state.js');
const { landscape, remainingErrors } = await import('../www/core/headless.js');
const { create } = await import('../www/kit/elements.js');
const { askedOf, counts, linearRange } = await import('../www/parts/landscape/request.js');
const { createFormula } = await import('../www/lesson/formulas/formula.js');
const { list, paragraphs } = await import('../www/lesson/prose.js');
const { steps } = await import('../www/lesson/steps.js');
const { liveOf } = await import('../www/lesson/headless.js');
const { undisturbed } = await import('../www/run/scene.js');
const { instead, lab, lesson: first } = await import('../www/words/index.js');
const { default: words } = await import('../www/lesson/words/index.js');
const { costText } = await import('../www/words/numbers.js');
const { costs, generations, robots } = await import('./picture.mjs');

/** @typedef {import('../www/lesson/page.js').Live} Live */
/** @typedef {import('../www/lesson/steps.js').Step} Step */

/** What the page knows when a step is opened and its robots stand at the start. @param {Step} step @returns {Live} */
function opened(step) {
  const live = liveOf(step.link);
  /** @type {Live['state']} */
  const state = {
    ...live.state,
    slices: {
      ...live.state.slices,
      landscape: {
        ...landscapeSlice.of(live.state),
        get result() {
          return landscapeOf(state);
        },
      },
      disturbance: {
        ...disturbanceSlice.first,
        get measured() {
          return measuredOf({ ...live, state });
        },
      },
    },
  };
  return { ...live, state };
}

/** @param {Live['state']} state */
function landscapeOf(state) {
  const { experiment, preset } = state;
  const { x, y, third } = landscapeSlice.of(state);
  const spec = { experiment, x, y, range: linearRange[preset], third: third ?? 0 };
  const count = Math.max(...counts);
  const costs = landscape(experiment, askedOf(spec, count));
  return { spec, count, costs, milliseconds: 0 };
}

/** @param {Live} live */
function measuredOf({ engine, state, paper }) {
  const spec = createSpec(engine, paper)(state);
  const calm = remainingErrors(undisturbed(spec.experiment), spec.gains, spec.seconds);
  return { spec, runs: [], disturbed: calm, calm };
}

/** What is read of a step: all but what must be pressed. @param {Step} step @param {Live} live @param {number} number */
async function sectionOf(step, live, number) {
  const text = /** @type {any} */ (words.steps[step.name]);
  const section = create('section', '', create('h2', '', `${number}. ${first.titles[step.name]}`));
  for (const block of step.blocks) {
    if (block.kind === 'text') section.append(...paragraphs(text.texts[block.name], href));
    if (block.kind === 'formula')
      section.append(createFormula({ ...block.formula, numbers: undefined }).element);
    if (block.kind === 'notice') section.append(create('h3', '', words.notice), list(text.notice, href));
    if (block.kind === 'view' && block.isText) {
      const view = block.create(/** @type {any} */ (live), text, href);
      view.draw(live);
      // What it asks the engine for is there at once.
      await new Promise((resolve) => setImmediate(resolve));
      section.append(view.element);
    }
  }
  return section;
}

const href = (/** @type {string} */ link) => `#${link}`;

/** What is said in HTML; the rest is for who can press it. */
const kept = ['class', 'scope', 'role', 'aria-label', 'display', 'displaystyle', 'stretchy', 'accent'];

/** An element as it is read: with the values that its texts name, and without links, for none leads anywhere. @param {HTMLElement} element @param {Record<string, string>} values */
function written(element, values) {
  for (const part of element.querySelectorAll('[data-value]')) {
    const { value = '' } = /** @type {HTMLElement} */ (part).dataset;
    if (!(value in values)) throw new Error(`the article has no value for ${value}`);
    part.textContent = values[value];
  }
  for (const link of element.querySelectorAll('a')) link.replaceWith(...link.childNodes);
  for (const part of [element, ...element.querySelectorAll('*')])
    for (const name of part.getAttributeNames()) if (!kept.includes(name)) part.removeAttribute(name);
  return element.outerHTML;
}

/** @param {string} text */
const html = (text) => create('span', '', text).innerHTML;

/** @type {string[]} */
const sections = [];
for (const [i, step] of steps.entries()) {
  // The last one is about how to use the page in a class.
  if (step.name === 'lecturers') continue;
  const live = opened(step);
  const section = await sectionOf(step, live, i + 1);
  sections.push(written(section, step.values?.(live) ?? {}));
}

const [firstCost, bestCost] = [costs.first, costs.best].map(costText);
console.log(
  JSON.stringify({
    page: html(lab.texts.pageTitle),
    why: html(instead.waits),
    caption: html(instead.caption(robots, generations, firstCost, bestCost)),
    title: html(instead.article),
    note: html(instead.articleNote),
    lesson: sections.join(''),
  }),
);
