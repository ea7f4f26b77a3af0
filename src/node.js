// The entry of the npm package under Node, whose fetch reads no files: the core comes from the disk, its own or the one that is named.
import { readFile } from 'node:fs/promises';
import load from '../pkg/ep_locomotion.js';

export * from '../pkg/ep_locomotion.js';

/** @type {typeof load} */
export default async function init(source) {
  const { module, module_or_path } = /** @type {any} */ (source ?? {});
  // Its own only where it is wanted: in some bundles nothing says where they lie.
  const from = (await (module ?? module_or_path)) ?? new URL('../pkg/ep_locomotion_bg.wasm', import.meta.url);
  const address = String(from.href ?? from);
  if (!address.startsWith('file:')) return load({ module: from });
  const bytes = readFile(new URL(address));
  // Where the core is ready already nobody else hears that they cannot be read.
  bytes.catch(() => {});
  return load({ module: bytes });
}
