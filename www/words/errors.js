import { instead, messages } from './index.js';

/** What went wrong, in the language of the page. @param {unknown} error */
export const messageOf = (error) =>
  isLost(error) ? instead.stopped : messages.said(error instanceof Error ? error.message : String(error));

/** Whether the core has failed, which must not be used again then, and has not only refused something. @param {unknown} error */
export const isLost = (error) =>
  error instanceof Error &&
  (error.name === 'RuntimeError' || /internal error|recursive use of an object/.test(error.message));
