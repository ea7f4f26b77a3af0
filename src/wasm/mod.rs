//! The boundary to JavaScript: the only room that knows it. Types are in `interface.d.ts`, which is written from the tables
//! of the other rooms.

mod write;

mod origin;

mod read;

mod task;

use js_sys::Reflect;
use serde_wasm_bindgen::to_value;
use wasm_bindgen::prelude::*;

pub use task::*;

use self::read::Given;
use self::write::plain;
use crate::outside::{self, number};
use crate::robot::Gains;
use crate::run::{EpisodeState, Experiment, PAPER_RESULTS, Preset, Setting};
use crate::schema::InvalidInput;
use crate::search::{self, LearningRates};
use crate::study::{self, Circle, Grid};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("interface.d.ts");

type Result<T, E = JsValue> = core::result::Result<T, E>;

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

/// The experiment of a preset, or the given fields of one with every other field filled in. With both, in whichever order,
/// the preset is what fills in; without, the one that a whole experiment was made from, or else `velocity-limits`.
///
/// Throws an Error that names the field when one is unknown, of a wrong type, or out of its range.
#[wasm_bindgen(unchecked_return_type = "Experiment")]
pub fn experiment(
    #[wasm_bindgen(
        js_name = "presetOrPartial",
        unchecked_param_type = "Preset | PartialExperiment"
    )]
    given: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PartialExperiment | Preset")] other: JsValue,
) -> Result<JsValue> {
    let (given, other) = (Given::of(given), Given::of(other));
    let (setting, preset) = outside::experiment(&given, &other)?;
    Ok(origin::remembered(setting.experiment(), preset))
}

/// Start postures evenly on a circle, each with a random heading.
#[wasm_bindgen(js_name = "startsOnCircle", unchecked_return_type = "Posture[]")]
pub fn starts_on_circle(
    #[wasm_bindgen(unchecked_param_type = "Circle")] circle: JsValue,
) -> Result<JsValue> {
    Ok(plain(&Circle::read(&Given::of(circle))?.starts()?))
}

/// The starts of `robustness` on the same grid, in their order: at most 10 000 in one call.
#[wasm_bindgen(js_name = "startsOnGrid", unchecked_return_type = "Posture[]")]
pub fn starts_on_grid(
    #[wasm_bindgen(unchecked_param_type = "Grid")] grid: JsValue,
) -> Result<JsValue> {
    let (grid, part) = Grid::read(&Given::of(grid))?;
    Ok(plain(&grid.starts(part)?))
}

/// Whether the tournament gives a bout to the solution with this J over one with that: the lower or the same J wins, and
/// one that is not finite never does.
#[wasm_bindgen(js_name = "winsBout")]
pub fn wins_bout(
    #[wasm_bindgen(unchecked_param_type = "number")] cost: JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] opponent: JsValue,
) -> Result<bool> {
    let [cost, opponent] = [Given::of(cost), Given::of(opponent)];
    Ok(search::wins_bout(number(&cost, "cost")?, number(&opponent, "opponent")?))
}

/// Every number of an experiment with its unit and range.
#[wasm_bindgen(unchecked_return_type = "Field[]")]
pub fn fields() -> Result<JsValue> {
    Ok(to_value(&Experiment::fields().numbers)?)
}

/// Every field of an experiment that is one of a few words, with the words.
#[wasm_bindgen(js_name = "wordFields", unchecked_return_type = "WordField[]")]
pub fn word_fields() -> Result<JsValue> {
    Ok(to_value(&Experiment::fields().words)?)
}

/// The results that the paper prints.
#[wasm_bindgen(unchecked_return_type = "PaperResult[]")]
pub fn paper() -> JsValue {
    plain(&PAPER_RESULTS)
}

/// τ and τ' of the mutation, and with them how much the σ change.
#[wasm_bindgen(js_name = "learningRates", unchecked_return_type = "LearningRates")]
pub fn learning_rates() -> JsValue {
    plain(&LearningRates::PAPER)
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
        #[wasm_bindgen(unchecked_param_type = "PartialExperiment | Preset")] experiment: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Gains")] gains: JsValue,
        #[wasm_bindgen(js_name = "start", unchecked_optional_param_type = "number")] from: JsValue,
    ) -> Result<Simulation> {
        let (setting, _) = outside::setting(&Given::of(experiment))?;
        let from = outside::start(&setting, &Given::of(from))?;
        let state = EpisodeState::new(&setting, Gains::read_one(&Given::of(gains))?, from);
        Ok(Self { setting, state })
    }

    /// The robot now; then it moves on by one sample, unless its run has ended. With a number it does so that often, and gives
    /// the last.
    #[wasm_bindgen(unchecked_return_type = "Sample")]
    pub fn step(
        &mut self,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] samples: JsValue,
    ) -> Result<JsValue> {
        let mut samples = outside::steps(&Given::of(samples), "samples")?;
        loop {
            let sample = self.state.step(&self.setting);
            samples -= 1;
            // A run that has ended stays where it is.
            if samples == 0 || sample.outcome.is_some() {
                return Ok(plain(&sample));
            }
        }
    }
}

/// A run of evolutionary programming, or of a rival, that remembers every generation.
#[wasm_bindgen]
pub struct Evolution {
    run: study::Evolution,
    /// What filled in its experiment.
    preset: Preset,
}

#[wasm_bindgen]
impl Evolution {
    /// Generation 0: the random initial population, driven.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "PartialExperiment | Preset")] experiment: JsValue,
    ) -> Result<Evolution> {
        let (setting, preset) = outside::setting(&Given::of(experiment))?;
        Ok(Self { run: study::Evolution::new(setting), preset })
    }

    /// The experiment with every field filled in.
    #[wasm_bindgen(getter, unchecked_return_type = "Experiment")]
    pub fn experiment(&self) -> JsValue {
        origin::remembered(self.run.setting().experiment(), self.preset)
    }

    /// The newest generation.
    #[wasm_bindgen(getter)]
    pub fn generation(&self) -> u32 {
        self.run.generation()
    }

    /// How many generations are computed again at most for one that is asked for: every so many are kept.
    #[wasm_bindgen(getter, js_name = "mostDrivenAgain")]
    pub fn most_driven_again(&self) -> u32 {
        self.run.most_driven_again()
    }

    /// Evolves one generation, or so many; the newest in short.
    #[wasm_bindgen(unchecked_return_type = "Statistics")]
    pub fn step(
        &mut self,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] generations: JsValue,
    ) -> Result<JsValue> {
        Ok(plain(&self.run.advance(outside::steps(&Given::of(generations), "generations")?)?))
    }

    /// One generation in short; the newest if left out.
    #[wasm_bindgen(unchecked_return_type = "Statistics")]
    pub fn statistics(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] generation: JsValue,
    ) -> Result<JsValue> {
        Ok(plain(&self.run.statistics(self.numbered(generation)?)?))
    }

    /// One generation in full; the newest if left out.
    #[wasm_bindgen(unchecked_return_type = "GenerationRecord")]
    pub fn record(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] generation: JsValue,
    ) -> Result<JsValue> {
        Ok(plain(&self.run.record(self.numbered(generation)?)?))
    }

    /// The population that a generation left, best ranked first; the newest if left out.
    #[wasm_bindgen(unchecked_return_type = "Individual[]")]
    pub fn population(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] generation: JsValue,
    ) -> Result<JsValue> {
        Ok(plain(&self.run.population(self.numbered(generation)?)?))
    }

    /// 16 hexadecimal digits over the numbers that decide the history: parents, offspring, opponents, wins and survivors of every
    /// generation. The same everywhere for the same experiment and generation.
    pub fn hash(&self) -> String {
        self.run.hash()
    }

    fn numbered(&self, given: JsValue) -> Result<u32, InvalidInput> {
        outside::generation(&self.run, &Given::of(given))
    }
}

impl From<InvalidInput> for JsValue {
    fn from(error: InvalidInput) -> Self {
        let message = error.message().written(write::digits);
        let told = js_sys::Error::new(&message).into();
        // A fresh object takes every property.
        let field = error.field.as_str().into();
        let _ = write::named("field", |name| Reflect::set(&told, name, &field));
        told
    }
}
