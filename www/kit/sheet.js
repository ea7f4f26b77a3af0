// A sheet over the page: its title, what closes it, and what it holds.
import { html, render } from 'lit-html';
import { create } from './elements.js';

/** It stands in the page from now on, closed. @param {string} id @param {string} className @param {string} title Until another is drawn. @param {string} close What the button says. */
export function createSheet(id, className, title, close) {
  const dialog = /** @type {HTMLDialogElement} */ (create('dialog', `sheet ${className}`.trim()));
  dialog.id = id;
  dialog.setAttribute('aria-labelledby', `${id}-title`);
  document.querySelector('main')?.append(dialog);
  // It says what was there before.
  addEventListener('popstate', () => dialog.close());
  return {
    dialog,

    /** @param {unknown} content @param {string} [heading] */
    draw: (content, heading = title) =>
      render(
        html`<div class="bar sheet-head">
            <h2 id="${id}-title">${heading}</h2>
            <button id="${id}-close" type="button" @click=${() => dialog.close()}>${close}</button>
          </div>
          ${content}`,
        dialog,
      ),

    open() {
      if (!dialog.open) dialog.showModal();
    },
  };
}

/** @typedef {ReturnType<typeof createSheet>} Sheet */
