// Opens the page, once the words of its language are there.
import { load } from './words/load.js';

load().then(() => import('./page.js'));
