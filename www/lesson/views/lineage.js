// From whom the best robot descends: for each ancestor the bell from which its offspring's gain was drawn, from the first one down.
import { ticks } from 'd3-array';
import { scaleLinear } from 'd3-scale';
import { html, render, svg } from 'lit-html';
import { ticksOn } from '../../kit/chart.js';
import { create } from '../../kit/elements.js';
import { followSize } from '../../kit/size.js';
import { watch } from '../../kit/memo.js';
import { styled } from '../../kit/templates.js';
import { sameDigits } from '../../kit/steps.js';
import { shapes } from '../../parts/generation/bell.js';
import { isInitial } from '../../parts/generation/record.js';
import { isOtherSearch } from '../../parts/generation/state.js';
import { lab } from '../../words/index.js';

/** @import { Experiment, GenerationRecord, Individual, Statistics } from '../../core/engine.js' */
/** @import { Block, Live, Tools } from '../page.js' */
/** @typedef {{ born: number, individual: Individual }} Ancestor */
/** @typedef {{ lineage: { title: (generation: number, count: number, first?: number) => string, axis: string, sigma: (first: number, last: number) => string, label: (gain: string, family: readonly Ancestor[], i: number) => string, other: string } }} LineageWords */

/** So far back at the most: before that nothing would be seen of each. */
const mostGenerations = 500;
/** Longer than this nobody waits for a frame; the rest comes with the next one. */
const mostMilliseconds = 12;
/** Of the picture, as if it were so high; bells overlap as hills do. */
const height = 300;
const hill = 26;
const reach = 3;
/** Pixels left of the columns and between them, as in the styles. */
const aside = 78;
/** Of the numbers below, pixels: a digit at the most, and what lies between two. */
const digit = 8.3;
const between = 8;

/**
 * The best robot of a generation and its ancestors, the oldest first: whoever bore whom.
 * @param {(generation: number) => GenerationRecord} recordOf @param {number} generation @returns {Ancestor[]}
 */
export function lineageOf(recordOf, generation) {
  /** @type {Ancestor[]} */
  const family = [];
  const first = Math.max(0, generation - mostGenerations);
  let record = recordOf(generation);
  const every = [...record.parents, ...record.offspring];
  let number = record.survivors.reduce((a, b) => (every[b].cost < every[a].cost ? b : a));
  for (;;) {
    const count = record.parents.length;
    const isBorn = number >= count;
    if (isBorn || record.generation === first) {
      const individual = isBorn ? record.offspring[number - count] : record.parents[number];
      family.unshift({ born: record.generation, individual });
    }
    if (record.generation === first) return family;
    record = recordOf(record.generation - 1);
    number = record.survivors[isBorn ? number - count : number];
  }
}

/** Records that are asked for once, as many in a frame as there is time for; of a search without families the newest is enough. @param {Pick<Tools, 'engine' | 'store'>} tools */
export function createRecords({ engine, store }) {
  /** @type {WeakMap<Statistics, GenerationRecord>} */
  const known = new WeakMap();
  return (
    /** @type {readonly Statistics[]} */ history,
    /** @type {number} */ generation,
    /** @type {Experiment} */ experiment,
  ) => {
    const end = performance.now() + mostMilliseconds;
    const recordOf = (/** @type {number} */ g) => {
      const record = known.get(history[g]) ?? engine.record(g, experiment);
      known.set(history[g], record);
      return record;
    };
    const first = isOtherSearch(recordOf(generation))
      ? generation
      : Math.max(0, generation - mostGenerations);
    for (let g = generation - 1; g >= first; g -= 1) {
      if (known.has(history[g])) continue;
      if (performance.now() > end) {
        store.redraw();
        return null;
      }
      recordOf(g);
    }
    return recordOf;
  };
}

/** @param {Tools} tools @param {LineageWords} words @returns {Block} */
export function createLineage(tools, { lineage: words }) {
  const element = create('div', { id: 'lineage', class: 'lineage' });
  const recordsOf = createRecords(tools);
  const sizeOf = followSize(element, () => tools.store.redraw());
  const changed = watch();

  return {
    element,
    draw(/** @type {Live} */ { state: { experiment, history, generation } }) {
      const recordOf = recordsOf(history, generation, experiment);
      const wide = (sizeOf().width - aside) / 3;
      // How wide it is comes a frame later.
      if (!recordOf || wide <= 0 || !changed(history[generation], wide)) return;
      const newest = recordOf(generation);
      render(
        isOtherSearch(newest)
          ? html`<p class="muted">${words.other}</p>`
          : picture(
              lineageOf(recordOf, generation),
              isInitial(newest) ? 0 : generation,
              experiment,
              wide,
              words,
            ),
        element,
      );
    },
  };
}

/** @param {readonly Ancestor[]} family @param {number} generation @param {Experiment} experiment @param {number} wide A column, in pixels. @param {LineageWords['lineage']} words */
function picture(family, generation, { evolution }, wide, words) {
  const first = family[0].born;
  const share = (/** @type {number} */ born) =>
    generation > first ? (born - first) / (generation - first) : 0;
  const marks = ticks(first, generation, 5).filter(Number.isInteger);
  return html`
    <p class="lineage-title">${words.title(generation, family.length, first)}</p>
    <div class="lineage-columns">
      <span class="lineage-name" aria-hidden="true">${words.axis}</span>
      <div class="lineage-axis" aria-hidden="true">${marks.map((mark) => html`<span ${styled('--at', String(downAt(share(mark)) / height))}>${mark}</span>`)}</div>
      ${lab.gains.map((gain, i) => column(gain, i, family, { share, wide, density: shapes[evolution.step].density }, words))}
    </div>`;
}

/** How far down the picture, with room for the first hill. @param {number} share */
const downAt = (share) => hill + 4 + share * (height - hill - 10);

/** @param {typeof lab.gains[number]} gain @param {number} i @param {readonly Ancestor[]} family @param {{ share: (born: number) => number, wide: number, density: (draw: number) => number }} drawn @param {LineageWords['lineage']} words */
function column({ id, name, letter, index }, i, family, { share, wide, density }, words) {
  const [low, high] = rangeOf(family, i);
  const x = (/** @type {number} */ gain) => (100 * (gain - low)) / (high - low);
  const spots = family.map(({ born, individual: { gains } }) => ({ x: x(gains[i]), y: downAt(share(born)) }));
  const sigmaOf = (/** @type {Ancestor | undefined} */ one) => one?.individual.sigmas[i] ?? 0;
  return html`<figure class=${id}>
    <figcaption class="row"><span translate="no" class="symbol ${id}" lang="en">${letter}<sub>${index}</sub></span>
      <span class="muted">${words.sigma(sigmaOf(family[0]), sigmaOf(family.at(-1)))}</span></figcaption>
    <svg viewBox="0 0 100 ${height}" preserveAspectRatio="none" role="img" aria-label=${words.label(name, family, i)}>
      ${family.map(({ individual: { gains, sigmas } }, n) => svg`<path class="hill" d=${hillOf(gains[i], sigmas[i], spots[n].y, x, density)}></path>`)}
      <polyline points=${spots.map((spot) => `${spot.x},${spot.y}`).join(' ')}></polyline>
    </svg>
    <div class="lineage-ticks" aria-hidden="true">${numbersBelow([low, high], wide).map(({ at, text }) => html`<span ${styled('--at', String(at))}>${text}</span>`)}</div>
  </figure>`;
}

/**
 * Numbers below a column: none touches another, or the next column, and where they are too wide for that there are fewer.
 * @param {readonly [number, number]} range @param {number} wide The column, in pixels. @returns {{ at: number, text: string }[]}
 */
export function numbersBelow(range, wide) {
  const x = scaleLinear(range, [0, wide]);
  const within = (/** @type {number} */ space) => {
    const all = ticksOn(x, space, { factors: [1, 2, 5] });
    const texts = sameDigits(all);
    return all
      .map((tick, i) => ({ at: x(tick) / wide, text: texts[i], width: digit * texts[i].length + between }))
      .filter(({ at, width }) => Math.min(at, 1 - at) * wide >= width / 2 - between);
  };
  const apart = (/** @type {ReturnType<typeof within>} */ some) =>
    some.every(
      ({ at, width }, i) => i === 0 || (at - some[i - 1].at) * wide >= (width + some[i - 1].width) / 2,
    );
  const fitting = [28, 40, 56, 80].map(within).find((some) => some.length > 1 && apart(some));
  if (fitting) return fitting;
  const close = within(12);
  return close.map((_, n) => close.filter((_, i) => i % (n + 1) === 0)).find(apart) ?? [];
}

/** Where gains are likely to land, of all ancestors. @param {readonly Ancestor[]} family @param {number} i @returns {[number, number]} */
function rangeOf(family, i) {
  const ends = family.flatMap(({ individual: { gains, sigmas } }) => [
    gains[i] - 2 * sigmas[i],
    gains[i] + 2 * sigmas[i],
  ]);
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  return high > low ? [low, high] : [low - 1, high + 1];
}

/** The density of k + σ N, or of k + σ C, on a line. @param {number} gain @param {number} sigma @param {number} y @param {(gain: number) => number} x @param {(draw: number) => number} density */
function hillOf(gain, sigma, y, x, density) {
  const points = Array.from({ length: 33 }, (_, n) => {
    const draw = reach * (n / 16 - 1);
    return `${x(gain + sigma * draw).toFixed(2)} ${(y - hill * density(draw)).toFixed(1)}`;
  });
  return `M${points.join('L')}`;
}
