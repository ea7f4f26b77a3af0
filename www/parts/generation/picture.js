// The picture of a generation: every individual is a mark that keeps its height, its J, through all phases.
/** @import { Place, Size } from './places.js' */
/** @import { Anatomy, Phase } from './record.js' */
import { winsBout } from '../../core/rules.js';
import { tickStep, ticks as ticksOf } from 'd3-array';
import { followSize, svg } from '../../kit/elements.js';
import { isChord } from '../../kit/keyboard.js';
import { sameDigits } from '../../kit/chart.js';
import { watch } from '../../kit/memo.js';
import words from './words/index.js';
import { isCrowd, moveTo, place, prepare, show as showMarks } from './marks.js';
import { columnsOf, heightOf, margin, orderOf, placesOf, radiusOf } from './places.js';
import { isInitial } from './record.js';

/** @typedef {{ anatomy: Anatomy, phase: Phase, chosen: number, still: boolean }} PictureModel Still: nobody has asked for motion. */
/** @typedef {{ model: PictureModel, size: Size, places: Place[] }} Drawn */

/** More lines than that hide what they lead to. */
const mostBouts = 60;

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
  const draw = () => {
    const size = sizeOf();
    isDue = false;
    if (latest && size.width > 0) drawn = show(latest, size, drawn);
  };
  const sizeOf = followSize(root, () => {
    if (!isDue) draw();
  });
  /** A crowd has a frame of its own: its details may change its size, and it is not to be drawn twice. */
  const drawNext = () => {
    if (!isDue) requestAnimationFrame(draw);
    isDue = true;
  };

  root.addEventListener('click', (event) => {
    if (!drawn) return;
    const { left, top } = root.getBoundingClientRect();
    const number = nearest(drawn, event.clientX - left, event.clientY - top);
    if (number !== null) onChoose(number);
  });
  root.addEventListener('keydown', (event) => {
    if (!drawn || isChord(event)) return;
    const { anatomy, phase, chosen } = drawn.model;
    const number = stepped(orderOf(anatomy, phase), chosen, event.key);
    if (number === null) return;
    event.preventDefault();
    onChoose(number);
  });

  return {
    /** @param {PictureModel} model */
    draw(model) {
      if (!changed(model.anatomy, model.phase, model.chosen)) return;
      latest = model;
      if (isCrowd(model)) drawNext();
      else draw();
    },
  };
}

/** @param {HTMLElement} root @returns {(model: PictureModel, size: Size, drawn: Drawn | null) => Drawn} What draws after what it has drawn before. */
function createDrawing(root) {
  const picture = svg('svg', { 'aria-hidden': 'true' });
  const layers = ['axis', 'pairs', 'bouts', 'marks', 'notes'].map((name) => svg('g', { class: name }));
  const [axis, pairs, bouts, marks, notes] = layers;
  const ring = svg('circle', { class: 'ring' });
  picture.append(...layers, ring);
  root.append(picture);
  return (model, size, drawn) => {
    const { anatomy, phase, chosen } = model;
    const places = placesOf(anatomy, phase, size);
    picture.setAttribute('viewBox', `0 0 ${size.width} ${size.height}`);
    prepare(marks, pairs, model);
    const before = succeeded(drawn, anatomy);
    const moves = before || (drawn?.model.anatomy === anatomy && drawn.model.phase !== phase);
    const still = model.still || !moves || isCrowd(model) || drawn?.size !== size;
    root.classList.add('still');
    if (before && !still) place(marks, before);
    // What moves sets out from where it stands by now.
    if (!still) root.getBoundingClientRect();
    root.classList.toggle('still', still);
    root.dataset.phase = phase;
    showMarks(marks, pairs, model, places, radiusOf(size, anatomy.columns));
    drawAxis(axis, model, size);
    bouts.replaceChildren(...(phase === 'tournament' ? boutLines(model, places, size) : []));
    notes.replaceChildren(...notesOf(model, places, size));
    ring.setAttribute('r', String(Math.max(9, radiusOf(size, anatomy.columns) * 1.25 + 4)));
    moveTo(ring, places[chosen]);
    describe(root, model);
    return { model, size, places };
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

/** The mark in sight that is nearest to a point, unless that is far from all. @param {Drawn} drawn @param {number} x @param {number} y */
function nearest({ model, places }, x, y) {
  const distance = (/** @type {number} */ number) => Math.hypot(places[number].x - x, places[number].y - y);
  const number = orderOf(model.anatomy, model.phase).reduce((a, b) => (distance(b) < distance(a) ? b : a));
  return distance(number) < 40 ? number : null;
}

/** For who does not see it. @param {HTMLElement} root @param {PictureModel} model */
function describe(root, { anatomy, phase, chosen }) {
  const order = orderOf(anatomy, phase);
  root.setAttribute('aria-valuemin', '1');
  root.setAttribute('aria-valuemax', String(order.length));
  root.setAttribute('aria-valuenow', String(Math.max(1, order.indexOf(chosen) + 1)));
  root.setAttribute('aria-valuetext', words.chosenText(anatomy, phase, chosen));
}

/** @param {Element} layer @param {PictureModel} model @param {Size} size */
function drawAxis(layer, { anatomy, phase }, size) {
  const height = heightOf(anatomy, size);
  const right = size.width - margin.right;
  const [low, high] = height.scale.domain();
  const room = Math.max(2, Math.floor(size.height / 48));
  const step = tickStep(low, high, room);
  // Where evolution has nearly ended J itself would need too many digits.
  const narrow = step < 1e-4;
  const ticks = narrow ? ticksOf(0, high - low, room).map((tick) => low + tick) : ticksOf(low, high, room);
  const texts = narrow
    ? ticks.map((tick, i) => words.beyondBest(i === 0 ? 0 : tick - low))
    : sameDigits(ticks);
  const digits = narrow ? 3 : (texts[0]?.split('.')[1] ?? '').length;
  const line = (/** @type {number} */ y) => svg('line', { x1: margin.left, x2: right, y1: y, y2: y });
  const label = (/** @type {number} */ y, /** @type {string} */ text) =>
    svg('text', { x: margin.left - 8, y: y + 4, class: 'end' }, text);
  const { above } = height;
  const first = above ? above.line + 14 : 0;
  layer.replaceChildren(
    ...ticks.flatMap((tick) =>
      height.scale(tick) > first ? [line(Math.round(height.scale(tick)) + 0.5)] : [],
    ),
    ...ticks.flatMap((tick, i) => (height.scale(tick) > first ? [label(height.scale(tick), texts[i])] : [])),
    ...(above
      ? [
          svg('line', { x1: margin.left, x2: right, y1: above.line, y2: above.line, class: 'limit' }),
          label(above.y, words.aboveText(above.limit, digits)),
        ]
      : []),
    svg('text', { x: 0, y: margin.top + (above ? 36 : 4), class: 'symbol' }, words.costAxis),
    ...across({ anatomy, phase }, size),
  );
}

/** What stands below: the numbers of the pairs, or the wins. @param {Pick<PictureModel, 'anatomy' | 'phase'>} model @param {Size} size */
function across({ anatomy, phase }, size) {
  const { columns, all, record, ranking } = anatomy;
  const base = size.height - 5;
  const label = (/** @type {number} */ x, /** @type {string} */ text) =>
    svg('text', { x, y: base, class: 'middle' }, text);
  const title = (/** @type {string} */ text) =>
    svg('text', { x: margin.left - 8, y: base, class: 'end' }, text);
  if (phase === 'ranking') {
    if (record.wins.length === 0) return [];
    const { x, step } = columnsOf(size, all.length);
    const groups = groupsOf(ranking.map((number) => record.wins[number]));
    return [
      title(words.winsAxis),
      ...groups.flatMap(({ wins, from, to }) => [
        svg('line', {
          x1: x(from) - 0.4 * step,
          x2: x(to) + 0.4 * step,
          y1: size.height - margin.bottom + 3,
          y2: size.height - margin.bottom + 3,
          class: 'group',
        }),
        ...((to - from + 1) * step >= 12 ? [label((x(from) + x(to)) / 2, String(wins))] : []),
      ]),
    ];
  }
  const { x, step } = columnsOf(size, columns);
  const every =
    [1, 2, 5, 10, 20, 50, 100, 200, 500].find((n) => n * step >= 20 + 6 * String(columns).length - 12) ??
    1000;
  const shown = Array.from({ length: columns }, (_, i) => i + 1).filter((n) => n === 1 || n % every === 0);
  const name =
    phase === 'survivors' ? words.parentAxis : isInitial(record) ? words.robotAxis : words.pairAxis;
  return [title(name), ...shown.map((n) => label(x(n - 1), String(n)))];
}

/** Those in a row who have as many wins. @param {number[]} wins */
function groupsOf(wins) {
  /** @type {{ wins: number, from: number, to: number }[]} */
  const groups = [];
  for (const [i, own] of wins.entries()) {
    const last = groups[groups.length - 1];
    if (last?.wins === own) last.to = i;
    else groups.push({ wins: own, from: i, to: i });
  }
  return groups;
}

/** The chosen one's bouts: who stands above its line has lost to it, who stands below has won. @param {PictureModel} model @param {Place[]} places @param {Size} size */
function boutLines({ anatomy, chosen }, places, size) {
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
      const { x, y } = places[opponent];
      const won = wins(opponent);
      // On the far side of the line that leads there.
      const text = { x, y: y + (y <= own.y && y > 24 ? -9 : 19), class: 'middle result' };
      return svg('text', text, won ? words.won : words.lost);
    }),
  ];
}

/** The chosen one's ring and name, the line of the cut, and who crosses it the wrong way. @param {PictureModel} model @param {Place[]} places @param {Size} size */
function notesOf(model, places, size) {
  const { anatomy, phase, chosen } = model;
  const { upset, staying, all } = anatomy;
  const notes = [];
  const ranking = phase === 'ranking';
  if (ranking) {
    const { x, step } = columnsOf(size, all.length);
    const cut = x(staying - 1) + step / 2;
    notes.push(
      svg('line', { x1: cut, x2: cut, y1: margin.top, y2: size.height - margin.bottom + 6, class: 'cut' }),
      svg('text', { x: cut - 8, y: margin.top + 4, class: 'end' }, words.stay(staying)),
      svg('text', { x: cut + 8, y: margin.top + 4 }, words.fall(all.length - staying)),
    );
  }
  const named = ranking && upset ? [upset.survivor, upset.fallen] : [];
  if (ranking && upset) {
    const [a, b] = named.map((number) => places[number]);
    notes.push(svg('line', { x1: a.x, y1: a.y, x2: b.x, y2: b.y, class: 'upset' }));
  }
  for (const number of new Set([...named, chosen])) {
    const below = places[number].y < 34 || (ranking && number === upset?.fallen);
    notes.push(nameAt(places[number], below, size, words.nameOf(anatomy, number)));
  }
  return notes;
}

/** @param {Place} place @param {boolean} below Its mark, instead of above. @param {Size} size @param {string} name */
function nameAt({ x, y }, below, size, name) {
  const side = x > size.width - 50 ? 'end' : x < margin.left + 40 ? 'begin' : 'middle';
  const beside = { end: 9, begin: -9, middle: 0 }[side];
  return svg('text', { x: x + beside, y: below ? y + 24 : y - 15, class: `name ${side}` }, name);
}
