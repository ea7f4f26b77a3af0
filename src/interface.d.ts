/// <reference lib="esnext.disposable" />
/** A posture p = (x, y, θ), equation (1): metres and radians, θ counter-clockwise from the X axis. */
export interface Posture { x: number; y: number; theta: number }
/** A velocity q = (v, ω): m/s and rad/s. */
export interface Velocity { linear: number; angular: number }
/** The name of one of the paper's two experiments: Figures 4 and 5, or Figures 6 and 7. */
export type Preset = 'velocity-limits' | 'acceleration-limits';
/** Three gains (kx, ky, kθ), or such triples one after the other: at most a million in one call. */
export type Gains = Float64Array | readonly number[];
/** Everything that defines a run. Every number's range is in `fields()`, every word in `wordFields()`. */
export interface Experiment {
  /** The control law: (5) of the paper, or the rule of Kanayama et al. (1990). */
  law: 'shim-kim' | 'kanayama';
  /** Where the robot starts; with several, its cost is the mean over all of them. */
  starts: Posture[];
  /** The reference posture p_r. */
  goal: Posture;
  /** The reference velocity q_r; (0, 0) means parking, anything else tracking a moving reference. */
  referenceVelocity: Velocity;
  /** Seconds between two commands. */
  sampleTime: number;
  /** Seconds after which a robot that has not arrived is stopped. */
  horizon: number;
  /** m/s, rad/s, m/s², rad/s²; null means not limited. */
  limits: { speed: number | null; turnRate: number | null; acceleration: number | null; turnAcceleration: number | null };
  /** The robot has arrived when it is this near to the goal: metres, radians. */
  tolerance: { position: number; heading: number };
  /** W on (x, y, θ), R on (v, ω), and κ, of the cost (9). */
  weights: { final: [number, number, number]; velocity: [number, number]; penalty: number };
  /** What is added to the applied velocity: fresh noise in ±(linear, angular) at each sample, or a constant slip. */
  disturbance: { kind: 'none' | 'random' | 'slip'; linear: number; angular: number; seed: number };
  /** The settings of evolutionary programming. */
  evolution: { population: number; opponents: number; seed: number; initialRange: [number, number]; initialSigma: number };
}
/** An experiment in which any field may be left out; the preset `velocity-limits` fills it in. */
export type PartialExperiment = {
  [K in keyof Experiment]?: Experiment[K] extends unknown[] ? Experiment[K]
    : Experiment[K] extends object ? Partial<Experiment[K]> : Experiment[K];
};
/** The cost J of equation (9) and its parts; total is their sum. Lower is better; Infinity if the run left the finite numbers. */
export interface Cost { total: number; time: number; finalError: number; path: number; energy: number; penalty: number }
/** How a run ended. */
export type Outcome = 'arrived' | 'horizon' | 'diverged';
/** One run: arrays with one value a sample, the first at time 0, the last where the run ended. */
export interface Run {
  /** Seconds. */
  time: Float64Array;
  /** Metres. */
  x: Float64Array;
  /** Metres. */
  y: Float64Array;
  /** Radians, not wrapped. */
  theta: Float64Array;
  /** The velocity applied from this sample to the next, after the limits, m/s; the last sample repeats the one before. */
  linear: Float64Array;
  /** The same for the turn rate, rad/s. */
  angular: Float64Array;
  /** The velocity that the control law asked for, before the limits, m/s. */
  commandLinear: Float64Array;
  /** The same for the turn rate, rad/s. */
  commandAngular: Float64Array;
  /** The reference posture, which moves when the reference velocity is not zero: metres. */
  referenceX: Float64Array;
  /** Metres. */
  referenceY: Float64Array;
  /** Radians. */
  referenceTheta: Float64Array;
  /** The path's part of J that is paid until the sample: ½ ∫ (p − p_r)ᵀ(p − p_r) dt from 0. */
  pathCost: Float64Array;
  /** The energy's part of J that is paid until the sample: ½ ∫ qᵀ R q dt from 0. */
  energyCost: Float64Array;
  cost: Cost;
  outcome: Outcome;
  arrived: boolean;
  /** t_f in seconds: the arrival time, or the horizon. */
  finalTime: number;
}
/** The robot at one sample. */
export interface Sample {
  time: number;
  posture: Posture;
  /** The reference posture, which moves when the reference velocity is not zero. */
  reference: Posture;
  /** What the control law asks for. */
  command: Velocity;
  /** What the limits leave of it; it is applied until the next sample. */
  velocity: Velocity;
  /** The error posture (3), in the frame of the reference: metres, and radians in (−π, π]. */
  error: Posture;
  /** V = ½ x_e² + ½ y_e² + (1 − cos θ_e). */
  lyapunov: number;
  /** dV/dt with the applied velocity. */
  lyapunovRate: number;
  arrived: boolean;
  /** null while the robot drives. */
  outcome: Outcome | null;
}
/** One trial solution: gains, their strategy parameters σ, and its cost. */
export interface Individual { gains: [number, number, number]; sigmas: [number, number, number]; cost: number }
/** One generation in short. */
export interface Statistics {
  generation: number;
  /** Drives since the start, one for each individual and start posture. */
  evaluations: number;
  best: Individual;
  median: number;
  worst: number;
  /** Mean strategy parameter of each gain over the population. */
  meanSigmas: [number, number, number];
}
/** The standard normal draws that made one offspring. */
export interface Mutation { gains: [number, number, number]; common: number; sigmas: [number, number, number] }
/** How much a σ changes by itself, τ, and how much all three change together, τ'. */
export interface LearningRates { own: number; common: number }
/**
 * One generation in full. Solutions are numbered 0 to N − 1 for the parents and N to 2N − 1 for the offspring.
 * Generation 0 has only parents: the initial population in the order of its draws, all of which survive.
 */
export interface GenerationRecord {
  generation: number;
  parents: Individual[];
  offspring: Individual[];
  /** The draws behind each offspring. */
  mutations: Mutation[];
  /** For each of the 2N solutions, whom it met. */
  opponents: number[][];
  /** For each of the 2N solutions, how many bouts it won. */
  wins: number[];
  /** All of them, best ranked first: most wins first, then lower J, then lower number. */
  ranking: number[];
  /** The N that survive, best ranked first. */
  survivors: number[];
}
/** What the control law makes of an error posture. */
export interface LawTerms {
  /** What each gain asks for, and the reference velocity by itself: the command is their sum, up to rounding. */
  command: { kx: Velocity; ky: Velocity; ktheta: Velocity; reference: Velocity };
  /**
   * The parts of dV/dt on x_e, y_e and θ_e that the law promises for its command, m²/s, as in `Stability`. Null where nothing is
   * promised.
   */
  promised: Posture | null;
}
/** One axis of a landscape: `count` values of a gain from `from` to `to`, evenly spaced or, with `log`, evenly in the logarithm. */
export interface Axis { gain: 'kx' | 'ky' | 'ktheta'; from: number; to: number; count: number; log?: boolean }
/** The cells of a landscape of J over two gains. */
export interface Landscape {
  x: Axis;
  y: Axis;
  /** All three gains; the two on the axes are replaced. */
  gains: Gains;
  /** The rows [first, end) to compute; all when left out. */
  rows?: [number, number];
}
/** `count` values from `from` to `to`, evenly spaced. */
export interface Range { from: number; to: number; count: number }
/** Start postures at every position of a grid, with `headings` headings each, evenly around the circle from 0. */
export interface Grid {
  /** Metres. */
  x: Range;
  /** Metres. */
  y: Range;
  headings: number;
  /** The starts [first, end) to take; all when left out. All headings of a position stand together, then x varies, then y. */
  part?: [number, number];
}
/** The starts of a grid, and the gains of the robot that drives from them. */
export interface StartGrid extends Grid { gains: Gains }
/** One value for each start of a grid, or of an experiment. */
export interface Robustness {
  /** J. */
  cost: Float64Array;
  /** t_f in seconds. */
  finalTime: Float64Array;
  /** 1 where the robot arrived, else 0. */
  arrived: Uint8Array;
}
/** Which seeds [first, end) to run, and for how many generations. */
export interface SeedRuns { seeds: [number, number]; generations: number }
/** What evolution with one seed found, and random search with as many drives. */
export interface SeedRun {
  /** The best J of each generation, from 0. */
  best: Float64Array;
  /** The best individual in the end. */
  champion: Individual;
  /** The best J that random search had found by then; it begins with the same population. */
  random: Float64Array;
}
/**
 * The Lyapunov function V = ½ x_e² + ½ y_e² + w (1 − cos θ_e) along one run: arrays with one value a sample, those of `simulate`.
 * The last sample, where the run has ended, is taken as if the robot drove on.
 */
export interface Stability {
  /** Seconds. */
  time: Float64Array;
  /** x_e of the error posture (3), metres. */
  errorX: Float64Array;
  /** y_e, metres. */
  errorY: Float64Array;
  /** θ_e, radians in (−π, π]. */
  errorTheta: Float64Array;
  /** V, m². */
  lyapunov: Float64Array;
  /**
   * The part of dV/dt on x_e that the law promises for its commanded velocity, m²/s: −kx x_e² cos² θ_e for the law (5), −kx x² for
   * Kanayama's rule, x = x_e cos θ_e − y_e sin θ_e being how far the reference is ahead of the robot. NaN where nothing is promised.
   */
  promisedX: Float64Array;
  /** The part on y_e, m²/s: −ky y_e⁴, or 0 for Kanayama's rule. */
  promisedY: Float64Array;
  /** The part on θ_e, m²/s: −kθ sin² θ_e, or −v_r (kθ/ky) sin² θ_e for Kanayama's rule. */
  promisedTheta: Float64Array;
  /**
   * dV/dt under the velocity that the robot has from the sample on, after limits and disturbance, m²/s, from the rate of the error (4). Where
   * these leave the command as it is, it is the sum of the promised parts.
   */
  rate: Float64Array;
  /** 1 where the limits changed the command, else 0. */
  limited: Uint8Array;
  /** w, m²: 1 for the law (5), 1/ky for Kanayama's rule. Null if that has ky ≤ 0: then nothing is promised, and V is that of (5). */
  headingWeight: number | null;
}
/** The sizes of the error of one run over time that Theorem 2 bounds one by one: one value a sample. */
export interface ErrorParts {
  /** Seconds. */
  time: Float64Array;
  /** |x_e cos θ_e| in metres. */
  x: Float64Array;
  /** |y_e| in metres. */
  y: Float64Array;
  /** |sin θ_e|. */
  theta: Float64Array;
  /** How far the set of |y_e| reaches at this heading, (ε1 |sin θ_e| / ky)^⅓ in metres (7). */
  ySet: Float64Array;
}
/** |x_e cos θ_e| and |y_e| in metres, |sin θ_e|: one value for each start. */
export interface PartsOfStarts { x: Float64Array; y: Float64Array; theta: Float64Array }
/** What remains of the error at the end of each run, beside the sets of Theorem 2. */
export interface RemainingErrors {
  /** The largest in the last seconds; Infinity for a robot that left the finite numbers. */
  error: PartsOfStarts;
  /** How far the sets reach, ε1/kx (6), (ε1 |sin θ_e| / ky)^⅓ (7) and ε2/kθ (8); of (7) the farthest in the last seconds. */
  sets: PartsOfStarts;
}
/** Where start postures stand on a circle: its centre and radius in metres. */
export interface Circle { x: number; y: number; radius: number; count: number; seed: number }
/** The range of one numeric field of an experiment. */
export interface Field {
  /** Where it stands in the experiment; `[]` means each element. */
  path: string;
  /** Empty for a pure number. */
  unit: string;
  min: number;
  max: number;
  /** Whether it must be a whole number. */
  integer: boolean;
  /** Whether it may be null, for "not limited". */
  nullable: boolean;
}
/** A field of an experiment that is one of a few words. */
export interface WordField {
  /** Where it stands in the experiment. */
  path: string;
  /** What it may be. */
  words: string[];
}
/** What the paper states of one of its experiments. */
export interface PaperResult {
  preset: Preset;
  /** The figure's number in the paper. */
  figure: string;
  method: 'ep' | 'arbitrary';
  gains: [number, number, number];
  /** J as printed in the paper, whose weights are not given. */
  cost: number;
}
