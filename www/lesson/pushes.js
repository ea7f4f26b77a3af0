// The terms of the law (5) at the robots' clock: what each adds to v and to ω, what is asked for in all, and what the limits leave.
import { create } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { signed } from '../words/numbers.js';
import { lawTerms } from './formulas.js';
import { row } from './notation.js';
import { mathml, symbol, symbolInText } from './symbols.js';

/** @typedef {import('../core/engine.js').Sample} Sample */
/** @typedef {import('../core/engine.js').Triple} Triple */
/** @typedef {import('./notation.js').Part} Part */
/** @typedef {{ speed: string, turnRate: string, moving: string, asked: string, left: string, otherLaw: string, tableLabel: string }} PushWords */

/** The core's: what is divided by is no smaller than this. */
const smallestDivisor = 1e-6;
/** How far a bar reaches to each side, m/s and rad/s: the same for every drive, so that drives can be compared. */
const reach = /** @type {const} */ ({ linear: 8, angular: 16 });

/** Each term of (5) by its gain; they add up to the command while the goal stands still. @param {Sample['error']} error @param {Triple} gains */
export function pushesOf({ x, y, theta }, [kx, ky, kt]) {
  const [sin, cos] = [Math.sin(theta), Math.cos(theta)];
  const cosec = Math.min(Math.max(1 / sin, -1 / smallestDivisor), 1 / smallestDivisor);
  const aside = ky * y ** 3 * cosec;
  return {
    linear: { kx: kx * x * cos, ky: -aside },
    angular: { kt: kt * sin, ky: aside * cosec * x * cos, kx: kx * x * y * cos },
  };
}

/** @typedef {'linear' | 'angular'} Side */

/** @param {import('./page.js').Tools} _tools @param {{ pushes: PushWords }} words @returns {import('./page.js').Block} */
export function createPushes(_tools, { pushes: words }) {
  const sides = [
    createSide('linear', 'v', words.speed, words),
    createSide('angular', 'w', words.turnRate, words),
  ];
  const table = create('table', 'pushes', ...sides.map(({ body }) => body));
  table.setAttribute('aria-label', words.tableLabel);
  const other = create('p', 'muted', words.otherLaw);
  const element = create('div', '', table, other);
  element.id = 'pushes';
  const changed = watch();
  return {
    element,
    draw({ decided: sample, gains, scene: { experiment } }) {
      if (!changed(sample, ...gains, experiment)) return;
      const isOurs = experiment.law === 'shim-kim';
      const pushes = isOurs ? pushesOf(sample.error, gains) : { linear: {}, angular: {} };
      const { speed, turnRate } = experiment.limits;
      const { linear, angular } = experiment.referenceVelocity;
      const isMoving = isOurs && (linear !== 0 || angular !== 0);
      sides[0].draw(pushes.linear, sample.command.linear, sample.velocity.linear, speed, isMoving);
      sides[1].draw(pushes.angular, sample.command.angular, sample.velocity.angular, turnRate, isMoving);
      other.hidden = isOurs;
    },
  };
}

/** The terms in one line, for who hears them. @type {Record<Side, Record<string, string>>} */
const inWords = {
  linear: { kx: 'k x · x e · cos θ e', ky: '− k y · y e³ / sin θ e' },
  angular: {
    kt: 'k θ · sin θ e',
    ky: 'k y · x e · y e³ · cos θ e / sin² θ e',
    kx: 'k x · x e · y e · cos θ e',
  },
};

/** All of v, or all of ω. @param {Side} side @param {'v' | 'w'} name @param {string} unit @param {PushWords} words */
function createSide(side, name, unit, words) {
  const parts = /** @type {Record<string, Part[]>} */ (lawTerms(symbol)[side]);
  const minus = (/** @type {string} */ gain) => (side === 'linear' && gain === 'ky' ? ['−'] : []);
  const terms = Object.entries(parts).map(([gain, part]) => {
    const math = mathml('math', row(...minus(gain), ...part));
    math.setAttribute('role', 'math');
    math.setAttribute('aria-label', inWords[side][gain]);
    return { gain, bar: createBar(math, `of-${gain === 'kt' ? 'theta' : gain[1]}`, gain) };
  });
  const moving = createBar(words.moving, 'of-moving', '');
  const asked = createBar(words.asked, `of-${name === 'v' ? 'energy' : 'omega'}`, name);
  const left = createBar(words.left, 'of-left', '');
  const all = [...terms.map(({ bar }) => bar), moving, asked, left];
  asked.row.classList.add('push-asked');
  const head = create('th', 'push-unit', symbolInText(name), ` ${unit}`);
  head.setAttribute('scope', 'rowgroup');
  head.setAttribute('colspan', '3');
  const body = create('tbody', '', create('tr', '', head), ...all.map(({ row: line }) => line));

  return {
    body,
    /** @param {Record<string, number>} pushes @param {number} command @param {number} velocity @param {number | null} limit @param {boolean} isMoving */
    draw(pushes, command, velocity, limit, isMoving) {
      body.style.setProperty(
        '--free',
        `${50 * Math.min((limit ?? Number.POSITIVE_INFINITY) / reach[side], 1)}%`,
      );
      let sum = 0;
      for (const { gain, bar } of terms) {
        bar.row.hidden = !(gain in pushes);
        bar.draw(sum, sum + (pushes[gain] ?? 0), pushes[gain] ?? 0);
        sum += pushes[gain] ?? 0;
      }
      moving.row.hidden = !isMoving;
      moving.draw(sum, command, command - sum);
      asked.draw(0, command, command);
      left.draw(0, velocity, velocity);
    },
  };

  /** @param {Node | string} label @param {string} colour @param {string} term */
  function createBar(label, colour, term) {
    const name = create('th', 'push-name', label);
    name.setAttribute('scope', 'row');
    const bar = create('span', 'push');
    const track = create('span', 'push-track', bar);
    const cell = create('td', 'push-cell', track);
    const value = create('td', 'push-value');
    const line = create('tr', colour, name, cell, value);
    if (term) line.dataset.term = term;
    return {
      row: line,
      /** From one value to the next, and how much that is. @param {number} from @param {number} to @param {number} amount */
      draw(from, to, amount) {
        const at = (/** @type {number} */ value) => Math.min(Math.max(value / reach[side], -1), 1);
        const [low, high] = [Math.min(at(from), at(to)), Math.max(at(from), at(to))];
        bar.style.left = `${50 + 50 * low}%`;
        bar.style.right = `${50 - 50 * high}%`;
        bar.classList.toggle('beyond-right', Math.max(from, to) > reach[side]);
        bar.classList.toggle('beyond-left', Math.min(from, to) < -reach[side]);
        value.textContent = signed(amount, 2);
      },
    };
  }
}
