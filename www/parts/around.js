// Why nothing can be driven from starts around the goal: near the edge of the plane they would lie beyond it.
import { messageOf } from '../words/errors.js';
import { lab } from '../words/index.js';

const beyond = /^(?:grid\.[xy]\.(?:from|to)|starts\[\d+\]\.[xy]) must be a number from/;

/** It names the goal, which somebody has put there, not a start, which nobody has. @param {unknown} error */
export const messageAround = (error) =>
  error instanceof Error && beyond.test(error.message) ? lab.goalAtEdge : messageOf(error);

/** Whether nothing helps but another goal. @param {{ message: string }} slice */
export const isAtEdge = ({ message }) => message === lab.goalAtEdge;
