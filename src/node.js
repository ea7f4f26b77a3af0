// The entry of the npm package under Node, whose fetch reads no files: the core comes from the disk, its own or the one that is named.
import { readFile } from 'node:fs/promises';
import load from '../pkg/ep_locomotion.js';

export * from '../pkg/ep_locomotion.js';

const core = new URL('../pkg/ep_locomotion_bg.wasm', import.meta.url);

/** @type {typeof load} */
export default async function init(source) {
  const { module, module_or_path } = /** @type {any} */ (source ?? {});
  const from = (await (module ?? module_or_path)) ?? core;
  const address = String(from.href ?? from);
  return load({ module: address.startsWith('file:') ? readFile(new URL(address)) : from });
}
