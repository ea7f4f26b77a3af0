// What wasm-bindgen writes beside the module, as the package gives it: a call before init() says so, and so does one of what was
// freed, or for which no memory is left; nothing in sight has a name of the core's inside, and the types need no library but the language's own.
import { readFileSync, writeFileSync } from 'node:fs';

/** Each text stands there once, or wasm-bindgen has changed. @type {readonly (readonly [string, string])[]} */
const glue = [
  [
    'let wasmModule, wasmInstance, wasm;',
    `const absent = new Proxy({}, {
    get() {
        throw new Error('ep-locomotion: call init() and wait for it before anything else');
    },
});
// Of what is freed the pointer is 0.
function alive({ __wbg_ptr }) {
    if (__wbg_ptr === 0) throw new Error('ep-locomotion: it was freed, and is not to be used any more');
    return __wbg_ptr;
}
// What stops without a word has found no memory.
function told(exports) {
    const wrap = (call) => (...given) => {
        try {
            return call(...given);
        } catch (error) {
            if (!(error instanceof WebAssembly.RuntimeError)) throw error;
            throw new WebAssembly.RuntimeError('ep-locomotion: its memory is used up; free() what is kept', { cause: error });
        }
    };
    return Object.fromEntries(Object.entries(exports).map(([name, one]) => [name, typeof one === 'function' ? wrap(one) : one]));
}
let wasmModule, wasmInstance, wasm = absent;`,
  ],
  [
    'function initSync(module) {\n    if (wasm !== undefined) return wasm;',
    'function initSync(module) {\n    if (wasm !== absent) return wasm;',
  ],
  [
    'async function __wbg_init(module_or_path) {\n    if (wasm !== undefined) return wasm;',
    'async function __wbg_init(module_or_path) {\n    if (wasm !== absent) return wasm;',
  ],
  // What was made meanwhile lives in the memory of the first.
  [
    'function __wbg_finalize_init(instance, module) {',
    'function __wbg_finalize_init(instance, module) {\n    if (wasm !== absent) return wasm;',
  ],
  // What is no core is not kept, so that another can be loaded.
  [
    'wasm = instance.exports;\n    wasmModule = module;',
    `if (typeof instance.exports.__wbindgen_start !== 'function' || typeof instance.exports.evaluate !== 'function')
        throw new Error('ep-locomotion: what init() was given is not its core');
    wasm = told(instance.exports);
    wasmModule = module;`,
  ],
  [
    '({module_or_path} = module_or_path)',
    'module_or_path = module_or_path.module ?? module_or_path.module_or_path',
  ],
];

const end = `/** The core's address (under Node a URL of file:, no path) or answer, or its bytes; the file beside this one if it is left out. */
export type InitInput = string | { readonly href: string } | { arrayBuffer(): Promise<ArrayBuffer> } | ArrayBuffer | ArrayBufferView | object;

/** What the core lives in. */
export interface InitOutput {
    readonly memory: { readonly buffer: ArrayBuffer };
}

/** Its bytes, or a compiled module. */
export type SyncInitInput = ArrayBuffer | ArrayBufferView | object;

/** Makes the core ready from its bytes, or from a compiled module, at once. */
export function initSync(from: { module: SyncInitInput }): InitOutput;

/** Makes the core ready. Nothing else can be called before. */
export default function init(from?: { module: InitInput | Promise<InitInput> }): Promise<InitOutput>;
`;

/** Tidies what stands in a folder. @param {string} folder */
export function tidyGlue(folder) {
  const [script, types] = ['ep_locomotion.js', 'ep_locomotion.d.ts'].map((name) => `${folder}/${name}`);
  let text = readFileSync(script, 'utf8');
  for (const [from, to] of glue) {
    if (text.split(from).length !== 2) throw new Error(`${script} has not once: ${from}`);
    text = text.replace(from, to);
  }
  const used = /(wasm\.\w+\(|const ptr = )this\.__wbg_ptr\b/g;
  if (!used.test(text)) throw new Error(`${script} has no pointers`);
  // `using` frees what somebody may have freed before its block ends.
  const freeing = /^ {4}free\(\) \{\n/gm;
  if (!freeing.test(text)) throw new Error(`${script} has nothing that is freed`);
  text = text.replace(freeing, '$&        if (this.__wbg_ptr === 0) return;\n');
  writeFileSync(script, withoutStart(text.replace(used, '$1alive(this)'), script));

  const declared = readFileSync(types, 'utf8');
  const at = declared.indexOf('export type InitInput');
  if (at < 0) throw new Error(`${types} has no InitInput`);
  writeFileSync(types, withoutStart(declared.slice(0, at), types) + end);
}

/** Without what the core calls itself when it is made ready. @param {string} text @param {string} file */
function withoutStart(text, file) {
  const parts = text.split(
    /\/\*\*(?:(?!\*\/).)*\*\/\nexport function throw_panics\(\)(?:: void;| \{\n[^}]*\})\n+/s,
  );
  if (parts.length !== 2) throw new Error(`${file} has not one throw_panics`);
  return parts.join('');
}
