// The Lyapunov function as a bowl, V = r²/2: the robot stands on its wall as high as V, on the side to which x_e and y_e point.
import { html, nothing, render, svg } from 'lit-html';
import { create } from '../../kit/elements.js';
import { extentOf } from '../../kit/extent.js';
import { remember, watch } from '../../kit/memo.js';
import { fixed, powerText } from '../../words/numbers.js';

/** @import { Samples } from '../../core/engine.js' */
/** @import { Block, Live, Tools } from '../page.js' */
/** @typedef {{ bowl: { label: (V: number) => string, height: string } }} BowlWords */
/** @typedef {{ r: number, turn: number }} Spot */

const width = 320;
const height = 300;
const middle = { x: 160, y: 246 };
/** In pixels: from the bottom to the rim, outwards and upwards. */
const rim = { out: 138, up: 176 };
/** How flat a circle is seen. */
const flat = 0.34;
const rings = 5;

/** @param {import('../../core/engine.js').Sample} sample @returns {Spot} */
const spotOf = ({ error: { x, y }, lyapunov }) => ({
  r: Math.sqrt(2 * Math.max(0, lyapunov)),
  turn: Math.atan2(y, x),
});

/** @param {Spot} spot @param {number} most The r of the rim. */
function placeOf({ r, turn }, most) {
  const share = r / most;
  return {
    x: middle.x + rim.out * share * Math.cos(turn),
    y: middle.y - rim.up * share * share - rim.out * flat * share * Math.sin(turn),
  };
}

/** A level line. @param {number} share of the rim */
const ring = (share) => ({
  y: middle.y - rim.up * share * share,
  rx: rim.out * share,
  ry: rim.out * share * flat,
});

/** The wall from one side, by its outline. */
const outline = Array.from({ length: 41 }, (_, i) => i / 20 - 1)
  .map((share) => `${middle.x + rim.out * share},${middle.y - rim.up * share * share + 0.5}`)
  .join('L');

/** @param {Tools} _tools @param {BowlWords} words @returns {Block} */
export function createBowl(_tools, { bowl: words }) {
  const element = create('div', { id: 'bowl', class: 'bowl' });
  const changed = watch();
  const wayOf = remember((/** @type {Samples} */ samples) => {
    const spots = samples.map(spotOf);
    const [, most] = extentOf([spots.map(({ r }) => r)], [0, 0.1]);
    const points = spots.map((spot) => placeOf(spot, most));
    return {
      most,
      points,
      way: points.map((point) => (isSomewhere(point) ? `${point.x.toFixed(1)},${point.y.toFixed(1)}` : '')),
    };
  });

  return {
    element,
    draw(/** @type {Live} */ { samples, sample, at }) {
      if (!changed(samples, at)) return;
      const { most, points, way } = wayOf(samples);
      const ball = points[Math.min(at, points.length - 1)];
      const isThere = isSomewhere(ball);
      const levels = Array.from({ length: rings }, (_, i) => ring((i + 1) / rings));
      render(
        html`<svg viewBox="0 0 ${width} ${height}" role="img" aria-label=${words.label(sample.lyapunov)}>
          <path class="bowl-wall" d=${`M${outline}Z`} />
          ${levels.map(({ y, rx, ry }) => svg`<ellipse class="bowl-ring" cx=${middle.x} cy=${y} rx=${rx} ry=${ry} />`)}
          <path class="bowl-ahead" d=${through(way.slice(Math.min(at, way.length - 1)))} /><path class="bowl-way" d=${through(way.slice(0, at + 1))} />
          <path class="bowl-height" d=${isThere ? `M${ball.x},${ball.y}H${width - 8}` : ''} />
          <text class="bowl-text" x=${width - 8} y=${isThere ? ball.y + (isAside(ball.x) ? 16 : -6) : 16}>${`${words.height} ${heightText(sample.lyapunov)}`}</text>
          ${isThere ? svg`<circle class="bowl-ball" cx=${ball.x} cy=${ball.y - 7} r="9" />` : nothing}
          <text class="bowl-zero" x=${middle.x} y=${middle.y + 22}>${`${words.height} 0`}</text>
          ${isOnRimText(ball) ? nothing : svg`<text class="bowl-zero" x=${middle.x} y=${ring(1).y - ring(1).ry - 8}>${`${words.height} ${rimText((most * most) / 2)}`}</text>`}
        </svg>`,
        element,
      );
    },
  };
}

/** A wild drive ends beyond all numbers. @param {{ x: number, y: number }} point */
const isSomewhere = ({ x, y }) => Number.isFinite(x) && Number.isFinite(y);

/** @param {readonly string[]} way Nothing for what is nowhere. */
const through = (way) => {
  const points = way.filter(Boolean).join('L');
  return points && `M${points}`;
};

/** Whether the ball would lie on the text of the rim, whose V it then has. @param {{ x: number, y: number }} ball */
const isOnRimText = ({ x, y }) => Math.abs(x - middle.x) < 60 && y < ring(1).y - ring(1).ry + 14;

/** Whether the ball is where its height is written. @param {number} x */
const isAside = (x) => x > width - 96;

/** With fewer digits where it is large. @param {number} V */
const heightText = (V) => (V < 100 ? fixed(V, 3) : rimText(V));
/** @param {number} V */
const rimText = (V) => (V < 100 ? fixed(V, 2) : V < 1e5 ? fixed(V, 0) : powerText(V));
