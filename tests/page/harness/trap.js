// A core that fails when it is asked for something, as after a panic.
import binaryen from 'binaryen';

/** The core with one function that traps. @param {Buffer} bytes @param {string} name */
export function withTrap(bytes, name) {
  const module = binaryen.readBinary(bytes);
  const { value } = binaryen.getExportInfo(module.getExport(name));
  /** @type {{ Function: { setBody(of: number, body: number): void } }} */ (
    /** @type {unknown} */ (binaryen)
  ).Function.setBody(module.getFunction(value), module.unreachable());
  const broken = Buffer.from(module.emitBinary());
  module.dispose();
  return broken;
}
