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
    const isLow = places[number].y < 34 || (ranking && number === upset?.fallen);
    const below = isLow || isFreerBelow(places[number], marks, size);
    notes.push(nameAt(places[number], below, size, words.nameOf(anatomy, number)));
  }
  return notes;
}

/** Of whom the chosen one meets, and what stands at them. @param {PictureModel} model @param {Place[]} places */
const tournamentMarks = ({ anatomy, chosen }, places) =>
  [...new Set(anatomy.record.opponents[chosen])].flatMap((opponent) => [
    places[opponent],
    besideBout(places[opponent], places[chosen]),
  ]);

/** How far a name reaches to both sides, and up or down. */
const [reach, [nearest, farthest]] = [54, [6, 34]];

/** Whether a name has more room below its mark than above. @param {Place} own @param {Place[]} marks @param {Size} size */
function isFreerBelow(own, marks, { height }) {
  if (own.y + farthest > height - margin.bottom) return false;
  const beside = marks.filter(({ x }) => Math.abs(x - own.x) < reach);
  /** @param {number} side */
  const onSide = (side) =>
    beside.filter(({ y }) => side * (y - own.y) > nearest && side * (y - own.y) < farthest).length;
  return onSide(1) < onSide(-1);
}

/** @param {Place} place @param {boolean} below Its mark, instead of above. @param {Size} size @param {string} name */
function nameAt({ x, y }, below, size, name) {
  const side = x > size.width - 50 ? 'end' : x < margin.left + 40 ? 'begin' : 'middle';
  const beside = { end: 9, begin: -9, middle: 0 }[side];
  return svg('text', { x: x + beside, y: below ? y + 24 : y - 15, class: `name ${side}` }, name);
}
