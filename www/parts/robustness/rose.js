// The headings of one place as a rose: which of them arrive; and a dial that chooses one.
import { svg } from '../../kit/elements.js';
import { arrowOf, isChord } from '../../kit/keyboard.js';
import { shadeAt } from '../../kit/shades.js';
import { watch } from '../../kit/memo.js';
import { robustness as words } from '../../words/index.js';
import { angleOf, headingNear, headings } from './grid.js';

/** @typedef {{ heading: number | null, parts: readonly (number | null)[] }} RoseModel Of each heading the part of the scale; null where it does not arrive. */

const radius = { inner: 24, outer: 52, reach: 60 };

/** @param {HTMLElement} root @param {{ chosen: () => number | null, onChoose: (heading: number | null) => void }} events `chosen` is the newest, which may not be drawn yet. */
export function createRose(root, { chosen, onChoose }) {
  const picture = svg('svg', { viewBox: '-62 -62 124 124', 'aria-hidden': 'true' });
  const petals = Array.from({ length: headings }, (_, heading) => svg('path', { d: petal(heading) }));
  const hand = svg('path', { class: 'hand', d: 'M18 0L-13 12L-6 0L-13 -12Z' });
  const ring = svg('circle', { class: 'ring', r: String(radius.reach), cx: '0', cy: '0' });
  const all = svg('text', { 'text-anchor': 'middle', 'dominant-baseline': 'central' }, words.allShort);
  picture.append(ring, ...petals, hand, all);
  root.replaceChildren(picture);
  root.setAttribute('aria-label', words.roseLabel(360 / headings));
  root.setAttribute('aria-valuemin', '0');
  root.setAttribute('aria-valuemax', String(360 - 360 / headings));
  followPointer(root, onChoose);
  root.addEventListener('keydown', (event) => {
    if (isChord(event)) return;
    const arrow = arrowOf(event.key);
    if (!arrow && event.key !== 'Escape') return;
    event.preventDefault();
    // Headings are counted to the left.
    onChoose(arrow && ((chosen() ?? 0) + arrow[1] - arrow[0] + headings) % headings);
  });

  const changed = watch();
  return {
    /** @param {RoseModel} model */
    draw({ heading, parts }) {
      if (!changed(heading, ...parts)) return;
      for (const [i, shape] of petals.entries()) {
        const part = parts[i];
        shape.style.fill = part === null ? 'none' : shadeAt(part);
        shape.classList.toggle('chosen', i === heading);
      }
      hand.style.display = heading === null ? 'none' : '';
      hand.setAttribute('transform', `rotate(${(-angleOf(heading ?? 0) * 180) / Math.PI})`);
      all.style.display = heading === null ? '' : 'none';
      root.setAttribute('aria-valuenow', String(((heading ?? 0) * 360) / headings));
      root.setAttribute('aria-valuetext', words.headingText(heading === null ? null : angleOf(heading)));
    },
  };
}

/** @param {HTMLElement} root @param {(heading: number) => void} onChoose */
function followPointer(root, onChoose) {
  let held = false;
  const choose = (/** @type {PointerEvent} */ event) => {
    const { left, top, width, height } = root.getBoundingClientRect();
    const [x, y] = [event.clientX - left - width / 2, top + height / 2 - event.clientY];
    if (Math.hypot(x, y) > 6) onChoose(headingNear(Math.atan2(y, x)));
  };
  root.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    held = true;
    root.setPointerCapture(event.pointerId);
    choose(event);
  });
  root.addEventListener('pointermove', (event) => {
    if (held) choose(event);
  });
  for (const end of ['pointerup', 'pointercancel']) root.addEventListener(end, () => (held = false));
}

/** @param {number} heading */
function petal(heading) {
  const half = (0.84 * Math.PI) / headings;
  /** @param {number} length @param {number} angle */
  const at = (length, angle) =>
    `${(length * Math.cos(angle)).toFixed(2)} ${(-length * Math.sin(angle)).toFixed(2)}`;
  const [from, to] = [angleOf(heading) - half, angleOf(heading) + half];
  const { inner, outer } = radius;
  return `M${at(inner, from)}L${at(outer, from)}A${outer} ${outer} 0 0 0 ${at(outer, to)}L${at(inner, to)}Z`;
}
