// The page around a figure: what it is told, and what is heard of it, also where the figure cannot begin.
import { version } from './frame.js';
import { idIn, isForFigure, shortError } from './told.js';

/** A figure holds nothing that its host may not know, whoever that is; one that was taken away has none. @param {object} message */
export const post = (message) => {
  if (parent !== window) parent?.postMessage(message, '*');
};

/** Only who holds the frame has a say in it. @param {(message: unknown) => void} hear */
export const listen = (hear) =>
  addEventListener('message', ({ source, data }) => {
    if (source === parent && parent !== window) hear(data);
  });

/** In the place of a figure that cannot begin: why, at once and to whoever asks. @param {string} why */
export function sayFailed(why) {
  const refuse = (/** @type {object} */ named) =>
    post({ ep: version, type: 'error', ...named, message: shortError(why) });
  refuse({});
  listen((message) => isForFigure(message) && refuse(idIn(message)));
}
