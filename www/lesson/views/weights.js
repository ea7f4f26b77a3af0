// The weights of J where the lesson speaks of them: the settings' own rows.
import { create } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { fieldPath, valueAt } from '../../run/paths.js';
import { asked } from '../../run/state.js';
import { createNumber } from '../../settings/rows.js';
import { table } from '../../settings/table.js';
import words from '../words/index.js';

/** @import { Block, Tools } from '../page.js' */

/** The part of J that a weight weighs. @param {string} path */
const partOf = (path) =>
  path.startsWith('weights.velocity')
    ? 'energy'
    : path.startsWith('weights.final')
      ? 'finalError'
      : 'penalty';

/** @param {Tools} tools @returns {Block} */
export function createWeights({ engine, actions }) {
  const fields = engine.fields();
  const rows = table.weights.map((row) => {
    const field = fields.find(({ path }) => path === fieldPath(row.path));
    if (!field) throw new Error(`weights: the core has no field ${row.path}`);
    const view = createNumber(row, field, actions, 0, 'lesson');
    view.element.dataset.term = partOf(row.path);
    return { path: row.path, ...view };
  });
  const isMain = (/** @type {{ path: string }} */ { path }) => partOf(path) === 'energy';
  const elementsOf = (/** @type {typeof rows} */ some) => some.map(({ element }) => element);
  const summary = create('summary', '', words.otherWeights);
  const others = create('details', '', summary, ...elementsOf(rows.filter((row) => !isMain(row))));
  const main = elementsOf(rows.filter(isMain));
  const element = create('fieldset', { id: 'weights', class: 'weights' }, ...main, others);
  const originalOf = remember(engine.experiment);
  const changed = watch();
  return {
    element,
    draw({ state }) {
      const { experiment, preset, settings } = asked(state);
      if (!changed(experiment, preset, settings.error)) return;
      for (const { path, draw } of rows)
        draw({
          experiment,
          value: valueAt(experiment, path),
          original: valueAt(originalOf(preset), path),
          error: settings.error?.path === path ? settings.error.text : '',
        });
    },
  };
}
