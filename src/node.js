// The entry of the npm package under Node, whose fetch reads no files: without an argument the core comes from the disk.
import { readFile } from 'node:fs/promises';
import load from '../pkg/ep_locomotion.js';

export * from '../pkg/ep_locomotion.js';

const core = new URL('../pkg/ep_locomotion_bg.wasm', import.meta.url);

/** @type {typeof load} */
export default function init(source = { module: readFile(core) }) {
  return load(source);
}
