// What a worker computes or a link waits for, how far it is, and the way to stop it.
/** @import { State } from '../run/state.js' */
import { html, nothing, render } from 'lit-html';
import { byId, create } from '../kit/elements.js';
import { canStop } from '../run/guard.js';
import { lab as strings } from '../words/index.js';

/** Milliseconds: what is there sooner need not be said. */
const patience = 300;
/** On the page's own thread evolution is seen as it goes on. */
const patienceHere = 1000;

/** @param {{ stopComputing: () => void }} actions */
export function createComputing({ stopComputing }) {
  const place = create('div', { id: 'computing', class: 'computing', hidden: '' });
  byId('message').after(place);
  addEventListener('keydown', (event) => {
    // Or it was for something else, as the closing of a dialog is.
    const isUsed = event.defaultPrevented || event.isComposing || document.querySelector('dialog[open]');
    if (event.key === 'Escape' && !place.hidden && !isUsed) stopComputing();
  });
  /** When evolution began to catch up. @type {number | null} */
  let begun = null;
  return {
    /** @param {State} state */
    draw(state) {
      const { computing, catchingUp, generation } = state;
      const wasThere = !place.hidden;
      const now = performance.now();
      begun = catchingUp ? (begun ?? now) : null;
      const newest = catchingUp?.newest ?? null;
      const share = newest ? generation / newest : computing?.share();
      const isDue = computing
        ? now - computing.since >= patience
        : share && begun !== null && (wasThere || isLongAway(now - begun, share));
      place.hidden = !isDue;
      if (!isDue) return;
      const text = strings.computingText(computing?.what ?? 'generation', generation, newest);
      // How far it is need not be heard at every step.
      const voice = newest && wasThere ? 'off' : 'polite';
      const bar = html`<progress aria-labelledby="computing-text" value=${share ?? nothing}></progress>`;
      const stop = html`<button type="button" class="link" @click=${stopComputing}>${strings.stopComputing}</button>`;
      render(
        html`<span id="computing-text" role="status" aria-live=${voice}>${text}</span> ${canStop(state) ? stop : nothing}${bar}`,
        place,
      );
    },
  };
}

/** Evolution that is seen as it goes on will take longer than one waits for. @param {number} past Milliseconds. @param {number} share */
const isLongAway = (past, share) => past >= patienceHere && past * (1 / share - 1) >= patienceHere;
