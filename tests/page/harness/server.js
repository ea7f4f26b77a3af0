// Serves the built site from a sub-folder, as a course's host would, under the strictest content security policy that it
// works under, and keeps a record of all that goes wrong.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { listen, typeOf } from './http.js';

const folder = '/some/course/ep/';
const collector = '/collector.js';
const blank = '/blank';
/** The origins of all sites that are served. @type {Set<string>} */
const served = new Set();
/** A page with nothing on it beside this one, if a site that is served has it: what a page has told its tab is told there alone. @param {string} address */
export function blankBeside(address) {
  const { origin } = new URL(address);
  return served.has(origin) ? origin + blank : null;
}
const dist = fileURLToPath(new URL('../../../dist/', import.meta.url));
/** Where pages find axe-core. */
export const axeAddress = '/axe.js';
const axe = fileURLToPath(import.meta.resolve('axe-core/axe.min.js'));
const reports = '/policy-reports';

/** What runs in every page before its own scripts. */
const scripts = ['collector.js', 'frames.js'].map((name) =>
  readFileSync(new URL(name, import.meta.url), 'utf8'),
);
/** By how many milliseconds every frame of the page, and every answer of its workers, comes late, as on a machine with much to do. */
const late = Number(process.env.LATE_FRAMES ?? 0);

/** All that the page needs, and nothing else. */
const strictest = {
  'default-src': "'none'",
  'script-src': "'self' 'wasm-unsafe-eval'",
  'style-src': "'self'",
  'connect-src': "'self'",
  'worker-src': "'self'",
  'img-src': "'self' data: blob:",
  // For the preview of an exercise in the making.
  'frame-src': "'self'",
  'base-uri': "'none'",
  'form-action': "'none'",
  'report-uri': reports,
};

/**
 * @typedef {object} Site
 * @property {string} address where the page is
 * @property {string} blank a page of the same site with nothing on it, from which a browser comes and to which it goes without starting a process
 * @property {string[]} problems requests that were refused or not found since the array was last emptied
 * @property {() => Promise<void>} close
 */

/**
 * What is otherwise than in the built site.
 * @typedef {object} Changes
 * @property {Record<string, string>} [policy] directives in the place of those of the strictest policy
 * @property {string} [before] a script that the page begins with
 * @property {(name: string, content: Buffer) => Buffer | null | Promise<Buffer | null>} [send] what is sent of a file
 */

/** @param {string} [root] the folder to serve @param {Changes} [changes] @returns {Promise<Site>} */
export async function serve(root = dist, { policy = {}, before = '', send = (_, content) => content } = {}) {
  const header = Object.entries({ ...strictest, ...policy })
    .map((directive) => directive.join(' '))
    .join('; ');
  /** @type {string[]} */
  const problems = [];
  const collectorText = [...scripts, before].join('\n');

  /** @param {string} path @returns {Promise<string | Buffer | null>} the body, or null if there is none */
  async function body(path) {
    if (path === collector) return collectorText;
    if (path === blank) return '<title>blank</title>';
    if (path === axeAddress) return readFile(axe);
    const inside = normalize(path.slice(folder.length) || 'index.html');
    if (!path.startsWith(folder) || inside.startsWith(`..${sep}`)) return null;
    const file = await readFile(join(root, inside)).catch(() => null);
    const content = file && (await send(inside, file));
    if (content === null || extname(inside) !== '.html') return content;
    // The collector has to run before any script of the page.
    return content
      .toString()
      .replace(/<head[^>]*>/i, `$&<script src="${collector}" data-late="${late}"></script>`);
  }

  /** A name in assets/ has a hash of what is in it; in a copy of the site that may have been changed. @param {string} path */
  const stays = (path) => path === axeAddress || (root === dist && path.includes('/assets/'));

  const { port, close } = await listen(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname);
    if (path === reports) {
      let text = '';
      for await (const part of request) text += part;
      const report = JSON.parse(text)['csp-report'];
      problems.push(
        `policy: ${report['violated-directive']} refuses ${report['blocked-uri']} in ${report['document-uri']}`,
      );
      response.writeHead(204).end();
      return;
    }
    const content = await body(path);
    // Browsers look for this one by themselves.
    if (content === null && path !== '/favicon.ico') problems.push(`not found: ${request.method} ${path}`);
    response.writeHead(content === null ? 404 : 200, {
      'Content-Type': typeOf(path),
      'Content-Security-Policy': header,
      'Cache-Control': content !== null && stays(path) ? 'max-age=31536000, immutable' : 'no-store',
    });
    response.end(content);
  });
  const origin = `http://localhost:${port}`;
  served.add(origin);
  return {
    address: origin + folder,
    blank: origin + blank,
    problems,
    close: () => {
      served.delete(origin);
      return close();
    },
  };
}

/** Something is done with a page that begins with this script. @param {import('./browsers.js').Page} page @param {string} before @param {() => Promise<void>} act */
export async function beginningWith(page, before, act) {
  const site = await serve(undefined, { before });
  const usual = page.site;
  page.site = site;
  try {
    await act();
    assert.deepEqual(await page.problems(), []);
  } finally {
    await page.leave();
    page.site = usual;
    await site.close();
  }
}
