// What is asked of a figure and not yet answered.
/** @import { Report } from './messages.js' */
import { version } from './frame.js';

/** @typedef {{ ep: number, id: number, type?: string }} Message and what is asked. */
/** @typedef {{ message: Message, resolve: (report: Report) => void, reject: (reason: unknown) => void }} Question */

export function createQuestions() {
  /** By their ids. @type {Map<unknown, Question>} */
  const open = new Map();
  let asked = 0;

  return {
    /** The messages, in the order in which they were asked. */
    open: () => [...open.values()].map(({ message }) => message),

    /** @param {object} what @returns {{ message: Message, answer: Promise<Report> }} */
    ask(what) {
      asked += 1;
      const message = { ...what, ep: version, id: asked };
      const answer = new Promise((resolve, reject) => {
        open.set(message.id, { message, resolve, reject });
      });
      return { message, answer };
    },

    /** The one that is answered, which is open no longer. @param {unknown} id */
    take(id) {
      const question = open.get(id);
      open.delete(id);
      return question;
    },

    /** Nobody is to wait for an answer that will not come. @param {string} why */
    giveUp(why) {
      for (const { reject } of open.values()) reject(new Error(why));
      open.clear();
    },
  };
}
