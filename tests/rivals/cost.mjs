// J of gains for a program in another language: reads a count and so many triples of doubles, writes as many doubles, until the input ends.
import { readSync, writeSync } from 'node:fs';
import init, { experiment, Task } from '../../src/node.js';

await init();
const task = new Task(experiment('velocity-limits'));

/** @param {number} size @returns {Buffer | null} */
function read(size) {
  const bytes = Buffer.alloc(size);
  for (let at = 0; at < size; ) {
    const count = readSync(0, bytes, at, size - at, null);
    if (count === 0) return null;
    at += count;
  }
  return bytes;
}

for (let head = read(4); head; head = read(4)) {
  const body = read(24 * head.readUInt32LE());
  if (!body) break;
  const gains = new Float64Array(body.buffer, body.byteOffset, body.length / 8);
  const costs = task.evaluate(gains);
  const answer = Buffer.from(costs.buffer, costs.byteOffset, costs.byteLength);
  for (let at = 0; at < answer.length; ) at += writeSync(1, answer, at);
}
