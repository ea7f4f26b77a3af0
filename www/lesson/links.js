// The links of the page: what the run, the parts and the lesson put into them.
import { createLinks } from '../link/link.js';
import { linked } from '../parts/parts.js';
import { linkOfStep, stepNames } from './path.js';

export const links = createLinks({ ...linked, lesson: { count: stepNames.length, linkOf: linkOfStep } });
