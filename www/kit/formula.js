// Formulas in a line of text.
import { html } from 'lit-html';

/** Every second piece is a subscript. @param {readonly string[]} pieces */
export const formula = (pieces) => pieces.map((piece, i) => (i % 2 ? html`<sub>${piece}</sub>` : piece));
