// One robot that is looked at: which one is meant by a press or a key, and what became of it.
/** @import { Engine, Triple } from '../../../core/engine.js' */
/** @import { Film } from '../film.js' */
/** @import { Plan } from '../picture.js' */
import { html } from 'lit-html';
import { remember } from '../../../kit/memo.js';
import { postureAt } from '../../../lab/track.js';
import { closeButton } from '../../../kit/templates.js';
import { toldOf } from './told.js';
import words from './words/index.js';

/** As far from a robot, and from its path, may a press be that means it: pixels. */
const reach = { robot: 22, path: 12 };

/** @param {Engine} engine @param {ReturnType<typeof import('../task.js').createTask>} task */
export function createLook(engine, task) {
  const count = task.starts.length;
  const told = remember((/** @type {number} */ index, /** @type {readonly number[]} */ gains) =>
    toldOf(engine, task.alone(index), /** @type {Triple} */ (gains)),
  );

  /** @param {number} index @param {Triple} gains */
  function textOf(index, gains) {
    const what = told(index, gains);
    return 'parkedAfter' in what
      ? words.parkedAfter(index + 1, count, what.parkedAfter)
      : words.missed(index + 1, count, what);
  }

  return {
    textOf,

    /** The robot that a press means; null: none. @param {Film} film @param {Plan} plan @param {readonly [number, number]} point In pixels. */
    nearest({ drives, time }, { screenX, screenY }, [px, py]) {
      const far = (/** @type {number} */ x, /** @type {number} */ y) =>
        Math.hypot(screenX(x) - px, screenY(y) - py);
      const robots = drives.map(({ run }) => {
        const { x, y } = postureAt(run, time);
        return far(x, y);
      });
      const paths = drives.map(({ run }) =>
        run.x.reduce((least, x, i) => Math.min(least, far(x, run.y[i])), Infinity),
      );
      for (const [distances, most] of /** @type {const} */ ([
        [robots, reach.robot],
        [paths, reach.path],
      ])) {
        const least = Math.min(...distances);
        if (least <= most) return distances.indexOf(least);
      }
      return null;
    },

    stepped,

    /** @param {number} index @param {Triple} gains @param {string | null} lab @param {(index: number | null) => void} look */
    note: (index, gains, lab, look) => html`<p id="park-told">${textOf(index, gains)}</p>
      <p class="park-look-on row not-on-paper">
        <button id="park-previous" type="button" aria-label=${words.previous} @click=${() => look(stepped(index, -1))}>‹</button>
        <button id="park-next" type="button" aria-label=${words.next} @click=${() => look(stepped(index, 1))}>›</button>
        ${lab ? html`<a id="park-watch" href="#${lab}">${words.watchThis}</a>` : ''}
        ${closeButton('park-close', words.close, () => look(null))}
      </p>`,
  };

  /** The one before or after, around the circle. @param {number | null} index @param {1 | -1} step */
  function stepped(index, step) {
    return index === null ? (step > 0 ? 0 : count - 1) : (index + step + count) % count;
  }
}
