// Opens the page, once the words of its language are there.
import './kit/translated.js';
import { sayLoading } from './embed/frame.js';
import { language, usualLanguage } from './words/language.js';
import { load } from './words/load.js';

sayLoading();
// That of index.html is of another language.
if (language !== usualLanguage) document.querySelector('h1')?.replaceChildren();
// Where a file is missing, index.html says it. Where the page is left meanwhile, nobody is there to be told.
load()
  .then(() => import('./page.js'))
  .then(({ begin }) => {
    // A copy that a browser has saved says what it is.
    if (!document.getElementById('copy')) begin();
  })
  .catch((error) => {
    document.body.removeAttribute('data-embed');
    console.error(error);
  });
