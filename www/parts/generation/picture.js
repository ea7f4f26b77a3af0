// The picture of a generation: every individual is a mark. Its height is its J; or it lies where its gains are, seen from two sides.
/** @import { Place, Size } from './places.js' */
/** @import { Anatomy, Phase } from './record.js' */
import { svg, tellValue } from '../../kit/elements.js';
import { followSize } from '../../kit/size.js';
import { isChord } from '../../kit/keyboard.js';
import { watch } from '../../kit/memo.js';
import words from './words/index.js';
import { drawCostAxis } from './cost-axis.js';
import { drawGainAxes, drawSketch, gainPlaces, sidesOf } from './gain-view.js';
import { isCrowd, moveTo, place, prepare, show as showMarks } from './marks.js';
import { boutLines, notesOf } from './notes.js';
import { shownIn } from './phases.js';
import { orderOf, placesOf, radiusOf } from './places.js';

/** @typedef {{ anatomy: Anatomy, phase: Phase, chosen: number, still: boolean }} PictureModel Still: nobody has asked for motion. */
/** @typedef {{ model: PictureModel, size: Size, places: Place[], twins: Place[] | null }} Drawn Twins: the same from another side. */

/** How far from its middle a mark is hit, and how far beside it its column reaches, in pixels. */
const [hitRadius, columnReach] = [14, 40];

/** @param {HTMLElement} element The part. @param {{ onChoose: (number: number) => void }} on */
export function createPicture(element, { onChoose }) {
  const root = /** @type {HTMLElement} */ (element.querySelector('#generation-picture'));
  const show = createDrawing(root);
  const changed = watch();
  /** @type {Drawn | null} */
  let drawn = null;
  /** @type {PictureModel | null} */
  let latest = null;
  let isDue = false;
  /** @param {Size} size */
  const draw = (size) => {
    isDue = false;
    if (latest && size.width > 0) drawn = show(latest, size, drawn);
  };
  const sizeOf = followSize(root, (size) => {
    if (!isDue && !(drawn?.model === latest && isSame(drawn.size, size))) draw(size);
  });
  /** A crowd has a frame of its own: its details may change its size, of which one is told only after that, and it is not to be drawn twice. */
  const drawNext = () => {
    if (!isDue) requestAnimationFrame(() => draw({ width: root.clientWidth, height: root.clientHeight }));
    isDue = true;
  };

  root.addEventListener('click', (event) => {
    if (!drawn) return;
    const { left, top } = root.getBoundingClientRect();
    const number = pressed(drawn, event.clientX - left, event.clientY - top);
    if (number !== null) onChoose(number);
  });
  // Keys can be quicker than frames.
  let chosen = 0;
  root.addEventListener('keydown', (event) => {
    if (!drawn || isChord(event)) return;
    const { anatomy, phase } = drawn.model;
    const number = stepped(orderOf(anatomy, phase), chosen, event.key);
    if (number === null) return;
    event.preventDefault();
    chosen = number;
    onChoose(number);
  });

  return {
    /** @param {PictureModel} model */
    draw(model) {
      ({ chosen } = model);
      if (!changed(model.anatomy, model.phase, model.chosen)) return;
      latest = model;
      if (isCrowd(model)) drawNext();
      else draw(sizeOf());
    },
  };
}

/** @param {Size} a @param {Size} b */
const isSame = (a, b) => a.width === b.width && a.height === b.height;

/** @param {HTMLElement} root @returns {(model: PictureModel, size: Size, drawn: Drawn | null) => Drawn} What draws after what it has drawn before. */
function createDrawing(root) {
  const picture = svg('svg', { 'aria-hidden': 'true' });
  const layers = ['axis', 'sketch', 'pairs', 'bouts', 'marks', 'twins', 'notes'].map((name) =>
    svg('g', { class: name }),
  );
  const [axis, sketch, pairs, bouts, marks, twins, notes] = layers;
  const [ring, twin] = [0, 1].map(() => svg('circle', { class: 'ring' }));
  picture.append(...layers, ring, twin);
  root.append(picture);
  return (model, size, drawn) => {
    const { anatomy, phase, chosen } = model;
    const sides = shownIn(anatomy.method, phase) === 'gains' ? sidesOf(anatomy, size) : null;
    const [places, seenAgain] = sides
      ? sides.map((side) => gainPlaces(anatomy, phase, side))
      : [placesOf(anatomy, phase, size), null];
    picture.setAttribute('viewBox', `0 0 ${size.width} ${size.height}`);
    prepare({ marks, twins, pairs }, model);
    const before = succeeded(drawn, anatomy);
    const moves = before || (drawn?.model.anatomy === anatomy && drawn.model.phase !== phase);
    const still = model.still || !moves || isCrowd(model) || drawn?.size !== size;
    root.classList.add('still');
    if (before && !still) place(marks, before);
    // What moves sets out from where it stands by now.
    if (!still) root.getBoundingClientRect();
    root.classList.toggle('still', still);
    root.dataset.phase = phase;
    root.dataset.shows = sides ? 'gains' : 'costs';
    const radius = radiusOf(size, anatomy.columns);
    showMarks({ marks, twins, pairs }, model, places, seenAgain, radius);
    if (sides) {
      drawGainAxes(axis, sides);
      drawSketch(sketch, sides, anatomy, phase, chosen);
    } else {
      drawCostAxis(axis, model, size);
      sketch.replaceChildren();
    }
    bouts.replaceChildren(...(phase === 'tournament' ? boutLines(model, places, size) : []));
    notes.replaceChildren(...notesOf(model, places, size));
    for (const [circle, there] of /** @type {const} */ ([
      [ring, places],
      [twin, seenAgain],
    ])) {
      circle.setAttribute('r', String(Math.max(9, radius * 1.25 + 4)));
      circle.toggleAttribute('hidden', !there);
      if (there) moveTo(circle, there[chosen]);
    }
    describe(root, model);
    return { model, size, places, twins: seenAgain };
  };
}

/** Where the parents stood as survivors of the generation before, if that was shown. @param {Drawn | null} drawn @param {Anatomy} anatomy @returns {Place[] | null} */
function succeeded(drawn, { record, all }) {
  if (drawn?.model.phase !== 'survivors') return null;
  const { record: old } = drawn.model.anatomy;
  const follows = old.generation + 1 === record.generation && old.survivors.length === record.parents.length;
  return follows ? all.map((_, i) => drawn.places[old.survivors[i % record.parents.length]]) : null;
}

/** The one that a key leads to. @param {number[]} order @param {number} chosen @param {string} key */
function stepped(order, chosen, key) {
  const last = order.length - 1;
  const at = order.indexOf(chosen);
  const to = {
    ArrowRight: at + 1,
    ArrowUp: at + 1,
    ArrowLeft: at - 1,
    ArrowDown: at - 1,
    PageUp: at + 10,
    PageDown: at - 10,
    Home: 0,
    End: last,
  }[key];
  return to === undefined ? null : order[Math.max(0, Math.min(last, to))];
}

/** The mark in sight that is hit, or else that of the column, however high; if there is one. @param {Drawn} drawn @param {number} x @param {number} y */
function pressed({ model, places, twins }, x, y) {
  const order = orderOf(model.anatomy, model.phase);
  /** @param {number} number @param {number} height How much it counts how far above or below. */
  const distance = (number, height) =>
    Math.min(
      ...[places, twins ?? places].map((all) => Math.hypot(all[number].x - x, height * (all[number].y - y))),
    );
  const nearest = (/** @type {number} */ height) =>
    order.reduce((a, b) => (distance(b, height) < distance(a, height) ? b : a));
  const hit = nearest(1);
  if (distance(hit, 1) < hitRadius) return hit;
  const inColumn = nearest(0.01);
  return distance(inColumn, 0) < columnReach ? inColumn : null;
}

/** For who does not see it. @param {HTMLElement} root @param {PictureModel} model */
function describe(root, { anatomy, phase, chosen }) {
  const order = orderOf(anatomy, phase);
  const place = Math.max(1, order.indexOf(chosen) + 1);
  tellValue(root, 1, order.length, place, words.chosenText(anatomy, phase, chosen));
}
