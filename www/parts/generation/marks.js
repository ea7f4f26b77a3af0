// The individuals of the picture as marks, and the lines between parents and offspring.
/** @import { Place } from './places.js' */
/** @import { PictureModel } from './picture.js' */
import { forgets, hasPairs } from '../../core/methods.js';
import { svg } from '../../kit/elements.js';
import { trialOf } from './record.js';

/** More than that move too slowly, and nobody can follow them: they have no elements of their own. */
const mostMoving = 400;

/** @param {PictureModel} model */
export const isCrowd = ({ anatomy }) => anatomy.all.length > mostMoving;

/** How many parents have an offspring of their own. @param {PictureModel['anatomy']} anatomy */
const pairedIn = ({ count, record, method }) =>
  hasPairs(method) && record.offspring.length === count ? count : 0;

/** As many elements as there are things. @param {Element} layer @param {number} count @param {string} name @param {Record<string, string>} attributes */
function fill(layer, count, name, attributes) {
  if (layer.firstElementChild?.localName !== name) layer.replaceChildren();
  while (layer.childElementCount > count) layer.lastElementChild?.remove();
  while (layer.childElementCount < count) layer.append(svg(name, attributes));
}

/** @typedef {{ marks: Element, twins: Element, pairs: Element }} Layers */

/** @param {Layers} layers @param {PictureModel} model */
export function prepare({ marks, pairs }, model) {
  if (isCrowd(model)) return;
  fill(marks, model.anatomy.all.length, 'circle', { class: 'mark' });
  fill(pairs, pairedIn(model.anatomy), 'line', { x2: '1', y2: '1', class: 'pair' });
}

/** @param {Layers} layers @param {PictureModel} model @param {Place[]} places @param {Place[] | null} seenAgain From another side. @param {number} radius */
export function show({ marks, twins, pairs }, model, places, seenAgain, radius) {
  if (isCrowd(model)) {
    marks.replaceChildren(...crowdOf(model, places, radius));
    pairs.replaceChildren(crowdOfPairs(model, places));
    twins.replaceChildren(...(seenAgain ? crowdOf(model, seenAgain, radius) : []));
    return;
  }
  dress(marks, model, radius);
  for (const [number, mark] of [...marks.children].entries()) mark.id = `individual-${number}`;
  place(marks, places);
  join(pairs, places, model.anatomy.count);
  fill(twins, seenAgain?.length ?? 0, 'circle', { class: 'mark' });
  if (!seenAgain) return;
  dress(twins, model, radius);
  place(twins, seenAgain);
}

/** @param {Element} marks @param {Place[]} places */
export function place(marks, places) {
  for (const [i, mark] of [...marks.children].entries()) moveTo(/** @type {SVGElement} */ (mark), places[i]);
}

/** @param {SVGElement} element @param {Place} place */
export function moveTo(element, { x, y }) {
  element.style.transform = `translate(${x}px, ${y}px)`;
}

/** The lines from parents to offspring. @param {Element} pairs @param {Place[]} places @param {number} count */
function join(pairs, places, count) {
  for (const [i, pair] of [...pairs.children].entries()) {
    const [from, to] = [places[i], places[i + count]];
    const [dx, dy] = [to.x - from.x, to.y - from.y].map((d) => (Math.abs(d) < 0.01 ? 0.01 : d));
    /** @type {SVGElement} */ (pair).style.transform =
      `translate(${from.x}px, ${from.y}px) scale(${dx}, ${dy})`;
  }
}

/** Says by classes what each mark is in this phase. @param {Element} marks @param {PictureModel} model @param {number} radius */
function dress(marks, model, radius) {
  const classOf = classesIn(model);
  for (const [number, mark] of [...marks.children].entries()) {
    mark.setAttribute('r', String(radiusOf(number, model, radius)));
    mark.setAttribute('class', classOf(number));
  }
}

/** As long a text as one can see. @param {number} pixels */
const tenth = (pixels) => Math.round(10 * pixels) / 10;

/** All that look alike are one outline. @param {PictureModel} model @param {Place[]} places @param {number} radius */
function crowdOf(model, places, radius) {
  const classOf = classesIn(model);
  /** @type {Map<string, string>} */
  const outlines = new Map();
  for (const [number, { x, y }] of places.entries()) {
    const kind = classOf(number);
    const r = tenth(radiusOf(number, model, radius));
    const outline = `M${tenth(x - r)} ${tenth(y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0z`;
    outlines.set(kind, (outlines.get(kind) ?? '') + outline);
  }
  return [...outlines].map(([kind, d]) => svg('path', { class: kind, d }));
}

/** @param {PictureModel} model @param {Place[]} places */
function crowdOfPairs(model, places) {
  const { count } = model.anatomy;
  const lines = Array.from({ length: pairedIn(model.anatomy) }, (_, i) => {
    const [from, to] = [places[i], places[i + count]];
    return `M${tenth(from.x)} ${tenth(from.y)}L${tenth(to.x)} ${tenth(to.y)}`;
  });
  return svg('path', { class: 'pair', d: lines.join('') });
}

/** @param {number} number @param {PictureModel} model @param {number} radius */
const radiusOf = (number, { chosen }, radius) => (number === chosen ? Math.max(5, radius * 1.25) : radius);

/** Who has to do with the chosen one in a phase; null: all. @param {PictureModel['anatomy']} anatomy @param {PictureModel['phase']} phase @param {number} chosen */
function concerned(anatomy, phase, chosen) {
  const { record, count, method } = anatomy;
  if (phase === 'tournament') return new Set(record.opponents[chosen]);
  if (phase !== 'mutation' || method !== 'de') return null;
  const own = trialOf(anatomy, chosen);
  return new Set([own, own + count, ...record.donors[own]]);
}

/** @param {PictureModel} model @returns {(number: number) => string} */
function classesIn({ anatomy, phase, chosen }) {
  const { count, staying, counting, ranks, record, method } = anatomy;
  const met = concerned(anatomy, phase, chosen);
  const forgotten = forgets(method) && record.offspring.length > 0 && phase !== 'parents';
  return (number) => {
    const isParent = number < count;
    const isFallen = ranks[number] >= staying;
    let name = isParent ? 'mark parent' : 'mark offspring';
    if (!isParent && phase === 'mutation') name += ' undriven';
    if (!isParent && phase === 'parents') name += ' unborn';
    if (isParent && forgotten) name += ' gone';
    if (met !== null && number !== chosen && !met.has(number)) name += ' faint';
    if (ranks[number] >= counting && phase === 'ranking') name += ' fallen';
    if (isFallen && phase === 'survivors') name += number === chosen ? ' falls' : ' gone';
    return number === chosen ? `${name} chosen` : name;
  };
}
