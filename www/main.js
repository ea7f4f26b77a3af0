// Opens the page, once the words of its language are there.
import './kit/translated.js';
import { sayLoading } from './embed/frame.js';
import { load } from './words/load.js';

sayLoading();
// Where a file is missing, index.html says it. Where the page is left meanwhile, nobody is there to be told.
load()
  .then(() => import('./page.js'))
  .then(({ begin }) => {
    // A copy that a browser has saved says what it is.
    if (!document.getElementById('copy')) begin();
  })
  .catch(console.error);
