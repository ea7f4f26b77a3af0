// Everything that the page can show, as links: every part and its views, every step of the lesson.
import { linkOfStep, stepNames } from '../../../www/lesson/path.js';
import { pageNames } from '../../../www/parts/parts.js';

export const views = [
  ...pageNames.map((name) => `${name}&v=1&generation=2`),
  ...['stability', 'compare', 'numbers'].map((view) => `curves&v=1&view=${view}&generation=2`),
  ...['mutation', 'drive', 'tournament', 'ranking', 'survivors'].map(
    (phase) => `generation&v=1&generation=2&phase=${phase}`,
  ),
  'luck&v=1&luck=contest',
  ...stepNames.map((_, i) => linkOfStep(i + 1)),
];
