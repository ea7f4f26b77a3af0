// The words of what comes after a try, in the language of the page.
import { picked } from '../../../../words/pick.js';

export const load = picked({ en: () => import('./en.js'), ko: () => import('./ko.js') });
