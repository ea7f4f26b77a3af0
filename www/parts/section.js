// Where a part of the page shows itself.
import { create } from '../kit/elements.js';

/** It is named by the heading that is called after the part. @param {string} name @param {string} [id] */
export function createSection(name, id = name) {
  const attributes = {
    class: `part-section column ${name}`,
    'data-page': name,
    'aria-labelledby': `${name}-title`,
  };
  return create('section', { id, ...attributes });
}
