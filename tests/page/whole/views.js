// Everything that the page can show, as links.
import { linkOfStep, stepNames } from '../../../www/lesson/path.js';
import { pageNames } from '../../../www/parts/parts.js';

/** Every part, and what of the curves stands behind a switch. */
export const partViews = [
  ...pageNames.map((name) => `${name}&v=1&generation=2`),
  ...['stability', 'compare', 'numbers'].map((view) => `curves&v=1&view=${view}&generation=2`),
];

export const lessonViews = stepNames.map((_, i) => linkOfStep(i + 1));

export const views = [
  ...partViews,
  ...['mutation', 'drive', 'tournament', 'ranking', 'survivors'].map(
    (phase) => `generation&v=1&generation=2&phase=${phase}`,
  ),
  'luck&v=1&luck=contest',
  ...lessonViews,
];
