// Opens the page, once the words of its language are there.
import './kit/translated.js';
import { sayLoading, showAsFigure } from './embed/frame.js';
import { language, usualLanguage } from './words/language.js';
import { load } from './words/load.js';

// A copy that a browser has saved says what it is.
if (!document.getElementById('copy')) {
  sayLoading();
  showAsFigure();
  const heading = /** @type {HTMLElement} */ (document.querySelector('h1'));
  const { textContent } = heading;
  // That of index.html is of another language.
  if (language !== usualLanguage) heading.replaceChildren();
  // Where a file is missing, index.html says it. Where the page is left meanwhile, nobody is there to be told.
  load()
    .then(() => import('./page.js'))
    .then(({ begin }) => {
      // Nor can anything be told apart without the styles; in a frame that is not shown some browsers tell of none.
      const style = getComputedStyle(document.documentElement);
      if (style.display && !style.getPropertyValue('--ink')) throw Error('no styles');
      begin();
    })
    .catch((error) => {
      showAsFigure(false);
      heading.textContent = textContent;
      console.error(error);
    });
}
