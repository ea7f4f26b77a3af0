// Serves a built site as static hosts do: compressed, and what has a hash in its name to be kept.
import { readFile } from 'node:fs/promises';
import { join, normalize, sep } from 'node:path';
import { gzipSync } from 'node:zlib';
import { listen, typeOf } from '../tests/page/harness/http.js';

/** @param {string} root @returns {Promise<{ address: string, sent: Map<string, number>, close: () => Promise<void> }>} `sent`: what was asked for since it was last emptied, and its size. */
export async function serveCompressed(root) {
  /** @type {Map<string, number>} */
  const sent = new Map();
  const { port, close } = await listen(async (request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const inside = normalize(pathname === '/' ? 'index.html' : decodeURIComponent(pathname).slice(1));
    const isOutside = inside === '..' || inside.startsWith(`..${sep}`);
    const content = isOutside ? null : await readFile(join(root, inside)).catch(() => null);
    if (content === null) {
      response.writeHead(404).end();
      return;
    }
    const compressed = gzipSync(content, { level: 9 });
    sent.set(pathname, compressed.length);
    response.writeHead(200, {
      'Content-Type': typeOf(inside),
      'Content-Encoding': 'gzip',
      'Content-Length': compressed.length,
      'Cache-Control': pathname.includes('/assets/') ? 'max-age=31536000, immutable' : 'no-cache',
    });
    response.end(compressed);
  });
  return { address: `http://localhost:${port}/`, sent, close };
}
