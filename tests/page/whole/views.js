// Everything that the page can show, as links.
import { linkOfStep, stepNames } from '../../../www/lesson/path.js';
import { pageNames } from '../../../www/parts/parts.js';
import { linksTo } from '../parts/samples.js';

/** Every part, and what of it stands behind a choice. */
export const partViews = [
  ...pageNames.map((name) => `${name}&v=1&generation=2`),
  ...linksTo('views').map((link) => `${link}&generation=2`),
];

export const lessonViews = stepNames.map((_, i) => linkOfStep(i + 1));

export const views = [...partViews, ...linksTo('more').map((link) => `${link}&generation=2`), ...lessonViews];
