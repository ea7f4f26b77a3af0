// J and its parts.
import { watch } from '../kit/memo.js';
import { lab as strings } from '../words/index.js';

/** @typedef {import('../core/engine.js').Run} Run */
/** @typedef {{ title: string, run: Run, note: string }} CostModel */
/** @typedef {{ title: HTMLElement, total: HTMLElement, outcome: HTMLElement, note: HTMLElement, bar: HTMLElement, parts: HTMLElement }} CostElements */

/** @param {CostElements} elements */
export function createCost({ title, total, outcome, note, bar, parts }) {
  const rows = strings.costParts.map(([part, name]) => {
    const segment = document.createElement('span');
    const item = document.createElement('li');
    const value = document.createElement('span');
    segment.className = `cost-segment part-${part}`;
    segment.dataset.term = part;
    item.dataset.term = part;
    item.className = `part-${part}`;
    value.className = 'cost-value';
    value.id = `cost-${part}`;
    item.append(`${name} `, value);
    return { part, segment, item, value };
  });
  bar.replaceChildren(...rows.map(({ segment }) => segment));
  parts.replaceChildren(...rows.map(({ item }) => item));
  const changed = watch();

  return {
    /** @param {CostModel} model */
    draw(model) {
      if (!changed(model.title, model.run, model.note)) return;
      const { cost } = model.run;
      const finite = Number.isFinite(cost.total);
      title.textContent = model.title;
      total.textContent = strings.costText(cost.total);
      outcome.textContent = strings.outcomeText(model.run);
      note.textContent = model.note;
      for (const { part, segment, item, value } of rows) {
        value.textContent = strings.partText(cost[part]);
        segment.style.flexGrow = finite ? String(cost[part] / cost.total) : '0';
        // What only gains below zero pay is left out while nobody pays it.
        item.hidden = part === 'penalty' && cost.penalty === 0;
        segment.hidden = !finite || cost[part] < 0.004 * cost.total;
      }
    },
  };
}
