// Every word of the lesson that its steps share, and the steps.
import { drive } from './lesson/drive.js';
import { error } from './lesson/error.js';

export const texts = { lesson: 'Lesson' };

export const nav = 'Lesson';
export const tagline =
  '예측하고, 해 보고, 확인하고, 설명합니다. 실험실의 화면으로 방법을 한 단계씩 익힙니다.';
export const stepLabel = 'Step of the lesson';
/** @param {number} number @param {number} count */
export const stepOf = (number, count) => `Step ${number} of ${count}`;
/** @param {string} title */
export const nextStep = (title) => `Next: ${title}`;
/** @param {string} title */
export const previousStep = (title) => `Back: ${title}`;
export const notice = 'Things to notice';
export const tries = 'Things to try';
export const showNumbers = 'with the numbers of now';
export const hideNumbers = 'without the numbers';
export const right = 'so it is';
export const wrong = 'your prediction';
export const asPredicted = 'As you said.';
export const otherwise = 'It is otherwise.';
export const computing = 'Driving …';
export const askAgain = 'Ask me again';

export const steps = { drive, error };
