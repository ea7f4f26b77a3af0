// The links of the page: what the run, the parts and the lesson put into them.
import { createLinks } from '../link/link.js';
import { linked } from '../parts/parts.js';
import { linkOfStep, stepNamed, textOfStep } from './path.js';

export const links = createLinks({
  ...linked,
  lesson: { named: stepNamed, textOf: textOfStep, linkOf: linkOfStep },
});
