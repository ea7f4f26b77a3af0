// npm run bench [-- --json] [-- --against other/pkg]: the same work in plain JavaScript, as WebAssembly and natively, one after
// the other; and what calls from JavaScript cost, of the core in pkg/ and of another build.
//
// What counts are the ratios within one run: absolute times depend on the machine and on what else it does.
import { execFileSync } from 'node:child_process';
import { copyFileSync, readFileSync } from 'node:fs';
import os from 'node:os';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { optimise } from '../.tasks/build.mjs';
import { measureCalls } from './calls.mjs';
import { drive } from './episode.js';

const rounds = 9;
// With four times as many, what is measured natively is how the system hands out the memory for their results.
const robots = 64 * 64;
const { values } = parseArgs({
  options: { json: { type: 'boolean', default: false }, against: { type: 'string' } },
});
const top = fileURLToPath(new URL('..', import.meta.url));
const cargo = (/** @type {string[]} */ ...args) =>
  execFileSync('cargo', args, { cwd: top, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });

const target = ['--target', 'wasm32-unknown-unknown', '--target-dir', 'target'];
cargo('build', '--release', ...target, '--example', 'bench_wasm');
const built = 'target/wasm32-unknown-unknown/release/examples/bench_wasm.wasm';
copyFileSync(`${top}/${built}`, `${top}/target/bench.wasm`);
await optimise('target/bench.wasm');
const wasm = await instance('target/bench.wasm');
const native = JSON.parse(cargo('bench', '--bench', 'native', '--', String(rounds), String(robots)));

const cases = [
  { name: 'runs of 200 samples', position: 0, horizon: 2 },
  { name: 'a landscape, runs of different lengths', position: 0.05, horizon: 10 },
];
const results = cases.map((options, number) => {
  const samples = wasm.samples(number, robots);
  checkSame(javascript(options), wasm.scalar(number, robots), wasm.lanes(number, robots));
  const perSample = (/** @type {number[]} */ times) => ({
    least: (Math.min(...times) * 1e6) / samples,
    median: (median(times) * 1e6) / samples,
  });
  return {
    case: options.name,
    robots,
    samples,
    nsPerSample: {
      javascript: perSample(measure(() => javascript(options))),
      wasmScalar: perSample(measure(() => wasm.scalar(number, robots))),
      wasmLanes: perSample(measure(() => wasm.lanes(number, robots))),
      nativeScalar: perSample(native[`scalar${number}`]),
      nativeLanes: perSample(native[`lanes${number}`]),
    },
  };
});
const whole = {
  evolution: median(measure(() => wasm.evolution(20, 200, 10))),
  landscape64: median(measure(() => wasm.landscape(64))),
  landscape128: median(measure(() => wasm.landscape(128))),
  landscape256: median(measure(() => wasm.landscape(256))),
  population20: median(measure(() => wasm.evolution(20, 20, 1))),
  population40: median(measure(() => wasm.evolution(40, 20, 1))),
  population80: median(measure(() => wasm.evolution(80, 20, 1))),
  horizon1: median(measure(() => wasm.evolution(80, 20, 1))),
  horizon05: median(measure(() => wasm.evolution(80, 20, 0.5))),
  seeds100: median(measure(() => wasm.seeds())),
};

const calls = await measureCalls(top, values.against, rounds);

const machine = { processor: os.cpus()[0].model, cores: os.cpus().length, node: process.version };
if (values.json)
  console.log(JSON.stringify({ machine, rounds, results, milliseconds: whole, calls }, null, 2));
else print();

/** The module without its JavaScript glue, which this work never calls. @param {string} path */
async function instance(path) {
  const module = new WebAssembly.Module(readFileSync(`${top}/${path}`));
  /** @type {Record<string, Record<string, () => void>>} */
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = () => {
      throw new Error(`${from}.${name} is not there`);
    };
  }
  const { exports } = await WebAssembly.instantiate(module, imports);
  return /** @type {Record<'lanes' | 'scalar' | 'samples' | 'evolution' | 'landscape' | 'seeds', (...args: number[]) => number>} */ (
    /** @type {unknown} */ (exports)
  );
}

/** Sum of J over the same robots as in work.rs. @param {{ position: number, horizon: number }} options */
function javascript(options) {
  const side = Math.ceil(Math.sqrt(robots));
  const value = (/** @type {number} */ i) => 0.5 + (9.5 * i) / (side - 1);
  const start = { x: 0, y: 0, theta: 0 };
  const goal = { x: 2, y: 2, theta: Math.PI / 4 };
  let sum = 0;
  for (let i = 0; i < robots; i++) {
    sum += drive(start, goal, options, value(i % side), 0.1, value(Math.floor(i / side)));
  }
  return sum;
}

/** @param {number} javascriptSum @param {number} scalar @param {number} lanes */
function checkSame(javascriptSum, scalar, lanes) {
  if (scalar !== lanes) throw new Error(`lanes give ${lanes}, single robots ${scalar}`);
  // Where a robot circles near the goal, the last bits of Math.sin decide.
  if (Math.abs(javascriptSum / scalar - 1) > 1e-3)
    throw new Error(`JavaScript gives ${javascriptSum}, the core ${scalar}`);
}

/** Milliseconds of each round, after one to warm up. @param {() => number} work */
function measure(work) {
  work();
  return Array.from({ length: rounds }, () => {
    const start = performance.now();
    work();
    return performance.now() - start;
  });
}

/** What a user feels, as one number each. @param {NonNullable<Awaited<ReturnType<typeof measureCalls>>>} measured */
function ratios({ calls, other }) {
  const least = (/** @type {string} */ name) => calls[name].least;
  const times = (/** @type {number} */ a, /** @type {number} */ b) => `${(a / b).toPrecision(2)} ×`;
  const plain = 'evaluate, one triple';
  const beside = other[plain]
    ? [['the other build, by a task', times(other[plain].least, least(`a task: ${plain}`))]]
    : [];
  return [
    ['a plain evaluation, by a task', times(least(plain), least(`a task: ${plain}`))],
    ...beside,
    ['1000 starts read, by driven', times(least('read 1000 starts'), least('drive from 1000 starts'))],
    ['side by side', times(least('read 1000 starts side by side'), least('drive from 1000 starts'))],
    ['a sample of a run', `${((least('a task: simulate, 1001 samples') * 1e3) / 1001).toFixed(0)} ns`],
  ];
}

/** @param {number[]} values */
function median(values) {
  return [...values].sort((a, b) => a - b)[values.length >> 1];
}

function print() {
  console.log(
    `${machine.processor}, ${machine.cores} cores, Node ${machine.node}; ${rounds} rounds, the least and the median`,
  );
  for (const { case: name, samples, nsPerSample } of results) {
    console.log(`\n${name}: ${robots} robots, ${(samples / robots).toFixed(0)} samples each on average`);
    for (const [kind, { least, median }] of Object.entries(nsPerSample)) {
      const ratio = (nsPerSample.javascript.least / least).toFixed(1);
      console.log(
        `  ${kind.padEnd(14)}${least.toFixed(2).padStart(7)}${median.toFixed(2).padStart(8)} ns a robot's sample${ratio.padStart(7)} × JavaScript`,
      );
    }
  }
  console.log('\nwhole jobs as WebAssembly, one core');
  for (const [name, ms] of Object.entries(whole))
    console.log(`  ${name.padEnd(14)}${ms.toFixed(1).padStart(8)} ms`);
  if (calls === null) {
    console.log('\nwhat calls cost: npm run build -- core builds pkg/, of which this is measured');
    return;
  }
  console.log('\ncalls from JavaScript');
  for (const [name, { least, median }] of Object.entries(calls.calls)) {
    const other = calls.other[name];
    const ratio = other ? `${(other.least / least).toFixed(1).padStart(8)} × the other build` : '';
    console.log(
      `  ${name.padEnd(58)}${least.toFixed(1).padStart(9)}${median.toFixed(1).padStart(9)} µs${ratio}`,
    );
  }
  console.log('\nratios of the least times');
  for (const [name, text] of ratios(calls)) console.log(`  ${name.padEnd(58)}${text.padStart(12)}`);
}
