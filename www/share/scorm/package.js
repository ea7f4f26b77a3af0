// An exercise as a package for learning platforms that take SCORM 1.2: the whole page in one file, what stands between it and the
// platform, and the list of both.
import { Zip, ZipDeflate, strToU8 } from 'fflate';
import { digitsOf } from '../../kit/hash.js';
import { createTurns } from '../../kit/loop.js';
import { escaped } from '../../kit/markup.js';
import page from './files/index.html?raw';
import runtime from './files/runtime.js?raw';

/** @typedef {{ language: string, title: string, refused: string, tooLong: string, noRoom: string, changed: string, kept: string, nobody: string }} Sentences What the package says by itself. */

/** Of a link, in characters: with a longer one a receipt and what is done after it do not both fit into what a platform keeps. */
export const mostOfLink = 1900;

/** The same exercise gives the same bytes. */
const time = new Date(1995, 0, 1);
/** So much is made smaller between two turns of the browser. */
const slice = 65_536;

/** @param {string} id @param {string} title @param {readonly string[]} names */
const manifest = (id, title, names) => `<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="ep-locomotion-${id}" version="1.2"
  xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
  xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata><schema>ADL SCORM</schema><schemaversion>1.2</schemaversion></metadata>
  <organizations default="course">
    <organization identifier="course">
      <title>${escaped(title)}</title>
      <item identifier="exercise" identifierref="page"><title>${escaped(title)}</title></item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="page" type="webcontent" adlcp:scormtype="sco" href="${names[0]}">
${names.map((name) => `      <file href="${name}"/>`).join('\n')}
    </resource>
  </resources>
</manifest>
`;

/**
 * The zip. The one file is given as it was built; a link is what follows the #.
 * @param {string} link @param {Uint8Array} oneFile @param {Sentences} texts @returns {Promise<Blob>}
 */
export function packageOf(link, oneFile, texts) {
  const about = JSON.stringify({ link, texts }).replaceAll('<', '\\u003c');
  const files = new Map([
    ['index.html', strToU8(page)],
    ['exercise.js', strToU8(`globalThis.exercise = ${about};\n`)],
    ['runtime.js', strToU8(runtime)],
    ['ep-locomotion.html', oneFile],
  ]);
  const list = manifest(digitsOf(link), texts.title, [...files.keys()]);
  return zipped(new Map([['imsmanifest.xml', strToU8(list)], ...files]));
}

/** @param {ReadonlyMap<string, Uint8Array>} files */
async function zipped(files) {
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  const zip = new Zip((error, part) => {
    if (error) throw error;
    parts.push(/** @type {Uint8Array<ArrayBuffer>} */ (part));
  });
  const turn = createTurns(12);
  for (const [name, content] of files) {
    const file = Object.assign(new ZipDeflate(name), { mtime: time });
    zip.add(file);
    for (let at = 0; at < content.length; at += slice) {
      file.push(content.subarray(at, at + slice), at + slice >= content.length);
      await turn();
    }
  }
  zip.end();
  return new Blob(parts, { type: 'application/zip' });
}
