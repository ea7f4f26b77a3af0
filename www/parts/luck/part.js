// The same evolution with many seeds.
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { partKey } from '../../link/keys.js';
import { PartlyRead } from '../../link/together.js';
import { number, numberText, oneNumberOf, oneOf, wholeNumber } from '../../link/values.js';
import { link as words } from '../../words/index.js';
import { contestants, mostOthers } from './contestants.js';
import { budgets, contestSeeds, counts, lengths, luckSlice as slice, readings, views } from './state.js';
import { load as loadWords } from './words/load.js';

/** Each once, and no more than there is room for. @param {string} text */
function othersOf(text) {
  if (text === 'none') return [];
  const named = [...new Set(text.split(',').map((name) => oneOf(contestants, name)))];
  const others = named.slice(0, mostOthers);
  if (named.length === others.length) return others;
  throw new PartlyRead(words.expected(words.namesUpTo(mostOthers), text), others);
}

/** So many times nobody asks for other seeds. */
const mostDraws = 1e6;

/** One at least. @param {string} text @param {number} most */
const countOf = (text, most) => Math.max(1, wholeNumber(text, most));

/** @type {Part} */
export const luck = {
  name: 'luck',
  called: {
    en: {
      name: 'Luck',
      purpose:
        'The same search with many seeds: how much of a result is luck, and which part or rival does better?',
    },
    ko: {
      name: '운',
      purpose:
        '여러 시드로 같은 탐색을 반복합니다. 결과의 어디까지가 운이고, 어떤 구성 요소나 경쟁 방법이 더 나을까요?',
    },
  },
  slice,
  keys: [
    partKey('luck', slice, 'view', (text) => oneOf(views, text)),
    partKey('contestants', slice, 'others', othersOf, (others) => others.join(',') || 'none'),
    partKey('seeds', slice, 'seeds', (text) => oneNumberOf(contestSeeds, text)),
    partKey('budget', slice, 'budget', (text) => oneNumberOf(budgets, text)),
    partKey('target', slice, 'target', number, numberText),
    partKey('reading', slice, 'reading', (text) => oneOf(readings, text)),
    partKey('until', slice, 'until', (text) => countOf(text, Math.max(...budgets)), String),
    partKey('only', slice, 'only', (text) => countOf(text, Math.max(...contestSeeds)), String),
    partKey('draw', slice, 'draw', (text) => wholeNumber(text, mostDraws)),
    partKey('runs', slice, 'count', (text) => oneNumberOf(counts, text)),
    partKey('length', slice, 'generations', (text) => oneNumberOf(lengths, text)),
  ],
  places: {
    gains: { lock: '#luck-rank' },
    run: { lock: '#luck-run, #contest-run', hide: '.luck-bar, .contest-bar' },
    seed: { lock: '#luck-open', hide: '#luck-open' },
  },
  room: 'plane',
  figure: [0.7, 640],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
