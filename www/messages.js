import { messages } from './words/index.js';

/** What went wrong, in the language of the page. @param {unknown} error */
export const messageOf = (error) => messages.said(error instanceof Error ? error.message : String(error));
