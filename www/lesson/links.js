// The links of the page: what the run, the parts and the lesson put into them.
import { createLinks } from '../link/link.js';
import { linked } from '../parts/parts.js';
import { linkOfStep, steps } from './steps.js';

export const links = createLinks({ ...linked, lesson: { count: steps.length, linkOf: linkOfStep } });
