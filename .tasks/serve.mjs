// Serves a built site as static hosts do: compressed, and what has a hash in its name to be kept.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { gzipSync } from 'node:zlib';

/** @type {Record<string, string>} */
const types = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
};

/** @param {string} root @returns {Promise<{ address: string, sent: Map<string, number>, close: () => Promise<void> }>} `sent`: what was asked for since it was last emptied, and its size. */
export async function serveCompressed(root) {
  /** @type {Map<string, number>} */
  const sent = new Map();
  const server = createServer(async (request, response) => {
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
      'Content-Type': types[extname(inside)] ?? 'application/octet-stream',
      'Content-Encoding': 'gzip',
      'Content-Length': compressed.length,
      'Cache-Control': pathname.includes('/assets/') ? 'max-age=31536000, immutable' : 'no-cache',
    });
    response.end(compressed);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(null)));
  const address = server.address();
  if (address === null || typeof address === 'string') throw new Error('the server has no port');
  return {
    address: `http://localhost:${address.port}/`,
    sent,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
