// The words of checking hand-ins, in the language of the page.
import { picked } from '../../../words/pick.js';

export const load = picked({ en: () => import('./en.js'), ko: () => import('./ko.js') });
