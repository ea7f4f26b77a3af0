// Every word that the steps of the lesson share, and the steps.
import { drive } from './ko/drive.js';
import { error } from './ko/error.js';
import { law } from './ko/law.js';
import { stability } from './ko/stability.js';
import { limits } from './ko/limits.js';
import { cost } from './ko/cost.js';
import { generation } from './ko/generation.js';
import { sigma } from './ko/sigma.js';
import { duel } from './ko/duel.js';
import { landscape } from './ko/landscape.js';
import { task } from './ko/task.js';
import { disturbance } from './ko/disturbance.js';
import { paper } from './ko/paper.js';
import { lecturers } from './ko/lecturers.js';

export const stepLabel = '수업 단계';
/** @param {number} number @param {number} count */
export const stepOf = (number, count) => `${count}단계 중 ${number}단계`;
/** @param {string} title */
export const nextStep = (title) => `다음: ${title}`;
/** @param {string} title */
export const previousStep = (title) => `이전: ${title}`;
/** What of the figure stays in sight on a telephone. */
export const sights = '읽는 동안 보이는 것';
export const sightOfRobot = '로봇';
export const notice = '눈여겨볼 점';
export const tries = '해 볼 것';
export const showNumbers = '지금의 수치를 넣어 보기';
export const hideNumbers = '수치 감추기';
export const formula = '식';
export const right = '실제 결과';
export const wrong = '나의 예측';
export const asPredicted = '예측한 대로입니다.';
export const otherwise = '예측과 다릅니다.';
export const computing = '주행하는 중 …';
export const askAgain = '다시 풀기';

export const steps = {
  drive,
  error,
  law,
  stability,
  limits,
  cost,
  generation,
  sigma,
  duel,
  landscape,
  task,
  disturbance,
  paper,
  lecturers,
};
