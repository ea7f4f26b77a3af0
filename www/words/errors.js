import { Pending } from '../core/pending.js';
import { instead, messages } from './index.js';

/** What went wrong, in the language of the page. @param {unknown} error */
export const messageOf = (error) =>
  isLost(error) ? instead.stopped : messages.said(error instanceof Error ? error.message : String(error));

/** Whether the core has failed, which must not be used again then, and has not only refused something. @param {unknown} error */
export const isLost = (error) =>
  error instanceof Error &&
  (error.name === 'RuntimeError' || /internal error|recursive use of an object/.test(error.message));

/** Says what goes wrong in the act; what is still being computed, and that the core has failed, is for whoever called it. @param {() => void} act @param {(text: string) => void} say */
export const orSay = (act, say) => () => {
  try {
    act();
  } catch (error) {
    if (error instanceof Pending || isLost(error)) throw error;
    say(messageOf(error));
  }
};
