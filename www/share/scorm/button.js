// The button that writes an exercise as a package for learning platforms. Where the page cannot read its own file, as from a disk,
// it asks for it.
/** @import { Exercise } from '../../run/exercise.js' */
import { tidyText } from '../../kit/text.js';
import { html, nothing } from 'lit-html';
import { download } from '../../kit/download.js';
import { digitsOf } from '../../kit/hash.js';
import { messageOf } from '../../words/errors.js';
import { opening } from '../../words/index.js';
import { language } from '../../words/language.js';
import words from '../words/index.js';

const { texts, scorm } = words;
const fileName = 'ep-locomotion.html';
const mostOfTitle = 80;

/** Whether it is the whole page in one file. @param {Uint8Array} content */
const isOneFile = (content) =>
  content.length > 200_000 &&
  new TextDecoder().decode(content.subarray(0, 2000)).includes('Content-Security-Policy');

/** The one file that stands beside the page; null where it cannot be read. @returns {Promise<Uint8Array | null>} */
async function besideThePage() {
  // The one file, wherever it is opened, may reach nothing outside of itself.
  if (document.querySelector('meta[http-equiv="Content-Security-Policy"]')) return null;
  try {
    const answer = await fetch(new URL(fileName, document.baseURI));
    const content = new Uint8Array(await answer.arrayBuffer());
    return answer.ok && isOneFile(content) ? content : null;
  } catch {
    return null;
  }
}

/** @param {(text: string, of?: string) => void} say What is shown then, and of which exercise. */
export function createPackaging(say) {
  let asks = false;

  /** @param {string} link @param {Exercise} draft @param {Uint8Array} oneFile */
  async function write(link, draft, oneFile) {
    const writer = await import('./package.js').catch(console.warn);
    if (!writer) return say(opening.failed);
    const { mostOfLink, packageOf } = writer;
    const task = tidyText(draft.task);
    const title = task.length > mostOfTitle ? `${task.slice(0, mostOfTitle)}…` : task || texts.scormTitle;
    const zip = await packageOf(link, oneFile, { language, title, ...scorm.sentences });
    download(`exercise-${digitsOf(link)}.zip`, 'application/zip', zip);
    asks = false;
    const written = scorm.written(zip.size);
    say(link.length > mostOfLink ? `${written} ${scorm.long(link.length)}` : written, link);
  }

  return {
    asks: () => asks,

    /** @param {string} link @param {Exercise} draft */
    template(link, draft) {
      const attempt = async (/** @type {() => Promise<Uint8Array | null>} */ read) => {
        say(scorm.writing);
        try {
          const oneFile = await read();
          if (oneFile) return await write(link, draft, oneFile);
          asks = true;
          say(scorm.choose(fileName));
        } catch (error) {
          say(scorm.failed(messageOf(error)));
        }
      };
      const chosen = async (/** @type {Event} */ event) => {
        const [file] = /** @type {HTMLInputElement} */ (event.target).files ?? [];
        if (!file) return;
        await attempt(async () => {
          const content = new Uint8Array(await file.arrayBuffer());
          return isOneFile(content) ? content : null;
        });
      };
      return html`<button id="maker-scorm" type="button" @click=${() => attempt(besideThePage)}>${texts.scormButton}</button>
        ${asks ? html`<input id="maker-scorm-file" type="file" accept=".html" aria-label=${texts.scormFile} @change=${chosen}>` : nothing}`;
    },
  };
}
