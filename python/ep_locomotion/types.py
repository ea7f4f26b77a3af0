"""What goes into the core, and what comes back, as dicts.

Written by .tasks/python-types.mjs from the core's own tables.
"""

from __future__ import annotations

from typing import Any, List, Literal, Optional, Protocol, Sequence, TypedDict, Union


class Listed(Protocol):
    """An array of numpy, a series of pandas and the like."""

    def tolist(self) -> Any: ...


class Table(Protocol):
    """A table of pandas and the like."""

    def to_numpy(self) -> Any: ...


#: Numbers of numpy, pandas and the like.
Array = Union[Listed, Table]


#: The control law: how the commanded velocity follows from the error posture.
Law = Literal["shim-kim", "kanayama"]
#: The kinds of disturbance δ = (δ1, δ2).
DisturbanceKind = Literal["none", "random", "slip"]
#: How gains are looked for: by the paper's evolutionary programming, or by one of its rivals.
Method = Literal["ep", "random", "de", "cma-es", "one-plus-one-es", "nelder-mead", "one-at-a-time", "finite-differences"]
#: How the steps of a mutation are distributed.
Step = Literal["gaussian", "cauchy"]
#: Which solutions of a generation of evolutionary programming survive.
Selection = Literal["tournament", "truncation", "parent"]
#: What becomes of gains under 0.
BelowZero = Literal["penalty", "mirror", "clamp"]
#: The name of one of the paper's two experiments: Figures 4 and 5, or Figures 6 and 7.
Preset = Literal["velocity-limits", "acceleration-limits"]
#: How a run ended: the robot came within the tolerances of the goal, the horizon was reached, or it left the finite
#: numbers, or went so far that its square is none.
Outcome = Literal["arrived", "horizon", "diverged"]
#: A move of Nelder and Mead's simplex.
Motion = Literal["begin", "reflection", "expansion", "outside-contraction", "inside-contraction", "shrink"]
#: One of the three gains.
Gain = Literal["kx", "ky", "ktheta"]
#: Three gains (kx, ky, kθ), or rows of three: at most a million in one call, fewer where drives are long.
Gains = Union[Sequence[float], Sequence[Union[Sequence[float], Array]], Array]
#: How the paper found its gains: by evolutionary programming, or as "arbitrarily selected positive values".
PaperMethod = Literal["ep", "arbitrary"]


class Experiment(TypedDict):
    """Everything that defines a run. The same experiment gives the same bits on every machine. Every number's range is in
    ``fields()``, every word in ``word_fields()``.
    """

    #: The control law: (5) of the paper, or the rule of Kanayama et al. (1990).
    law: Law
    #: Where the robot starts: 1 to 10 000 postures. With several, its cost is the mean over all of them.
    starts: List[Posture]
    #: The reference posture p_r.
    goal: Posture
    #: The reference velocity q_r. (0, 0) means parking; anything else means tracking: the reference moves from the
    #: goal along its own arc, there is no arrival, and the run lasts until the horizon. That is our choice: all
    #: experiments of the paper park.
    referenceVelocity: Velocity
    #: Seconds between two commands.
    sampleTime: float
    #: Seconds after which a robot that has not arrived is stopped; at most 100 000 times ``sampleTime``.
    horizon: float
    #: Limits of velocity and acceleration.
    limits: Limits
    #: How near counts as arrived.
    tolerance: Tolerance
    #: W, R and κ of the cost (9).
    weights: Weights
    #: What is added to the applied velocity.
    disturbance: Disturbance
    #: The settings of evolutionary programming.
    evolution: EvolutionSettings


class Posture(TypedDict):
    """A posture p = (x, y, θ) in the global frame, equation (1)."""

    #: x in metres.
    x: float
    #: y in metres.
    y: float
    #: θ in radians, counter-clockwise from the X axis.
    theta: float


class Velocity(TypedDict):
    """A velocity q = (v, ω)."""

    #: v in m/s, positive forwards.
    linear: float
    #: ω in rad/s, positive counter-clockwise.
    angular: float


class Limits(TypedDict):
    """Limits of velocity and acceleration; null means not limited."""

    #: Largest |v| in m/s.
    speed: Optional[float]
    #: Largest |ω| in rad/s.
    turnRate: Optional[float]
    #: Largest |dv/dt| in m/s².
    acceleration: Optional[float]
    #: Largest |dω/dt| in rad/s².
    turnAcceleration: Optional[float]


class Tolerance(TypedDict):
    """How near to the goal, and how slow, counts as arrived. That the presets look at no velocity is our choice."""

    #: Largest √(x_e² + y_e²) in metres.
    position: float
    #: Largest |θ_e| in radians.
    heading: float
    #: Largest |v| in m/s of the sample before; null means that v is not looked at.
    speed: Optional[float]
    #: Largest |ω| in rad/s of the sample before; null means that ω is not looked at.
    turnRate: Optional[float]


class Weights(TypedDict):
    """The weights of the cost (9). The paper does not give them; ours are W = I, R = I, κ = 1000."""

    #: The diagonal of W, on the final (x, y, θ) error in the global frame.
    final: Sequence[float]
    #: The diagonal of R, on the velocity (v, ω).
    velocity: Sequence[float]
    #: κ, on negative gains.
    penalty: float


class Disturbance(TypedDict):
    """What is added to the applied velocity, after the limits (our choice): fresh noise in ±(linear, angular) at each
    sample, or a constant slip.
    """

    #: Which kind.
    kind: DisturbanceKind
    #: ε1 or the slip, in m/s.
    linear: float
    #: ε2 or the slip, in rad/s.
    angular: float
    #: Seed of the random kind.
    seed: int


class EvolutionSettings(TypedDict):
    """The settings of the search: those of evolutionary programming (section 4 of the paper), its ingredients, and its rivals."""

    #: N: the parents of evolutionary programming, the draws of random search in a generation, the members of
    #: differential evolution (at least 4), λ of CMA-ES (at least 2). The other methods go from one point to the next.
    population: int
    #: q, the number of opponents that each solution meets in the tournament.
    opponents: int
    #: The seed of all draws.
    seed: int
    #: The interval from which the first gains are drawn.
    initialRange: Sequence[float]
    #: The first σ of every gain, or the floor where that is larger; of other methods the first step.
    initialSigma: float
    #: How gains are looked for.
    method: Method
    #: How the steps of evolutionary programming are distributed.
    step: Step
    #: A factor on τ and τ′ of evolutionary programming; with 0 every σ stays.
    adaptation: float
    #: What no σ of evolutionary programming falls under.
    sigmaFloor: float
    #: Which solutions of evolutionary programming survive.
    selection: Selection
    #: How probable it is that a parent of evolutionary programming is crossed with another before it is mutated: each
    #: gain, with its σ, is then that of the one or the other.
    crossover: float
    #: What becomes of gains under 0.
    belowZero: BelowZero


class Run(TypedDict):
    """One run: arrays with one value a sample, the first at time 0, the last where the run ended."""

    #: Seconds.
    time: List[float]
    #: Metres.
    x: List[float]
    #: Metres.
    y: List[float]
    #: Radians, not wrapped, but that beyond 10⁶ rad full turns are left out.
    theta: List[float]
    #: The velocity applied from this sample to the next, after the limits, m/s; the last sample repeats the one before.
    linear: List[float]
    #: The same for the turn rate, rad/s.
    angular: List[float]
    #: The velocity that the control law asked for, before the limits, m/s.
    commandLinear: List[float]
    #: The same for the turn rate, rad/s.
    commandAngular: List[float]
    #: The reference posture, which moves when the reference velocity is not zero: metres.
    referenceX: List[float]
    #: Metres.
    referenceY: List[float]
    #: Radians.
    referenceTheta: List[float]
    #: The path's part of J that is paid until the sample: ½ ∫ (p − p_r)ᵀ(p − p_r) dt from 0.
    pathCost: List[float]
    #: The energy's part of J that is paid until the sample: ½ ∫ qᵀ R q dt from 0.
    energyCost: List[float]
    #: J of the run, in parts.
    cost: Cost
    #: How the run ended.
    outcome: Outcome
    #: Whether the robot arrived.
    arrived: bool
    #: t_f in seconds: the time of the sample at which the robot was seen to have arrived or to have left the finite
    #: numbers, else the horizon. Where the horizon is not a whole number of samples, the last begins before it and ends
    #: after it: an arrival there is up to one sample time later, and path and energy count that sample whole.
    finalTime: float


class Cost(TypedDict):
    """The cost J of equation (9) and its parts. Lower is better; Infinity if the run left the finite numbers, or a sum of
    squares did, whatever its weight.
    """

    #: J, the sum of the parts.
    total: float
    #: t_f in seconds.
    time: float
    #: (p(t_f) − p_r)ᵀ W (p(t_f) − p_r)
    finalError: float
    #: ½ ∫ (p − p_r)ᵀ(p − p_r) dt
    path: float
    #: ½ ∫ qᵀ R q dt
    energy: float
    #: κ Σ max(0, −k_i)
    penalty: float


class Sample(TypedDict):
    """The robot at one sample."""

    #: Seconds.
    time: float
    #: Where the robot is; θ is not wrapped, but that beyond 10⁶ rad full turns are left out.
    posture: Posture
    #: The reference posture, which moves when the reference velocity is not zero.
    reference: Posture
    #: What the control law asks for; at the end of a run, what it last asked for.
    command: Velocity
    #: What the limits leave of it, applied until the next sample; at the end, what was last applied.
    velocity: Velocity
    #: The error posture (3), in the frame of the reference: metres, and radians in (−π, π].
    error: ErrorPosture
    #: V = ½ x_e² + ½ y_e² + (1 − cos θ_e) of the paper, in m².
    lyapunov: float
    #: dV/dt with the applied velocity, without the disturbance, in m²/s.
    lyapunovRate: float
    #: How the run ended; null while the robot drives.
    outcome: Optional[Outcome]
    #: Whether the robot has arrived.
    arrived: bool


class ErrorPosture(TypedDict):
    """The error posture (3), in the frame of the reference."""

    #: x_e in metres: how far the reference is ahead, along its own heading.
    x: float
    #: y_e in metres: how far it is to the side, positive to the left of its heading.
    y: float
    #: θ_e in radians, in (−π, π].
    theta: float


class Individual(TypedDict):
    """One trial solution: gains, their strategy parameters σ, and its cost."""

    #: The gains (kx, ky, kθ).
    gains: Sequence[float]
    #: The strategy parameters: the standard deviation of each gain's mutation, of Cauchy's steps their scale. Of
    #: CMA-ES the one it was drawn with; of a method that goes from point to point, of a parent the next step, of what was
    #: tried the step after a success, but of finite differences the step that led to it; of random search the initial σ;
    #: else 0.
    sigmas: Sequence[float]
    #: J, the mean over the start postures; infinite if it is not finite or not yet known.
    cost: float


class Statistics(TypedDict):
    """One generation in short."""

    #: The generation's number.
    generation: int
    #: Drives since the start, one for each individual and start posture. ``trials``, and whoever compares methods, counts
    #: an individual once, from however many starts it drives.
    evaluations: float
    #: The individual with the lowest cost of all that were driven until now.
    best: Individual
    #: Median cost; with an even number of individuals the mean of the two in the middle.
    median: float
    #: Highest cost.
    worst: float
    #: Mean strategy parameter of each gain over the population.
    meanSigmas: Sequence[float]


class GenerationRecord(TypedDict):
    """One generation in full. Solutions are numbered 0 to N − 1 for the parents, and from N on for the offspring.
    Generation 0 has only parents: the initial population in the order of its draws, all of which survive.
    """

    #: The generation's number.
    generation: int
    #: The survivors of the generation before, best ranked first.
    parents: List[Individual]
    #: One offspring of each parent, in their order; of other methods than evolutionary programming, whatever was tried.
    offspring: List[Individual]
    #: The draws behind each offspring of evolutionary programming.
    mutations: List[Mutation]
    #: For each offspring the numbers of the other parents it was made with: with whom its parent was crossed, or a, b and c of
    #: a + F (b − c) in differential evolution. Empty where a method crosses nothing.
    donors: List[List[int]]
    #: What each mutation began with, where parents are crossed; the mutants a + F (b − c) of differential evolution, before
    #: they are crossed; else empty.
    bases: List[Individual]
    #: The distribution from which CMA-ES drew the offspring; null for other methods.
    ellipse: Optional[Ellipse]
    #: For each of the 2N solutions, whom it met in the tournament; empty without one.
    opponents: List[List[int]]
    #: For each of the 2N solutions, how many bouts it won; empty without a tournament.
    wins: List[int]
    #: All of them, best ranked first: most wins first, then lower J, then lower number. Without a tournament those that
    #: survive come first, each part by J.
    ranking: List[int]
    #: Those that survive, best ranked first.
    survivors: List[int]
    #: What the method went by, besides its population.
    plan: Plan
    #: What it goes by in the next generation.
    next: Plan


class Mutation(TypedDict):
    """The draws that made one offspring, standard normal unless the steps are Cauchy's. One for each component is our reading
    of the paper's N_i(0, 1).
    """

    #: N_j(0, 1) of each gain, or C_j(0, 1).
    gains: Sequence[float]
    #: N(0, 1), drawn once for all three σ.
    common: float
    #: N_j(0, 1) of each σ.
    sigmas: Sequence[float]


class Ellipse(TypedDict):
    """The normal distribution from which CMA-ES draws a generation."""

    #: Its centre.
    mean: Sequence[float]
    #: The three semi-axes of its ellipsoid of one standard deviation, the longest first.
    axes: List[Sequence[float]]


class Plan(TypedDict):
    """What a method goes by when it asks, besides its population; null or empty is what it does not have."""

    #: The move of Nelder and Mead's simplex.
    motion: Optional[Motion]
    #: Its four corners by their places in the population, best first; empty where a simplex begins.
    corners: List[int]
    #: The distribution from which CMA-ES draws.
    ellipse: Optional[Ellipse]
    #: By how much the trials of CMA-ES will move its mean, the best first; those after them do not count.
    weights: List[float]
    #: How much J rises by a gain, as finite differences have told.
    slope: Optional[Sequence[float]]
    #: The next step in each gain: down the slope; one gain at a time, when it is its turn; σ of the (1+1) strategy.
    steps: Optional[Sequence[float]]


class LearningRates(TypedDict):
    """How much a σ changes by itself, τ, and how much all three change together, τ'."""

    #: τ
    own: float
    #: τ'
    common: float


class _Landscape(TypedDict):
    #: The gain that varies within a row.
    x: Axis
    #: The gain that varies from row to row.
    y: Axis
    #: All three gains; the two on the axes are replaced.
    gains: Gains


class Landscape(_Landscape, total=False):
    """The cells of a landscape of J over two gains."""

    #: The rows [first, end) to compute; all when left out.
    rows: Sequence[int]


_Axis = TypedDict("_Axis", {"gain": "Gain", "from": "float", "to": "float", "count": "int"})


class Axis(_Axis, total=False):
    """One axis of a landscape: ``count`` values of a gain from ``from`` to ``to``, evenly spaced or, with ``log``, evenly in the
    logarithm.
    """

    #: Whether they are spaced evenly in the logarithm.
    log: bool


class _Grid(TypedDict):
    #: Metres.
    x: Range
    #: Metres.
    y: Range
    #: How many headings at each position: 1 to 1024.
    headings: int


class Grid(_Grid, total=False):
    """Start postures at every position of a grid, with ``headings`` headings each, evenly around the circle from 0."""

    #: The starts [first, end) to take, at most 10 000 in one call; all when left out. All headings of a position stand together, then x varies, then y.
    part: Sequence[int]


Range = TypedDict("Range", {"from": "float", "to": "float", "count": "int"})


class LawTerms(TypedDict):
    """What the control law makes of an error posture."""

    #: What each gain asks for, and the reference velocity by itself: the command is their sum, up to rounding.
    command: CommandTerms
    #: What the law promises of dV/dt; null where nothing is promised.
    promised: Optional[PromisedRate]


class CommandTerms(TypedDict):
    """What each gain asks for, and the reference velocity by itself: the command is their sum, up to rounding."""

    #: What kx asks for.
    kx: Velocity
    #: What ky asks for.
    ky: Velocity
    #: What kθ asks for.
    ktheta: Velocity
    #: What the reference velocity asks for.
    reference: Velocity


class PromisedRate(TypedDict):
    """The parts of dV/dt that a law promises for its command, in m²/s, as in ``Stability``."""

    #: The part on x_e.
    x: float
    #: The part on y_e.
    y: float
    #: The part on θ_e.
    theta: float


class _StartGrid(TypedDict):
    #: The gains of the robot.
    gains: Gains
    #: Metres.
    x: Range
    #: Metres.
    y: Range
    #: How many headings at each position: 1 to 1024.
    headings: int


class StartGrid(_StartGrid, total=False):
    """The starts of a grid, and the gains of the robot that drives from them."""

    #: The starts [first, end) to drive from; all when left out, in the order of ``Grid``.
    part: Sequence[int]


class Robustness(TypedDict):
    """One value for each start of a grid, or of an experiment."""

    #: J.
    cost: List[float]
    #: t_f in seconds.
    finalTime: List[float]
    #: 1 where the robot arrived, else 0.
    arrived: List[bool]


class SeedRuns(TypedDict):
    """Which seeds [first, end) to run, and for how many generations."""

    #: The seeds [first, end); the last of all, 2³² − 1, cannot be among them.
    seeds: Sequence[int]
    #: How many generations.
    generations: int


class SeedRun(TypedDict):
    """What evolution with one seed found, and random search with as many drives."""

    #: The best J of each generation, from 0.
    best: List[float]
    #: The best individual in the end.
    champion: Individual
    #: The best J that random search had found by then with as many drives: it takes its draws from the initial range in
    #: the order in which random search itself would, so that of evolutionary programming begins with the same population.
    random: List[float]


class Trials(TypedDict):
    """Which seeds [first, end) to run, and with how many drives each."""

    #: The seeds [first, end); the last of all, 2³² − 1, cannot be among them.
    seeds: Sequence[int]
    #: How many drives; one from several start postures counts once.
    drives: int


class Trial(TypedDict):
    """How a search with one seed came down."""

    #: The seed.
    seed: int
    #: At which drives, counted from 1, the best J fell.
    drives: List[float]
    #: To what it fell then.
    costs: List[float]
    #: The best in the end.
    champion: Champion


class Champion(TypedDict):
    """The gains that a search has found, and what they cost."""

    #: The gains (kx, ky, kθ).
    gains: Sequence[float]
    #: J.
    cost: float


class Stability(TypedDict):
    """The Lyapunov function V = ½ x_e² + ½ y_e² + w (1 − cos θ_e) along one run: arrays with one value a sample, those of
    ``simulate``. The last sample, where the run has ended, is taken as if the robot drove on.
    """

    #: Seconds.
    time: List[float]
    #: x_e of the error posture (3), metres.
    errorX: List[float]
    #: y_e, metres.
    errorY: List[float]
    #: θ_e, radians in (−π, π].
    errorTheta: List[float]
    #: V, m².
    lyapunov: List[float]
    #: The part of dV/dt on x_e that the law promises for its commanded velocity, m²/s: −kx x_e² cos² θ_e for the law (5),
    #: −kx x² for Kanayama's rule, x = x_e cos θ_e − y_e sin θ_e being how far the reference is ahead of the robot. NaN
    #: where nothing is promised.
    promisedX: List[float]
    #: The part on y_e, m²/s: −ky y_e⁴, or 0 for Kanayama's rule.
    promisedY: List[float]
    #: The part on θ_e, m²/s: −kθ sin² θ_e, or −v_r (kθ/ky) sin² θ_e for Kanayama's rule, which is positive where the
    #: reference drives backwards.
    promisedTheta: List[float]
    #: dV/dt under the velocity that the robot has from the sample on, after limits and disturbance, m²/s, from the rate of
    #: the error (4). Where these leave the command as it is, and no divisor of the law is guarded, it is the sum of
    #: the promised parts.
    rate: List[float]
    #: 1 where the limits changed the command, else 0.
    limited: List[bool]
    #: w, m²: 1 for the law (5), 1/ky for Kanayama's rule. Null if that has ky ≤ 0: then nothing is promised, and V is that
    #: of (5).
    headingWeight: Optional[float]


class ErrorParts(TypedDict):
    """The sizes of the error of one run over time that Theorem 2 bounds one by one: one value a sample."""

    #: Seconds.
    time: List[float]
    #: |x_e cos θ_e| in metres.
    x: List[float]
    #: |y_e| in metres.
    y: List[float]
    #: |sin θ_e|.
    theta: List[float]
    #: How far the set of |y_e| reaches at this heading, (ε1 |sin θ_e| / ky)^⅓ in metres (7). The theorem is about the law (5) alone.
    ySet: List[float]


class RemainingErrors(TypedDict):
    """What remains of the error at the end of each run, beside the sets of Theorem 2."""

    #: The largest in the last seconds; Infinity for a robot that left the finite numbers.
    error: PartsOfStarts
    #: How far the sets reach, ε1/kx (6), (ε1 |sin θ_e| / ky)^⅓ (7) and ε2/kθ (8); of (7) the farthest in the last seconds.
    #: The theorem is about the law (5) alone.
    sets: PartsOfStarts


class PartsOfStarts(TypedDict):
    """|x_e cos θ_e| and |y_e| in metres, |sin θ_e|: one value for each start."""

    #: |x_e cos θ_e| in metres.
    x: List[float]
    #: |y_e| in metres.
    y: List[float]
    #: |sin θ_e|.
    theta: List[float]


class Circle(TypedDict):
    """Where start postures stand on a circle: its centre and radius in metres."""

    #: x of the centre.
    x: float
    #: y of the centre.
    y: float
    #: How far they are from it.
    radius: float
    #: How many: 1 to 10 000.
    count: int
    #: The seed of their headings.
    seed: int


class Field(TypedDict):
    """The range of one numeric field of an experiment."""

    #: Where it stands in the experiment; ``[]`` means each element.
    path: str
    #: Empty for a pure number.
    unit: str
    #: Smallest allowed value.
    min: float
    #: Largest allowed value.
    max: float
    #: Whether it must be a whole number.
    integer: bool
    #: Whether it may be null, for "not limited".
    nullable: bool


class WordField(TypedDict):
    """A field of an experiment that is one of a few words."""

    #: Where it stands in the experiment.
    path: str
    #: What it may be.
    words: List[str]


class PaperResult(TypedDict):
    """What the paper states of one of its experiments."""

    #: The experiment.
    preset: Preset
    #: The number of the figure that shows the run.
    figure: str
    #: How the gains were found.
    method: PaperMethod
    #: kx, ky, kθ.
    gains: Sequence[float]
    #: J as the paper prints it. Its weights, and so its scale, are not given.
    cost: float


class PartialPosture(TypedDict, total=False):
    """Any fields of ``Posture``."""

    x: float
    y: float
    theta: float


class PartialVelocity(TypedDict, total=False):
    """Any fields of ``Velocity``."""

    linear: float
    angular: float


class PartialLimits(TypedDict, total=False):
    """Any fields of ``Limits``."""

    speed: Optional[float]
    turnRate: Optional[float]
    acceleration: Optional[float]
    turnAcceleration: Optional[float]


class PartialTolerance(TypedDict, total=False):
    """Any fields of ``Tolerance``."""

    position: float
    heading: float
    speed: Optional[float]
    turnRate: Optional[float]


class PartialWeights(TypedDict, total=False):
    """Any fields of ``Weights``."""

    final: Sequence[float]
    velocity: Sequence[float]
    penalty: float


class PartialDisturbance(TypedDict, total=False):
    """Any fields of ``Disturbance``."""

    kind: DisturbanceKind
    linear: float
    angular: float
    seed: int


class PartialEvolutionSettings(TypedDict, total=False):
    """Any fields of ``EvolutionSettings``."""

    population: int
    opponents: int
    seed: int
    initialRange: Sequence[float]
    initialSigma: float
    method: Method
    step: Step
    adaptation: float
    sigmaFloor: float
    selection: Selection
    crossover: float
    belowZero: BelowZero


class PartialExperiment(TypedDict, total=False):
    """Any fields of ``Experiment``."""

    law: Law
    starts: Union[Sequence[Union[Posture, PartialPosture, Sequence[float], Array]], Array]
    goal: Union[Posture, PartialPosture]
    referenceVelocity: Union[Velocity, PartialVelocity]
    sampleTime: float
    horizon: float
    limits: Union[Limits, PartialLimits]
    tolerance: Union[Tolerance, PartialTolerance]
    weights: Union[Weights, PartialWeights]
    disturbance: Union[Disturbance, PartialDisturbance]
    evolution: Union[EvolutionSettings, PartialEvolutionSettings]
