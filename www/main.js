// Opens the page, once the words of its language are there.
import { sayLoading } from './embed/loading.js';
import { load } from './words/load.js';

sayLoading();
load().then(() => import('./page.js'));
