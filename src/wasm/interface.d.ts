// Written by tests/types.rs from the tables in the Rust sources.
/// <reference lib="esnext.disposable" />
/**
 * Everything that defines a run. The same experiment gives the same bits on every machine. Every number's range is in
 * `fields()`, every word in `wordFields()`.
 */
export interface Experiment {
  /** The control law: (5) of the paper, or the rule of Kanayama et al. (1990). */
  law: Law;
  /** Where the robot starts: 1 to 10 000 postures. With several, its cost is the mean over all of them. */
  starts: Posture[];
  /** The reference posture p_r. */
  goal: Posture;
  /**
   * The reference velocity q_r. (0, 0) means parking; anything else means tracking: the reference moves from the
   * goal along its own arc, there is no arrival, and the run lasts until the horizon. That is our choice: all
   * experiments of the paper park.
   */
  referenceVelocity: Velocity;
  /** Seconds between two commands. */
  sampleTime: number;
  /** Seconds after which a robot that has not arrived is stopped; at most 100 000 times `sampleTime`. */
  horizon: number;
  /** Limits of velocity and acceleration. */
  limits: Limits;
  /** How near counts as arrived. */
  tolerance: Tolerance;
  /** W, R and κ of the cost (9). */
  weights: Weights;
  /** What is added to the applied velocity. */
  disturbance: Disturbance;
  /** The settings of evolutionary programming. */
  evolution: EvolutionSettings;
}
/** The control law: how the commanded velocity follows from the error posture. */
export type Law = 'shim-kim' | 'kanayama';
/** A posture p = (x, y, θ) in the global frame, equation (1). */
export interface Posture {
  /** x in metres. */
  x: number;
  /** y in metres. */
  y: number;
  /** θ in radians, counter-clockwise from the X axis. */
  theta: number;
}
/** A velocity q = (v, ω). */
export interface Velocity {
  /** v in m/s, positive forwards. */
  linear: number;
  /** ω in rad/s, positive counter-clockwise. */
  angular: number;
}
/** Limits of velocity and acceleration; null means not limited. */
export interface Limits {
  /** Largest |v| in m/s. */
  speed: number | null;
  /** Largest |ω| in rad/s. */
  turnRate: number | null;
  /** Largest |dv/dt| in m/s². */
  acceleration: number | null;
  /** Largest |dω/dt| in rad/s². */
  turnAcceleration: number | null;
}
/** How near to the goal, and how slow, counts as arrived. That the presets look at no velocity is our choice. */
export interface Tolerance {
  /** Largest √(x_e² + y_e²) in metres. */
  position: number;
  /** Largest |θ_e| in radians. */
  heading: number;
  /** Largest |v| in m/s of the sample before; null means that v is not looked at. */
  speed: number | null;
  /** Largest |ω| in rad/s of the sample before; null means that ω is not looked at. */
  turnRate: number | null;
}
/** The weights of the cost (9). The paper does not give them; ours are W = I, R = I, κ = 1000. */
export interface Weights {
  /** The diagonal of W, on the final (x, y, θ) error in the global frame. */
  final: [number, number, number];
  /** The diagonal of R, on the velocity (v, ω). */
  velocity: [number, number];
  /** κ, on negative gains. */
  penalty: number;
}
/**
 * What is added to the applied velocity, after the limits (our choice): fresh noise in ±(linear, angular) at each
 * sample, or a constant slip.
 */
export interface Disturbance {
  /** Which kind. */
  kind: DisturbanceKind;
  /** ε1 or the slip, in m/s. */
  linear: number;
  /** ε2 or the slip, in rad/s. */
  angular: number;
  /** Seed of the random kind. */
  seed: number;
}
/** The kinds of disturbance δ = (δ1, δ2). */
export type DisturbanceKind = 'none' | 'random' | 'slip';
/** The settings of the search: those of evolutionary programming (section 4 of the paper), its ingredients, and its rivals. */
export interface EvolutionSettings {
  /**
   * N: the parents of evolutionary programming, the draws of random search in a generation, the members of
   * differential evolution (at least 4), λ of CMA-ES (at least 2). The other methods go from one point to the next.
   */
  population: number;
  /** q, the number of opponents that each solution meets in the tournament. */
  opponents: number;
  /** The seed of all draws. */
  seed: number;
  /** The interval from which the first gains are drawn. */
  initialRange: [number, number];
  /** The first σ of every gain, or the floor where that is larger; of other methods the first step. */
  initialSigma: number;
  /** How gains are looked for. */
  method: Method;
  /** How the steps of evolutionary programming are distributed. */
  step: Step;
  /** A factor on τ and τ′ of evolutionary programming; with 0 every σ stays. */
  adaptation: number;
  /** What no σ of evolutionary programming falls under. */
  sigmaFloor: number;
  /** Which solutions of evolutionary programming survive. */
  selection: Selection;
  /**
   * How probable it is that a parent of evolutionary programming is crossed with another before it is mutated: each
   * gain, with its σ, is then that of the one or the other.
   */
  crossover: number;
  /** What becomes of gains under 0. */
  belowZero: BelowZero;
}
/** How gains are looked for: by the paper's evolutionary programming, or by one of its rivals. */
export type Method = 'ep' | 'random' | 'de' | 'cma-es' | 'one-plus-one-es' | 'nelder-mead' | 'one-at-a-time' | 'finite-differences';
/** How the steps of a mutation are distributed. */
export type Step = 'gaussian' | 'cauchy';
/** Which solutions of a generation of evolutionary programming survive. */
export type Selection = 'tournament' | 'truncation' | 'parent';
/** What becomes of gains under 0. */
export type BelowZero = 'penalty' | 'mirror' | 'clamp';
/** The name of one of the paper's two experiments: Figures 4 and 5, or Figures 6 and 7. */
export type Preset = 'velocity-limits' | 'acceleration-limits';
/** One run: arrays with one value a sample, the first at time 0, the last where the run ended. */
export interface Run {
  /** Seconds. */
  time: Float64Array;
  /** Metres. */
  x: Float64Array;
  /** Metres. */
  y: Float64Array;
  /** Radians, not wrapped, but that beyond 10⁶ rad full turns are left out. */
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
  /** J of the run, in parts. */
  cost: Cost;
  /** How the run ended. */
  outcome: Outcome;
  /** Whether the robot arrived. */
  arrived: boolean;
  /**
   * t_f in seconds: the time of the sample at which the robot was seen to have arrived or to have left the finite
   * numbers, else the horizon. Where the horizon is not a whole number of samples, the last begins before it and ends
   * after it: an arrival there is up to one sample time later, and path and energy count that sample whole.
   */
  finalTime: number;
}
/**
 * The cost J of equation (9) and its parts. Lower is better; Infinity if the run left the finite numbers, or a sum of
 * squares did, whatever its weight.
 */
export interface Cost {
  /** J, the sum of the parts. */
  total: number;
  /** t_f in seconds. */
  time: number;
  /** (p(t_f) − p_r)ᵀ W (p(t_f) − p_r) */
  finalError: number;
  /** ½ ∫ (p − p_r)ᵀ(p − p_r) dt */
  path: number;
  /** ½ ∫ qᵀ R q dt */
  energy: number;
  /** κ Σ max(0, −k_i) */
  penalty: number;
}
/**
 * How a run ended: the robot came within the tolerances of the goal, the horizon was reached, or it left the finite
 * numbers, or went so far that its square is none.
 */
export type Outcome = 'arrived' | 'horizon' | 'diverged';
/** The robot at one sample. */
export interface Sample {
  /** Seconds. */
  time: number;
  /** Where the robot is; θ is not wrapped, but that beyond 10⁶ rad full turns are left out. */
  posture: Posture;
  /** The reference posture, which moves when the reference velocity is not zero. */
  reference: Posture;
  /** What the control law asks for; at the end of a run, what it last asked for. */
  command: Velocity;
  /** What the limits leave of it, applied until the next sample; at the end, what was last applied. */
  velocity: Velocity;
  /** The error posture (3), in the frame of the reference: metres, and radians in (−π, π]. */
  error: ErrorPosture;
  /** V = ½ x_e² + ½ y_e² + (1 − cos θ_e) of the paper, in m². */
  lyapunov: number;
  /** dV/dt with the applied velocity, without the disturbance, in m²/s. */
  lyapunovRate: number;
  /** How the run ended; null while the robot drives. */
  outcome: Outcome | null;
  /** Whether the robot has arrived. */
  arrived: boolean;
}
/** The error posture (3), in the frame of the reference. */
export interface ErrorPosture {
  /** x_e in metres: how far the reference is ahead, along its own heading. */
  x: number;
  /** y_e in metres: how far it is to the side, positive to the left of its heading. */
  y: number;
  /** θ_e in radians, in (−π, π]. */
  theta: number;
}
/** One trial solution: gains, their strategy parameters σ, and its cost. */
export interface Individual {
  /** The gains (kx, ky, kθ). */
  gains: [number, number, number];
  /**
   * The strategy parameters: the standard deviation of each gain's mutation, of Cauchy's steps their scale. Of
   * CMA-ES the one it was drawn with; of a method that goes from point to point, of a parent the next step, of what was
   * tried the step after a success, but of finite differences the step that led to it; of random search the initial σ;
   * else 0.
   */
  sigmas: [number, number, number];
  /** J, the mean over the start postures; infinite if it is not finite or not yet known. */
  cost: number;
}
/** One generation in short. */
export interface Statistics {
  /** The generation's number. */
  generation: number;
  /**
   * Drives since the start, one for each individual and start posture. `trials`, and whoever compares methods, counts
   * an individual once, from however many starts it drives.
   */
  evaluations: number;
  /** The individual with the lowest cost of all that were driven until now. */
  best: Individual;
  /** Median cost; with an even number of individuals the mean of the two in the middle. */
  median: number;
  /** Highest cost. */
  worst: number;
  /** Mean strategy parameter of each gain over the population. */
  meanSigmas: [number, number, number];
}
/**
 * One generation in full. Solutions are numbered 0 to N − 1 for the parents, and from N on for the offspring.
 * Generation 0 has only parents: the initial population in the order of its draws, all of which survive.
 */
export interface GenerationRecord {
  /** The generation's number. */
  generation: number;
  /** The survivors of the generation before, best ranked first. */
  parents: Individual[];
  /** One offspring of each parent, in their order; of other methods than evolutionary programming, whatever was tried. */
  offspring: Individual[];
  /** The draws behind each offspring of evolutionary programming. */
  mutations: Mutation[];
  /**
   * For each offspring the numbers of the other parents it was made with: with whom its parent was crossed, or a, b and c of
   * a + F (b − c) in differential evolution. Empty where a method crosses nothing.
   */
  donors: number[][];
  /**
   * What each mutation began with, where parents are crossed; the mutants a + F (b − c) of differential evolution, before
   * they are crossed; else empty.
   */
  bases: Individual[];
  /** The distribution from which CMA-ES drew the offspring; null for other methods. */
  ellipse: Ellipse | null;
  /** For each of the 2N solutions, whom it met in the tournament; empty without one. */
  opponents: number[][];
  /** For each of the 2N solutions, how many bouts it won; empty without a tournament. */
  wins: number[];
  /**
   * All of them, best ranked first: most wins first, then lower J, then lower number. Without a tournament those that
   * survive come first, each part by J.
   */
  ranking: number[];
  /** Those that survive, best ranked first. */
  survivors: number[];
  /** What the method went by, besides its population. */
  plan: Plan;
  /** What it goes by in the next generation. */
  next: Plan;
}
/**
 * The draws that made one offspring, standard normal unless the steps are Cauchy's. One for each component is our reading
 * of the paper's N_i(0, 1).
 */
export interface Mutation {
  /** N_j(0, 1) of each gain, or C_j(0, 1). */
  gains: [number, number, number];
  /** N(0, 1), drawn once for all three σ. */
  common: number;
  /** N_j(0, 1) of each σ. */
  sigmas: [number, number, number];
}
/** The normal distribution from which CMA-ES draws a generation. */
export interface Ellipse {
  /** Its centre. */
  mean: [number, number, number];
  /** The three semi-axes of its ellipsoid of one standard deviation, the longest first. */
  axes: [number, number, number][];
}
/** What a method goes by when it asks, besides its population; null or empty is what it does not have. */
export interface Plan {
  /** The move of Nelder and Mead's simplex. */
  motion: Motion | null;
  /** Its four corners by their places in the population, best first; empty where a simplex begins. */
  corners: number[];
  /** The distribution from which CMA-ES draws. */
  ellipse: Ellipse | null;
  /** By how much the trials of CMA-ES will move its mean, the best first; those after them do not count. */
  weights: number[];
  /** How much J rises by a gain, as finite differences have told. */
  slope: [number, number, number] | null;
  /** The next step in each gain: down the slope; one gain at a time, when it is its turn; σ of the (1+1) strategy. */
  steps: [number, number, number] | null;
}
/** A move of Nelder and Mead's simplex. */
export type Motion = 'begin' | 'reflection' | 'expansion' | 'outside-contraction' | 'inside-contraction' | 'shrink';
/** How much a σ changes by itself, τ, and how much all three change together, τ'. */
export interface LearningRates {
  /** τ */
  own: number;
  /** τ' */
  common: number;
}
/** The cells of a landscape of J over two gains. */
export interface Landscape {
  /** The gain that varies within a row. */
  x: Axis;
  /** The gain that varies from row to row. */
  y: Axis;
  /** All three gains; the two on the axes are replaced. */
  gains: Gains;
  /** The rows [first, end) to compute; all when left out. */
  rows?: [number, number];
}
/**
 * One axis of a landscape: `count` values of a gain from `from` to `to`, evenly spaced or, with `log`, evenly in the
 * logarithm.
 */
export interface Axis {
  /** Which gain. */
  gain: Gain;
  /** The first value. */
  from: number;
  /** The last value. */
  to: number;
  /** How many values: 1 to 1024. */
  count: number;
  /** Whether they are spaced evenly in the logarithm. */
  log?: boolean;
}
/** One of the three gains. */
export type Gain = 'kx' | 'ky' | 'ktheta';
/** Three gains (kx, ky, kθ), or such triples one after the other: at most a million in one call, fewer where drives are long. */
export type Gains = Float64Array | readonly number[];
/** Start postures at every position of a grid, with `headings` headings each, evenly around the circle from 0. */
export interface Grid {
  /** Metres. */
  x: Range;
  /** Metres. */
  y: Range;
  /** How many headings at each position: 1 to 1024. */
  headings: number;
  /** The starts [first, end) to take, at most 10 000 in one call; all when left out. All headings of a position stand together, then x varies, then y. */
  part?: [number, number];
}
/** `count` values from `from` to `to`, evenly spaced. */
export interface Range {
  /** The first value. */
  from: number;
  /** The last value. */
  to: number;
  /** How many: 1 to 1024. */
  count: number;
}
/** What the control law makes of an error posture. */
export interface LawTerms {
  /** What each gain asks for, and the reference velocity by itself: the command is their sum, up to rounding. */
  command: CommandTerms;
  /** What the law promises of dV/dt; null where nothing is promised. */
  promised: PromisedRate | null;
}
/** What each gain asks for, and the reference velocity by itself: the command is their sum, up to rounding. */
export interface CommandTerms {
  /** What kx asks for. */
  kx: Velocity;
  /** What ky asks for. */
  ky: Velocity;
  /** What kθ asks for. */
  ktheta: Velocity;
  /** What the reference velocity asks for. */
  reference: Velocity;
}
/** The parts of dV/dt that a law promises for its command, in m²/s, as in `Stability`. */
export interface PromisedRate {
  /** The part on x_e. */
  x: number;
  /** The part on y_e. */
  y: number;
  /** The part on θ_e. */
  theta: number;
}
/** The starts of a grid, and the gains of the robot that drives from them. */
export interface StartGrid {
  /** The gains of the robot. */
  gains: Gains;
  /** Metres. */
  x: Range;
  /** Metres. */
  y: Range;
  /** How many headings at each position: 1 to 1024. */
  headings: number;
  /** The starts [first, end) to drive from; all when left out, in the order of `Grid`. */
  part?: [number, number];
}
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
export interface SeedRuns {
  /** The seeds [first, end); the last of all, 2³² − 1, cannot be among them. */
  seeds: [number, number];
  /** How many generations. */
  generations: number;
}
/** What evolution with one seed found, and random search with as many drives. */
export interface SeedRun {
  /** The best J of each generation, from 0. */
  best: Float64Array;
  /** The best individual in the end. */
  champion: Individual;
  /**
   * The best J that random search had found by then with as many drives: it takes its draws from the initial range in
   * the order in which random search itself would, so that of evolutionary programming begins with the same population.
   */
  random: Float64Array;
}
/** Which seeds [first, end) to run, and with how many drives each. */
export interface Trials {
  /** The seeds [first, end); the last of all, 2³² − 1, cannot be among them. */
  seeds: [number, number];
  /** How many drives; one from several start postures counts once. */
  drives: number;
}
/** How a search with one seed came down. */
export interface Trial {
  /** The seed. */
  seed: number;
  /** At which drives, counted from 1, the best J fell. */
  drives: Float64Array;
  /** To what it fell then. */
  costs: Float64Array;
  /** The best in the end. */
  champion: Champion;
}
/** The gains that a search has found, and what they cost. */
export interface Champion {
  /** The gains (kx, ky, kθ). */
  gains: [number, number, number];
  /** J. */
  cost: number;
}
/**
 * The Lyapunov function V = ½ x_e² + ½ y_e² + w (1 − cos θ_e) along one run: arrays with one value a sample, those of
 * `simulate`. The last sample, where the run has ended, is taken as if the robot drove on.
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
   * The part of dV/dt on x_e that the law promises for its commanded velocity, m²/s: −kx x_e² cos² θ_e for the law (5),
   * −kx x² for Kanayama's rule, x = x_e cos θ_e − y_e sin θ_e being how far the reference is ahead of the robot. NaN
   * where nothing is promised.
   */
  promisedX: Float64Array;
  /** The part on y_e, m²/s: −ky y_e⁴, or 0 for Kanayama's rule. */
  promisedY: Float64Array;
  /**
   * The part on θ_e, m²/s: −kθ sin² θ_e, or −v_r (kθ/ky) sin² θ_e for Kanayama's rule, which is positive where the
   * reference drives backwards.
   */
  promisedTheta: Float64Array;
  /**
   * dV/dt under the velocity that the robot has from the sample on, after limits and disturbance, m²/s, from the rate of
   * the error (4). Where these leave the command as it is, and no divisor of the law is guarded, it is the sum of
   * the promised parts.
   */
  rate: Float64Array;
  /** 1 where the limits changed the command, else 0. */
  limited: Uint8Array;
  /**
   * w, m²: 1 for the law (5), 1/ky for Kanayama's rule. Null if that has ky ≤ 0: then nothing is promised, and V is that
   * of (5).
   */
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
  /** How far the set of |y_e| reaches at this heading, (ε1 |sin θ_e| / ky)^⅓ in metres (7). The theorem is about the law (5) alone. */
  ySet: Float64Array;
}
/** What remains of the error at the end of each run, beside the sets of Theorem 2. */
export interface RemainingErrors {
  /** The largest in the last seconds; Infinity for a robot that left the finite numbers. */
  error: PartsOfStarts;
  /**
   * How far the sets reach, ε1/kx (6), (ε1 |sin θ_e| / ky)^⅓ (7) and ε2/kθ (8); of (7) the farthest in the last seconds.
   * The theorem is about the law (5) alone.
   */
  sets: PartsOfStarts;
}
/** |x_e cos θ_e| and |y_e| in metres, |sin θ_e|: one value for each start. */
export interface PartsOfStarts {
  /** |x_e cos θ_e| in metres. */
  x: Float64Array;
  /** |y_e| in metres. */
  y: Float64Array;
  /** |sin θ_e|. */
  theta: Float64Array;
}
/** Where start postures stand on a circle: its centre and radius in metres. */
export interface Circle {
  /** x of the centre. */
  x: number;
  /** y of the centre. */
  y: number;
  /** How far they are from it. */
  radius: number;
  /** How many: 1 to 10 000. */
  count: number;
  /** The seed of their headings. */
  seed: number;
}
/** The range of one numeric field of an experiment. */
export interface Field {
  /** Where it stands in the experiment; `[]` means each element. */
  path: string;
  /** Empty for a pure number. */
  unit: string;
  /** Smallest allowed value. */
  min: number;
  /** Largest allowed value. */
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
  /** The experiment. */
  preset: Preset;
  /** The number of the figure that shows the run. */
  figure: string;
  /** How the gains were found. */
  method: PaperMethod;
  /** kx, ky, kθ. */
  gains: [number, number, number];
  /** J as the paper prints it. Its weights, and so its scale, are not given. */
  cost: number;
}
/** How the paper found its gains: by evolutionary programming, or as "arbitrarily selected positive values". */
export type PaperMethod = 'ep' | 'arbitrary';
/**
 * An experiment in which any field may be left out. The preset of which a spread copy was made fills it in, else
 * `velocity-limits`; with `experiment(partial, preset)` the one that is named. Starts may be their numbers side by side.
 */
export type PartialExperiment = {
  [K in keyof Experiment]?: K extends 'starts' ? readonly Partial<Posture>[] | Float64Array
    : Experiment[K] extends object ? {
      readonly [F in keyof Experiment[K]]?: Experiment[K][F] extends unknown[] ? Readonly<Experiment[K][F]> : Experiment[K][F];
    } : Experiment[K];
};
