//! The boundary to JavaScript: the only module that knows it. Types are in `interface.d.ts`.

mod input;

use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use self::input::{Input, gain_name};

use crate::control::Gains;
use crate::convoy::RunEnd;
use crate::cost::Cost;
use crate::episode::{EpisodeState, Outcome, Sample, Setting};
use crate::evolution::{self, LAST_GENERATION};
use crate::experiment::{Experiment, MAX_STARTS, PAPER_RESULTS, Preset};
use crate::fields::{FIELDS, InvalidInput, WORD_FIELDS, shown};
use crate::posture::{ErrorPosture, Posture};
use crate::remaining::{self, ErrorParts};
use crate::stability::{self, StabilitySample};
use crate::starts::{self, MAX_AXIS_COUNT, Range, StartGrid};
use crate::survey::{self, Axis, Gain};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("interface.d.ts");

/// Makes a panic an Error with its message instead of a bare trap.
///
/// After a panic this instance of the module must not be used again.
#[wasm_bindgen(start)]
pub fn throw_panics() {
    std::panic::set_hook(Box::new(|panic| {
        let message = format!("ep-locomotion: internal error, please reload ({panic})");
        web_sys::console::error_1(&message.as_str().into());
        wasm_bindgen::throw_str(&message);
    }));
}

impl From<InvalidInput> for JsValue {
    fn from(error: InvalidInput) -> Self {
        js_sys::Error::new(&error.to_string()).into()
    }
}

type Result<T, E = JsValue> = core::result::Result<T, E>;

/// The experiment with a preset's name, or the given one with every field that it leaves out filled in.
///
/// Throws an Error that names the field when one is unknown, of a wrong type, or out of its range.
#[wasm_bindgen(unchecked_return_type = "Experiment")]
pub fn experiment(
    #[wasm_bindgen(
        js_name = "presetOrPartial",
        unchecked_param_type = "Preset | PartialExperiment"
    )]
    given: JsValue,
) -> Result<JsValue> {
    match given.as_string() {
        Some(name) => plain(&Preset::named(&name)?.experiment()),
        None => plain(setting(given)?.experiment()),
    }
}

/// Drives a robot with each gain triple from `starts[start]` (0 if left out): what `simulate` does, for many at once.
#[wasm_bindgen(js_name = "simulateAll", unchecked_return_type = "Run[]")]
pub fn simulate_all(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] start: JsValue,
) -> Result<Array> {
    let setting = setting(experiment)?;
    let start = start_index(&setting, start)?;
    let gains = triples(gains)?;
    setting.experiment().validate_work("the number of gain triples", gains.len())?;
    gains.into_iter().map(|gains| run(&setting, gains, start)).collect()
}

/// Drives one robot from `starts[start]` (0 if left out) to the end of its run.
#[wasm_bindgen(unchecked_return_type = "Run")]
pub fn simulate(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] start: JsValue,
) -> Result<JsValue> {
    let setting = setting(experiment)?;
    let start = start_index(&setting, start)?;
    run(&setting, one_triple(gains)?, start)
}

fn run(setting: &Setting, gains: Gains, start: u32) -> Result<JsValue> {
    let mut episode = setting.episode(gains, start);
    let mut paid: Vec<Cost> = Vec::new();
    let mut samples: Vec<Sample> = Vec::new();
    while samples.last().is_none_or(|sample| sample.outcome.is_none()) {
        paid.push(episode.cost());
        samples.extend(episode.samples().next());
    }
    type Column = fn(&Sample) -> f64;
    let columns: [(&str, Column); 11] = [
        ("time", |s| s.time),
        ("x", |s| s.posture.x),
        ("y", |s| s.posture.y),
        ("theta", |s| s.posture.theta),
        ("linear", |s| s.velocity.linear),
        ("angular", |s| s.velocity.angular),
        ("commandLinear", |s| s.command.linear),
        ("commandAngular", |s| s.command.angular),
        ("referenceX", |s| s.reference.x),
        ("referenceY", |s| s.reference.y),
        ("referenceTheta", |s| s.reference.theta),
    ];
    let mut fields: Vec<(&str, JsValue)> =
        columns.map(|(name, value)| (name, column(&samples, value))).into();
    fields.extend([
        ("pathCost", column(&paid, |cost| cost.path)),
        ("energyCost", column(&paid, |cost| cost.energy)),
        ("cost", plain(&episode.cost())?),
        ("outcome", plain(&episode.outcome())?),
        ("arrived", (episode.outcome() == Some(Outcome::Arrived)).into()),
        ("finalTime", episode.time().into()),
    ]);
    object(&fields)
}

/// J of each gain triple, the mean over the start postures: n triples in, n costs out.
#[wasm_bindgen(unchecked_return_type = "Float64Array")]
pub fn evaluate(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
) -> Result<JsValue> {
    let setting = setting(experiment)?;
    let costs = survey::evaluate(&setting, &triples(gains)?)?;
    Ok(Float64Array::from(costs.as_slice()).into())
}

/// J over two gains, row by row: `x.count` values for each row of `rows`.
#[wasm_bindgen(unchecked_return_type = "Float64Array")]
pub fn landscape(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(js_name = "landscape", unchecked_param_type = "Landscape")] given: JsValue,
) -> Result<JsValue> {
    let setting = setting(experiment)?;
    let given = Input { value: given, path: "landscape".into() };
    given.keys(&["x", "y", "gains", "rows"])?;
    let (x, y) = (axis(given.get("x")?)?, axis(given.get("y")?)?);
    let gains = one_triple(given.get("gains")?.value)?;
    let rows = given.get("rows")?.part(y.count)?;
    let costs = survey::Landscape { x, y, gains }.costs(&setting, rows)?;
    Ok(Float64Array::from(costs.as_slice()).into())
}

/// How a robot with these gains fares from many starts: positions on a grid, each with several headings.
#[wasm_bindgen(unchecked_return_type = "Robustness")]
pub fn robustness(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(js_name = "grid", unchecked_param_type = "StartGrid")] given: JsValue,
) -> Result<JsValue> {
    let setting = setting(experiment)?;
    let given = Input { value: given, path: "grid".into() };
    given.keys(&["gains", "x", "y", "headings", "part"])?;
    let gains = one_triple(given.get("gains")?.value)?;
    let (grid, part) = start_grid(&given)?;
    run_ends(&survey::robustness(&setting, gains, &grid, part)?)
}

/// A grid of starts and the part of it that is meant.
fn start_grid(given: &Input) -> Result<(StartGrid, [u32; 2])> {
    let grid = StartGrid {
        x: range(given.get("x")?)?,
        y: range(given.get("y")?)?,
        headings: given.get("headings")?.whole_number(MAX_AXIS_COUNT)?,
    };
    let part = given.get("part")?.part(u32::try_from(grid.count()).unwrap_or(u32::MAX))?;
    Ok((grid, part))
}

/// How one robot fares from each of the experiment's starts: J, t_f and whether it arrives.
#[wasm_bindgen(unchecked_return_type = "Robustness")]
pub fn fares(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
) -> Result<JsValue> {
    run_ends(&survey::fares(&setting(experiment)?, one_triple(gains)?))
}

fn run_ends(ends: &[RunEnd]) -> Result<JsValue> {
    let arrived: Vec<u8> =
        ends.iter().map(|end| u8::from(end.outcome == Outcome::Arrived)).collect();
    object(&[
        ("cost", column(ends, |end| end.cost.total())),
        ("finalTime", column(ends, |end| end.cost.time)),
        ("arrived", Uint8Array::from(arrived.as_slice()).into()),
    ])
}

/// The Lyapunov function of one run from `starts[start]` (0 if left out): what the law promises of it, and what becomes of that.
#[wasm_bindgen(unchecked_return_type = "Stability")]
pub fn stability(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "number")] start: JsValue,
) -> Result<JsValue> {
    let setting = setting(experiment)?;
    let start = start_index(&setting, start)?;
    let gains = one_triple(gains)?;
    let samples = stability::stability(&setting, &gains, start);
    let function = setting.experiment().law.lyapunov(&gains);
    let limited: Vec<u8> = samples.iter().map(|sample| u8::from(sample.limited)).collect();
    fn promised<const PART: usize>(sample: &StabilitySample) -> f64 {
        sample.promised.map_or(f64::NAN, |parts| parts[PART])
    }
    object(&[
        ("time", column(&samples, |s| s.time)),
        ("errorX", column(&samples, |s| s.error.x)),
        ("errorY", column(&samples, |s| s.error.y)),
        ("errorTheta", column(&samples, |s| s.error.theta)),
        ("lyapunov", column(&samples, |s| s.lyapunov)),
        ("promisedX", column(&samples, promised::<0>)),
        ("promisedY", column(&samples, promised::<1>)),
        ("promisedTheta", column(&samples, promised::<2>)),
        ("rate", column(&samples, |s| s.rate)),
        ("limited", Uint8Array::from(limited.as_slice()).into()),
        ("headingWeight", function.map_or(JsValue::NULL, |v| v.heading_weight.into())),
    ])
}

/// The parts of the error over time that Theorem 2 bounds, of one run from each start posture.
///
/// A robot that arrives stops there; with tolerances of 0 it goes on to the horizon.
#[wasm_bindgen(js_name = "errorParts", unchecked_return_type = "ErrorParts[]")]
pub fn error_parts(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
) -> Result<Array> {
    let setting = setting(experiment)?;
    let gains = one_triple(gains)?;
    setting.experiment().validate_work("the number of starts", 1)?;
    (0..setting.experiment().starts.len() as u32)
        .map(|start| {
            let samples = remaining::error_parts(&setting, &gains, start);
            object(&[
                ("time", column(&samples, |sample| sample.time)),
                ("x", column(&samples, |sample| sample.error.x)),
                ("y", column(&samples, |sample| sample.error.y)),
                ("theta", column(&samples, |sample| sample.error.theta)),
                ("ySet", column(&samples, |sample| sample.sets.y)),
            ])
        })
        .collect()
}

/// What remains of the error in the last `seconds` of a run from each start posture, beside the sets of Theorem 2.
///
/// A robot that arrives stops there; with tolerances of 0 it goes on to the horizon.
#[wasm_bindgen(js_name = "remainingErrors", unchecked_return_type = "RemainingErrors")]
pub fn remaining_errors(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] seconds: JsValue,
) -> Result<JsValue> {
    let setting = setting(experiment)?;
    let seconds = number(seconds, "seconds")?;
    let all = remaining::remaining_errors(&setting, &one_triple(gains)?, seconds)?;
    let errors: Vec<ErrorParts> = all.iter().map(|one| one.error).collect();
    let sets: Vec<ErrorParts> = all.iter().map(|one| one.sets).collect();
    object(&[("error", parts_of_starts(&errors)?), ("sets", parts_of_starts(&sets)?)])
}

fn parts_of_starts(parts: &[ErrorParts]) -> Result<JsValue> {
    object(&[
        ("x", column(parts, |part| part.x)),
        ("y", column(parts, |part| part.y)),
        ("theta", column(parts, |part| part.theta)),
    ])
}

/// Evolution with many seeds, beside random search with the same number of drives.
#[wasm_bindgen(js_name = "seedRuns", unchecked_return_type = "SeedRun[]")]
pub fn seed_runs(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(js_name = "seeds", unchecked_param_type = "SeedRuns")] given: JsValue,
) -> Result<Array> {
    let setting = setting(experiment)?;
    let given = Input { value: given, path: "seeds".into() };
    given.keys(&["seeds", "generations"])?;
    let seeds = given.get("seeds")?.part(u32::MAX)?;
    let generations = given.get("generations")?.whole_number(LAST_GENERATION)?;
    survey::seed_runs(setting.experiment(), seeds, generations)?
        .into_iter()
        .map(|run| {
            object(&[
                ("best", Float64Array::from(run.best.as_slice()).into()),
                ("champion", plain(&run.champion)?),
                ("random", Float64Array::from(run.random.as_slice()).into()),
            ])
        })
        .collect()
}

/// Start postures evenly on a circle, each with a random heading.
#[wasm_bindgen(js_name = "startsOnCircle", unchecked_return_type = "Posture[]")]
pub fn starts_on_circle(
    #[wasm_bindgen(unchecked_param_type = "Circle")] circle: JsValue,
) -> Result<JsValue> {
    let given = Input { value: circle, path: "circle".into() };
    given.keys(&["x", "y", "radius", "count", "seed"])?;
    let centre = Posture { x: given.get("x")?.number()?, y: given.get("y")?.number()?, theta: 0.0 };
    let count = given.get("count")?.whole_number(MAX_STARTS as u32)?;
    let seed = given.get("seed")?.whole_number(u32::MAX)?;
    plain(&starts::on_circle(centre, given.get("radius")?.number()?, count, seed)?)
}

/// The starts of `robustness` on the same grid, in their order: at most 10 000 in one call.
#[wasm_bindgen(js_name = "startsOnGrid", unchecked_return_type = "Posture[]")]
pub fn starts_on_grid(
    #[wasm_bindgen(js_name = "grid", unchecked_param_type = "Grid")] given: JsValue,
) -> Result<JsValue> {
    let given = Input { value: given, path: "grid".into() };
    given.keys(&["x", "y", "headings", "part"])?;
    let (grid, part) = start_grid(&given)?;
    plain(&grid.postures(part)?)
}

/// What the control law of the experiment makes of an error posture (3): the terms of its command, and the rate of V that it
/// promises.
#[wasm_bindgen(js_name = "lawTerms", unchecked_return_type = "LawTerms")]
pub fn law_terms(
    #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Posture")] error: JsValue,
) -> Result<JsValue> {
    let setting = setting(experiment)?;
    let Experiment { law, reference_velocity, .. } = setting.experiment();
    let gains = one_triple(gains)?;
    let given = Input { value: error, path: "error".into() };
    given.keys(&["x", "y", "theta"])?;
    let error = ErrorPosture::new(
        given.get("x")?.finite_number()?,
        given.get("y")?.finite_number()?,
        given.get("theta")?.finite_number()?,
    );
    let terms = law.terms(&error, &gains, *reference_velocity);
    let [kx, ky, ktheta] = terms.gains;
    let command = [("kx", kx), ("ky", ky), ("ktheta", ktheta), ("reference", terms.reference)]
        .map(|(name, term)| plain(&term).map(|term| (name, term)));
    let command = command.into_iter().collect::<Result<Vec<_>>>()?;
    let promised = law.promised_rate(&error, &gains, *reference_velocity);
    let promised = promised.map(|[x, y, theta]| Posture { x, y, theta });
    object(&[("command", object(&command)?), ("promised", plain(&promised)?)])
}

/// Whether the tournament gives a bout to the solution with this J over one with that: the lower or the same J wins, and
/// one that is not finite never does.
#[wasm_bindgen(js_name = "winsBout")]
pub fn wins_bout(
    #[wasm_bindgen(unchecked_param_type = "number")] cost: JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] opponent: JsValue,
) -> Result<bool> {
    Ok(evolution::wins_bout(number(cost, "cost")?, number(opponent, "opponent")?))
}

/// Every number of an experiment with its unit and range.
#[wasm_bindgen(unchecked_return_type = "Field[]")]
pub fn fields() -> Result<JsValue> {
    plain(&FIELDS.as_slice())
}

/// Every field of an experiment that is one of a few words, with the words.
#[wasm_bindgen(js_name = "wordFields", unchecked_return_type = "WordField[]")]
pub fn word_fields() -> Result<JsValue> {
    plain(&WORD_FIELDS.as_slice())
}

/// The results that the paper prints.
#[wasm_bindgen(unchecked_return_type = "PaperResult[]")]
pub fn paper() -> Result<JsValue> {
    plain(&PAPER_RESULTS)
}

/// τ and τ' of the mutation, and with them how much the σ change.
#[wasm_bindgen(js_name = "learningRates", unchecked_return_type = "LearningRates")]
pub fn learning_rates() -> Result<JsValue> {
    object(&[
        ("own", evolution::LEARNING_RATE.into()),
        ("common", evolution::COMMON_LEARNING_RATE.into()),
    ])
}

/// The version of this program.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").into()
}

/// A seed from the machine's own source of chance.
#[wasm_bindgen(js_name = "randomSeed")]
pub fn random_seed() -> Result<u32> {
    let unavailable = |e| js_sys::Error::new(&format!("no source of random numbers: {e}")).into();
    getrandom::u32().map_err(unavailable)
}

/// One robot, sample by sample.
#[wasm_bindgen]
pub struct Simulation {
    setting: Setting,
    state: EpisodeState,
}

#[wasm_bindgen]
impl Simulation {
    /// A robot at rest at `starts[start]` (0 if left out).
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] start: JsValue,
    ) -> Result<Simulation> {
        let setting = setting(experiment)?;
        let start = start_index(&setting, start)?;
        let state = EpisodeState::new(&setting, one_triple(gains)?, start);
        Ok(Self { setting, state })
    }

    /// The robot now; then it moves on by one sample, unless its run has ended.
    #[wasm_bindgen(unchecked_return_type = "Sample")]
    pub fn step(&mut self) -> Result<JsValue> {
        let sample = self.state.step(&self.setting);
        let object = plain(&sample)?;
        let arrived = sample.outcome == Some(Outcome::Arrived);
        Reflect::set(&object, &"arrived".into(), &arrived.into())?;
        Ok(object)
    }
}

/// A run of evolutionary programming that remembers every generation.
#[wasm_bindgen]
pub struct Evolution(evolution::Evolution);

#[wasm_bindgen]
impl Evolution {
    /// Generation 0: the random initial population, driven.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "PartialExperiment")] experiment: JsValue,
    ) -> Result<Evolution> {
        let setting = setting(experiment)?;
        Ok(Self(evolution::Evolution::new(setting.experiment().clone())?))
    }

    /// The number of the newest generation.
    #[wasm_bindgen(getter)]
    pub fn generation(&self) -> u32 {
        self.0.generation()
    }

    /// Evolves one generation.
    #[wasm_bindgen(unchecked_return_type = "Statistics")]
    pub fn step(&mut self) -> Result<JsValue> {
        plain(&self.0.step())
    }

    /// One generation in short; the newest if left out.
    #[wasm_bindgen(unchecked_return_type = "Statistics")]
    pub fn statistics(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] generation: JsValue,
    ) -> Result<JsValue> {
        plain(&self.0.statistics(self.generation_number(generation)?)?)
    }

    /// One generation in full.
    #[wasm_bindgen(unchecked_return_type = "GenerationRecord")]
    pub fn record(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] generation: JsValue,
    ) -> Result<JsValue> {
        plain(&self.0.record(number(generation, "generation")?)?)
    }

    /// The population that a generation left, best ranked first; the newest if left out.
    #[wasm_bindgen(unchecked_return_type = "Individual[]")]
    pub fn population(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] generation: JsValue,
    ) -> Result<JsValue> {
        plain(&self.0.population(self.generation_number(generation)?)?)
    }

    /// 16 hexadecimal digits over every number of the history. The same everywhere for the same experiment and generation.
    pub fn hash(&self) -> String {
        self.0.hash()
    }

    fn generation_number(&self, given: JsValue) -> Result<f64> {
        if given.is_undefined() {
            return Ok(self.0.generation().into());
        }
        number(given, "generation")
    }
}

/// A plain object, with null for what is absent.
fn plain(value: &(impl Serialize + ?Sized)) -> Result<JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::new()
        .serialize_maps_as_objects(true)
        .serialize_missing_as_null(true);
    Ok(value.serialize(&serializer)?)
}

/// One number of each of many things.
fn column<T>(all: &[T], value: fn(&T) -> f64) -> JsValue {
    let values: Vec<f64> = all.iter().map(value).collect();
    Float64Array::from(values.as_slice()).into()
}

fn object(fields: &[(&str, JsValue)]) -> Result<JsValue> {
    let object = Object::new();
    for (name, value) in fields {
        Reflect::set(&object, &JsValue::from(*name), value)?;
    }
    Ok(object.into())
}

thread_local! {
    /// The default experiment as a plain object, which nobody changes.
    static TEMPLATE: Result<JsValue> = plain(&Preset::default().experiment());
}

fn setting(given: JsValue) -> Result<Setting> {
    let template = TEMPLATE.with(Clone::clone)?;
    let completed = Input { value: given, path: String::new() }.completed(&template)?;
    let experiment: Experiment = serde_wasm_bindgen::from_value(completed)?;
    Ok(Setting::new(experiment)?)
}

fn start_index(setting: &Setting, given: JsValue) -> Result<u32> {
    let start = if given.is_undefined() { 0.0 } else { number(given, "start")? };
    Ok(setting.validate_start(start)?)
}

fn number(given: JsValue, name: &str) -> Result<f64> {
    Input { value: given, path: name.into() }.number()
}

fn one_triple(given: JsValue) -> Result<Gains> {
    match triples(given)?[..] {
        [gains] => Ok(gains),
        ref several => {
            let found = format!("{} numbers", 3 * several.len());
            Err(InvalidInput::new("gains", "three numbers (kx, ky, kθ)", found).into())
        }
    }
}

fn triples(given: JsValue) -> Result<Vec<Gains>> {
    let input = Input { value: given, path: "gains".into() };
    let numbers = input.numbers()?;
    if !numbers.len().is_multiple_of(3) {
        let found = format!("{} numbers", numbers.len());
        return Err(InvalidInput::new("gains", "three numbers for each robot", found).into());
    }
    if let Some(index) = numbers.iter().position(|k| !k.is_finite()) {
        let found = shown(numbers[index]);
        return Err(InvalidInput::new(gain_name(index), "a finite number", found).into());
    }
    Ok(numbers.chunks_exact(3).map(|k| Gains::new(k[0], k[1], k[2])).collect())
}

fn range(given: Input) -> Result<Range> {
    given.keys(&["from", "to", "count"])?;
    Ok(Range {
        from: given.get("from")?.number()?,
        to: given.get("to")?.number()?,
        count: given.get("count")?.whole_number(MAX_AXIS_COUNT)?,
    })
}

fn axis(given: Input) -> Result<Axis> {
    given.keys(&["gain", "from", "to", "count", "log"])?;
    let gain = given.get("gain")?;
    let log = given.get("log")?;
    Ok(Axis {
        gain: match gain.value.as_string().as_deref() {
            Some("kx") => Gain::X,
            Some("ky") => Gain::Y,
            Some("ktheta" | "kθ") => Gain::Theta,
            _ => return Err(gain.refused("'kx', 'ky' or 'ktheta'").into()),
        },
        from: given.get("from")?.number()?,
        to: given.get("to")?.number()?,
        count: given.get("count")?.whole_number(MAX_AXIS_COUNT)?,
        log: match log.value.as_bool() {
            Some(log) => log,
            None if log.value.is_undefined() => false,
            None => return Err(log.refused("true or false").into()),
        },
    })
}
