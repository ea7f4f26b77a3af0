// The headings of one place as a rose: which of them arrive; and a dial that chooses one.
import { html, render, svg } from 'lit-html';
import { tellValue } from '../../kit/elements.js';
import { followHeld, followKeys, followPointing, pointIn } from '../../kit/map.js';
import { shadeAt } from '../../kit/shades.js';
import { styled } from '../../kit/templates.js';
import { once, watch } from '../../kit/memo.js';
import words from './words/index.js';
import { angleOf, headingNear, headings } from './grid.js';

/** @typedef {{ heading: number | null, lit: number | null, parts: readonly (number | null)[] }} RoseModel Of each heading the part of the scale; null where it does not arrive; the path of the one that is lit is drawn on the map. */

const radius = { inner: 24, outer: 52, reach: 60 };

/** @param {HTMLElement} root @param {{ chosen: () => number | null, onChoose: (heading: number | null) => void, onPoint: (heading: number | null) => void }} events `chosen` is the newest, which may not be drawn yet. */
export function createRose(root, { chosen, onChoose, onPoint }) {
  const step = 360 / headings;
  root.setAttribute('aria-label', words.roseLabel(step));
  /** @param {PointerEvent} event */
  const headingAt = (event) => {
    const [x, y] = pointIn(root, event);
    const [ahead, up] = [x - root.clientWidth / 2, root.clientHeight / 2 - y];
    return Math.hypot(ahead, up) > 6 ? headingNear(Math.atan2(up, ahead)) : null;
  };
  followHeld(root, (event) => {
    const heading = headingAt(event);
    if (heading !== null) onChoose(heading);
  });
  followPointing(root, (event) => onPoint(event && headingAt(event)));
  followKeys(root, {
    onEscape() {
      if (chosen() === null) return false;
      onChoose(null);
      return true;
    },
    // Headings are counted to the left.
    onStep: ([right, up]) => onChoose(((chosen() ?? 0) + up - right + headings) % headings),
  });

  const changed = watch();
  return {
    /** @param {RoseModel} model */
    draw({ heading, lit, parts }) {
      if (!changed(heading, lit, ...parts)) return;
      render(sight(heading, lit, parts), root);
      const text = words.headingText(heading === null ? null : angleOf(heading));
      tellValue(root, 0, 360 - step, (heading ?? 0) * step, text);
    },
  };
}

/** @param {number | null} heading @param {number | null} lit @param {RoseModel['parts']} parts */
function sight(heading, lit, parts) {
  const hand = svg`<path class="hand" d="M18 0L-13 12L-6 0L-13 -12Z" transform="rotate(${(-angleOf(heading ?? 0) * 180) / Math.PI})"></path>`;
  const all = svg`<text text-anchor="middle" dominant-baseline="central">${words.allShort}</text>`;
  return html`
    <svg viewBox="-62 -62 124 124" aria-hidden="true">
      <circle class="ring" r=${radius.reach} cx="0" cy="0"></circle>
      ${parts.map(
        (part, i) =>
          svg`<path d=${petalsOf()[i]} class=${i === heading ? 'chosen' : i === lit ? 'lit' : ''} ${styled('fill', part === null ? 'none' : shadeAt(part))}></path>`,
      )}
      ${heading === null ? all : hand}
    </svg>`;
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

/** The core says which way they point, once it is there. */
const petalsOf = once(() => Array.from({ length: headings }, (_, heading) => petal(heading)));
