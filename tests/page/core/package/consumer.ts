// What a strict TypeScript project sees of the package: exact types, and errors where there is a mistake.
import init, {
  type Cost,
  type Experiment,
  type Individual,
  type Run,
  type Sample,
  type Statistics,
  Evolution,
  Simulation,
  errorParts,
  evaluate,
  experiment,
  fares,
  fields,
  landscape,
  lawTerms,
  learningRates,
  paper,
  randomSeed,
  remainingErrors,
  robustness,
  seedRuns,
  simulate,
  simulateAll,
  startsOnCircle,
  startsOnGrid,
  version,
  winsBout,
} from 'ep-locomotion';
import { type LinkedRun, openLink } from 'ep-locomotion/link';

type Same<A, B> = (<T>() => T extends A ? 1 : 2) extends <T>() => T extends B ? 1 : 2 ? true : false;
/** A value of exactly this type; `any` is of no type but itself. */
function exactly<Wanted>() {
  return <Given>(_value: Given, ..._same: Same<Given, Wanted> extends true ? [] : ['another type']) => {};
}

await init({ module: new Uint8Array(8) });
await init();
const gains = Float64Array.of(3.23673, 0.09678, 5.17891);
const e = experiment('velocity-limits');
exactly<Experiment>()(e);
exactly<number | null>()(e.limits.speed);
exactly<[number, number, number]>()(e.weights.final);
exactly<Experiment>()(experiment({ horizon: 5, goal: { x: 1 } }));

const frozen = {
  goal: { x: 3 },
  weights: { final: [1, 1, 1] },
  evolution: { initialRange: [0, 5] },
} as const;
exactly<Experiment>()(experiment(frozen));
exactly<Experiment>()(experiment({ horizon: 5 }, 'acceleration-limits'));
exactly<Experiment>()(experiment('acceleration-limits', { horizon: 5 }));
exactly<LinkedRun>()(openLink('lab&seed=7'));
exactly<Experiment>()(openLink('lab').experiment);

const run = simulate(e, gains, 0);
exactly<Run>()(run);
exactly<Cost>()(run.cost);
exactly<number>()(run.cost.total);
exactly<Float64Array>()(run.x);
exactly<boolean>()(run.arrived);
exactly<'arrived' | 'horizon' | 'diverged'>()(run.outcome);
exactly<Run[]>()(simulateAll(e, [3, 0.1, 5]));
exactly<Float64Array>()(evaluate(e, gains));

const sample = new Simulation(e, gains).step();
exactly<Sample>()(sample);
exactly<number>()(sample.velocity.linear);
exactly<number>()(sample.lyapunovRate);

const evolution = new Evolution(e);
exactly<Statistics>()(evolution.step());
exactly<Individual>()(evolution.statistics().best);
exactly<Individual[]>()(evolution.population());
exactly<number[][]>()(evolution.record(evolution.generation).opponents);
exactly<string>()(evolution.hash());
exactly<number>()(evolution.mostDrivenAgain);

const cells = {
  x: { gain: 'kx', from: 1, to: 10, count: 8 },
  y: { gain: 'ky', from: 0.1, to: 10, count: 8, log: true },
  gains: [0, 0, 5],
} as const;
exactly<Float64Array>()(landscape(e, { ...cells, rows: [0, 4] }));
exactly<Uint8Array>()(fares(e, gains).arrived);
exactly<Uint8Array>()(
  robustness(e, { gains, x: { from: -1, to: 1, count: 3 }, y: { from: -1, to: 1, count: 3 }, headings: 4 })
    .arrived,
);
exactly<Float64Array>()(errorParts(e, gains)[0].ySet);
exactly<Float64Array>()(remainingErrors(e, gains, 1).error.x);
exactly<Individual>()(seedRuns(e, { seeds: [0, 2], generations: 3 })[0].champion);
exactly<number>()(startsOnCircle({ x: 0, y: 0, radius: 1, count: 4, seed: 1 })[0].theta);
const grid = { x: { from: -1, to: 1, count: 3 }, y: { from: -1, to: 1, count: 3 }, headings: 4 };
exactly<number>()(startsOnGrid({ ...grid, part: [0, 5] })[0].theta);
exactly<number>()(lawTerms(e, gains, sample.error).command.kx.linear);
exactly<boolean>()(winsBout(1, 2));
exactly<number[]>()(evolution.record(evolution.generation).ranking);
exactly<boolean>()(fields()[0].nullable);
exactly<[number, number, number]>()(paper()[0].gains);
exactly<number>()(learningRates().common);
exactly<number>()(randomSeed());
exactly<string>()(version());

// @ts-expect-error another type
exactly<string>()(run.cost.total);
// @ts-expect-error `any` is no number
exactly<number>()(JSON.parse('1'));
// @ts-expect-error no such preset
experiment('speed-limits');
// @ts-expect-error no such field
simulate({ horizn: 5 }, gains);
// @ts-expect-error no such part of the cost
run.cost.time2;
// @ts-expect-error no such gain
landscape(e, { ...cells, x: { gain: 'kz', from: 1, to: 10, count: 8 } });
