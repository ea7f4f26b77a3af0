// Every step in Korean.
export { drive } from './drive.js';
export { error } from './error.js';
export { law } from './law.js';
export { stability } from './stability.js';
export { limits } from './limits.js';
export { cost } from './cost.js';
export { generation } from './generation.js';
export { sigma } from './sigma.js';
export { duel } from './duel.js';
export { landscape } from './landscape.js';
export { contest } from './contest.js';
export { task } from './task.js';
export { disturbance } from './disturbance.js';
export { paper } from './paper.js';
export { build } from './build.js';
export { lecturers } from './lecturers.js';
