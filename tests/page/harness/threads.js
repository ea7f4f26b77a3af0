// The page's worker under Node: a thread that looks like a Worker to the pool, and like a worker's scope to the worker.
import { Worker } from 'node:worker_threads';

const scope = `
  const { parentPort } = require('node:worker_threads');
  globalThis.addEventListener = (type, listener) => parentPort.on(type, (data) => listener({ data }));
  globalThis.postMessage = (message, { transfer }) => parentPort.postMessage(message, transfer);
  import(${JSON.stringify(new URL('../../../www/core/worker.js', import.meta.url))});
`;

export class Thread extends EventTarget {
  #thread = new Worker(scope, { eval: true });

  /** @param {WebAssembly.Module} core */
  constructor(core) {
    super();
    this.#thread.on('message', (data) => this.dispatchEvent(new MessageEvent('message', { data })));
    this.#thread.on('error', ({ message }) =>
      this.dispatchEvent(Object.assign(new Event('error', { cancelable: true }), { message })),
    );
    this.#thread.postMessage({ core });
  }

  /** @param {unknown} message */
  postMessage(message) {
    this.#thread.postMessage(message);
  }

  terminate() {
    this.#thread.terminate();
  }
}
