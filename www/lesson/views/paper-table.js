// What the paper reports beside what its gains and our own evolution come to here; and what it states, and what we chose.
import { create } from '../../kit/elements.js';
import { inline } from '../prose.js';
import { lab } from '../../words/index.js';
import { degreesText, fixed, postureText } from '../../words/numbers.js';

/** @import { Engine, Experiment, Individual, PaperResult } from '../../core/engine.js' */
/** @import { Block, Tools } from '../page.js' */

const generations = 200;
const presets = /** @type {const} */ (['velocity-limits', 'acceleration-limits']);

/** @param {'col' | 'row'} scope @param {(Node | string)[]} content */
const headCell = (scope, ...content) => create('th', { scope }, ...content);

/** Heads above and before cells. @param {string} className @param {readonly string[]} head @param {(Node | string)[][]} rows */
export function tableOf(className, head, rows) {
  // A corner that names nothing heads no column.
  const heads = head.map((text) => (text ? headCell('col', ...inline(text, String)) : create('td', '')));
  const body = rows.map(([first, ...rest]) =>
    create('tr', '', headCell('row', first), ...rest.map((content) => create('td', '', content))),
  );
  const headRow = create('thead', '', create('tr', '', ...heads));
  return create('table', className, headRow, create('tbody', '', ...body));
}

/** On a small screen, also by keyboard. @param {HTMLElement} table */
function scrolling(table) {
  return create('div', { class: 'lesson-scroll', tabindex: 0 }, table);
}

const gainsText = (/** @type {readonly number[]} */ gains) => gains.map((gain) => fixed(gain, 2)).join(', ');

/** @type {WeakMap<Engine, Promise<Individual[]>>} */
const known = new WeakMap();

/** What evolution finds with the first seed, in each preset; where it could not be found it is asked for anew. @param {Engine} engine */
export function foundBy(engine) {
  const asked = known.get(engine) ?? engine.surveys.evolveAll(presets.map(engine.experiment), generations);
  known.set(engine, asked);
  asked.catch(() => known.delete(engine));
  return asked;
}

/** @param {Tools} tools @param {any} words @returns {Block} */
export function createPaperTable({ engine }, words) {
  const box = scrolling(create('table', ''));
  const element = create('div', { id: 'paper-table' }, box);
  let isDrawn = false;
  const draw = (/** @type {PaperResult[]} */ paper, /** @type {Individual[]} */ found) => {
    const rows = paper.map(({ preset, figure, method, gains, cost }) => {
      const [run] = engine.drive(engine.experiment(preset), [gains]);
      return [words.row(figure, method), gainsText(gains), String(cost), lab.costText(run.cost.total)];
    });
    for (const i of presets.keys()) {
      const best = found.at(i);
      rows.splice(3 * i + 2, 0, [
        words.ours(generations),
        best ? gainsText(best.gains) : '…',
        '',
        best ? lab.costText(best.cost) : '…',
      ]);
    }
    // Who is in it, or has scrolled it, stays there.
    const table = tableOf('lesson-table ruled', words.head, rows);
    // It stands right below the heading of its step.
    table.setAttribute('aria-labelledby', 'lesson-title');
    box.replaceChildren(table);
  };
  return {
    element,
    draw({ paper }) {
      if (isDrawn) return;
      isDrawn = true;
      draw(paper, []);
      foundBy(engine)
        .then((found) => draw(paper, found))
        // Without workers the rows of our own stay open.
        .catch(() => {});
    },
  };
}

/** @param {Tools} tools @param {any} words @returns {Block} */
export function createChoicesTable({ engine }, words) {
  const e = engine.experiment('velocity-limits');
  const a = engine.experiment('acceleration-limits');
  /** @type {string[][]} */
  const texts = words.choices(textsOf(e, a));
  const rows = texts.map((row) => row.map((text) => create('span', '', ...inline(text, String))));
  const table = tableOf('lesson-table ruled choices-table', words.choicesHead, rows);
  const element = create('section', '', create('h3', '', words.choicesTitle), scrolling(table));
  table.setAttribute('aria-label', words.choicesTitle);
  return { element, draw() {} };
}

/** The choices as the core has them. @param {Experiment} e @param {Experiment} a */
const textsOf = (e, a) => ({
  start: postureText(e.starts[0]),
  goal: postureText(e.goal),
  speed: fixed(e.limits.speed ?? 0, 0),
  turnRate: fixed((e.limits.turnRate ?? 0) / Math.PI, 0),
  acceleration: fixed(a.limits.acceleration ?? 0, 0),
  turnAcceleration: fixed((a.limits.turnAcceleration ?? 0) / Math.PI, 0),
  weights: e.weights.final.map(String).join(', '),
  velocityWeights: e.weights.velocity.map(String).join(', '),
  penalty: String(e.weights.penalty),
  position: fixed(100 * e.tolerance.position, 0),
  heading: degreesText(e.tolerance.heading),
  horizon: fixed(e.horizon, 0),
  population: String(e.evolution.population),
  opponents: String(e.evolution.opponents),
  range: e.evolution.initialRange.map(String),
  sigma: String(e.evolution.initialSigma),
  sampleTime: String(e.sampleTime),
});
