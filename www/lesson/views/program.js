// One drive and one generation as pseudo-code; the lines of the phase that the figure shows are lit.
import { create } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { generationSlice } from '../../parts/generation/state.js';

/** @import { Phase } from '../../parts/generation/state.js' */
/** @import { Block, Live, Tools } from '../page.js' */
/** A line: how deep it stands, of which phase it is, and its text. @typedef {readonly [depth: number, phase: Phase | '', text: string]} Line */
/** @typedef {{ program: { label: string, drive: readonly Line[], generation: readonly Line[] } }} ProgramWords */

/** @param {Tools} _tools @param {ProgramWords} words @returns {Block} */
export function createProgram(_tools, { program: words }) {
  const lines = [...words.drive, /** @type {Line} */ ([0, '', '']), ...words.generation].map(
    ([depth, phase, text]) => {
      const line = create('li', '', text);
      line.style.setProperty('--depth', String(depth));
      if (phase) line.dataset.phase = phase;
      return line;
    },
  );
  // On a small screen it scrolls, also by keyboard.
  const attributes = { id: 'program', class: 'program', 'aria-label': words.label, tabindex: 0 };
  const element = create('ol', attributes, ...lines);
  const changed = watch();
  return {
    element,
    draw(/** @type {Live} */ { state }) {
      const { phase } = generationSlice.of(state);
      const shown = state.page === 'generation' ? phase : '';
      if (!changed(shown)) return;
      for (const line of lines) {
        const isNow = shown !== '' && line.dataset.phase === shown;
        line.classList.toggle('now', isNow);
        if (isNow) line.setAttribute('aria-current', 'step');
        else line.removeAttribute('aria-current');
      }
    },
  };
}
