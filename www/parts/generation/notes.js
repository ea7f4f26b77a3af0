// What is said at the marks: names, the line of the cut, who crosses it the wrong way, and bouts.
/** @import { Place, Size } from './places.js' */
/** @import { PictureModel } from './picture.js' */
import { winsBout } from '../../core/rules.js';
import { svg } from '../../kit/elements.js';
import words from './words/index.js';
import { columnsOf, margin, orderOf } from './places.js';

/** More lines than that hide what they lead to. */
const mostBouts = 60;

/** The chosen one's bouts: who stands above its line has lost to it, who stands below has won. @param {PictureModel} model @param {Place[]} places @param {Size} size */
export function boutLines({ anatomy, chosen }, places, size) {
  const { record, all } = anatomy;
  const own = places[chosen];
  const met = [...new Set(record.opponents[chosen])].slice(0, mostBouts);
  const wins = (/** @type {number} */ opponent) => winsBout(all[chosen].cost, all[opponent].cost);
  return [
    svg('line', { x1: margin.left, x2: size.width - margin.right, y1: own.y, y2: own.y, class: 'level' }),
    ...met.map((opponent) => {
      const { x, y } = places[opponent];
      return svg('line', { x1: own.x, y1: own.y, x2: x, y2: y, class: wins(opponent) ? 'won' : 'lost' });
    }),
    ...met.map((opponent) => {
      const text = { ...besideBout(places[opponent], own), class: 'middle result' };
      return svg('text', text, wins(opponent) ? words.won : words.lost);
    }),
  ];
}

/** Where a bout's result stands: on the far side of the line that leads there. @param {Place} opponent @param {Place} own @returns {Place} */
const besideBout = ({ x, y }, own) => ({ x, y: y + (y <= own.y && y > 24 ? -9 : 17) });

/** The chosen one's ring and name, the line of the cut, and who crosses it the wrong way. @param {PictureModel} model @param {Place[]} places @param {Size} size */
export function notesOf(model, places, size) {
  const { anatomy, phase, chosen } = model;
  const { upset, counting, ranked } = anatomy;
  const notes = [];
  const ranking = phase === 'ranking';
  if (ranking) {
    const { x, step } = columnsOf(size, ranked);
    const cut = x(counting - 1) + step / 2;
    notes.push(
      svg('line', { x1: cut, x2: cut, y1: margin.top, y2: size.height - margin.bottom + 6, class: 'cut' }),
      svg('text', { x: cut - 8, y: margin.top + 4, class: 'end' }, words.stay(anatomy, counting)),
      svg('text', { x: cut + 8, y: margin.top + 4 }, words.fall(anatomy, ranked - counting)),
    );
  }
  const named = ranking && upset ? [upset.survivor, upset.fallen] : [];
  if (ranking && upset) {
    const [a, b] = named.map((number) => places[number]);
    notes.push(svg('line', { x1: a.x, y1: a.y, x2: b.x, y2: b.y, class: 'upset' }));
  }
  const marks =
    phase === 'tournament'
      ? tournamentMarks(model, places)
      : orderOf(anatomy, phase).map((number) => places[number]);
  for (const number of new Set([...named, chosen])) {
    const isLow = ranking && number === upset?.fallen;
    const name = words.nameOf(anatomy, number);
    const { x, y, side } = writingOf(places[number], marks, size, isLow, name);
    notes.push(svg('text', { x, y, class: `name ${side}` }, name));
    marks.push(...lettersOf({ x, y, side }, name));
  }
  return notes;
}

/** Of whom the chosen one meets, and what stands at them. @param {PictureModel} model @param {Place[]} places */
const tournamentMarks = ({ anatomy, chosen }, places) =>
  [...new Set(anatomy.record.opponents[chosen])].flatMap((opponent) => [
    places[opponent],
    besideBout(places[opponent], places[chosen]),
  ]);

/** Where a name stands, as if each letter were a mark: the next one leaves it alone. @param {Writing} writing @param {string} name @returns {Place[]} */
export const lettersOf = (writing, name) =>
  Array.from({ length: Math.ceil(widthOf(name) / 8) }, (_, i) => ({
    x: leftOf(writing, name) + 8 * i,
    y: writing.y - 4,
  }));

/** Roughly, in pixels: letters, and syllables of Korean. @param {string} name */
const widthOf = (name) => Array.from(name).reduce((sum, one) => sum + (one > '\u1100' ? 13 : 8), 0);

/** @typedef {{ x: number, y: number, side: 'begin' | 'middle' | 'end' }} Writing Where it is written, and which part of it stands there. */

/** Above and below the mark, to its right and left, from it to the right and left above and below, and beyond what stands there. @param {Place} own @param {Size} size @returns {Writing[]} */
function writingsBeside({ x, y }, { width }) {
  const side = x > width - 50 ? 'end' : x < margin.left + 40 ? 'begin' : 'middle';
  const line = (/** @type {number} */ down) => ({
    x: x + { end: 9, begin: -9, middle: 0 }[side],
    y: y + down,
    side: /** @type {Writing['side']} */ (side),
  });
  return [
    line(-15),
    line(24),
    { x: x + 15, y: y + 4, side: 'begin' },
    { x: x - 15, y: y + 4, side: 'end' },
    ...[24, -15].flatMap(
      (down) =>
        /** @type {Writing[]} */ ([
          { x: x - 7, y: y + down, side: 'begin' },
          { x: x + 7, y: y + down, side: 'end' },
        ]),
    ),
    line(-31),
    line(40),
  ];
}

/** @param {Writing} writing @param {string} name */
const leftOf = ({ x, side }, name) => x - { end: widthOf(name), begin: 0, middle: widthOf(name) / 2 }[side];

/** Where a name covers the fewest other marks. @param {Place} own @param {Place[]} marks @param {Size} size @param {boolean} isLow Not above the mark. @param {string} name @returns {Writing} */
export function writingOf(own, marks, size, isLow, name) {
  const width = widthOf(name);
  const writings = writingsBeside(own, size);
  const free = writings.filter((one) => {
    const left = leftOf(one, name);
    if (left < margin.left - 9 || left + width > size.width + 9) return false;
    return one.y >= (isLow ? own.y : 19) && one.y <= size.height - margin.bottom - 10;
  });
  const covered = free.map((one) => {
    const left = leftOf(one, name);
    const isCovered = (/** @type {Place} */ { x, y }) =>
      x > left - 7 && x < left + width + 7 && y > one.y - 16 && y < one.y + 9;
    return marks.filter(isCovered).length;
  });
  return free[covered.indexOf(Math.min(...covered))] ?? writings[1];
}
