//! Everything that defines a run, the paper's two experiments, and the ranges of every number.

use core::f64::consts::{FRAC_PI_4, PI, TAU};

use serde::{Deserialize, Serialize};

use crate::control::{Gains, Law};
use crate::cost::Weights;
use crate::disturbance::{Disturbance, DisturbanceKind};
use crate::fields::{FIELDS, InvalidInput, shown};
use crate::limits::Limits;
use crate::posture::{Posture, Velocity};

/// Everything that defines a run. The same experiment gives the same bits on every machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Experiment {
    /// The control law.
    pub law: Law,
    /// Start postures; with several, the cost of gains is the mean over all.
    pub starts: Vec<Posture>,
    /// The reference posture p_r.
    pub goal: Posture,
    /// The reference velocity q_r. (0, 0) means parking; anything else means tracking: the reference moves from the
    /// goal along its own arc, there is no arrival, and the run lasts until the horizon.
    pub reference_velocity: Velocity,
    /// Time between two commands, in seconds.
    pub sample_time: f64,
    /// When a robot that has not arrived is stopped, in seconds.
    pub horizon: f64,
    /// Limits of velocity and acceleration.
    pub limits: Limits,
    /// How near counts as arrived.
    pub tolerance: Tolerance,
    /// W, R and κ of the cost (9).
    pub weights: Weights,
    /// What is added to the applied velocity.
    pub disturbance: Disturbance,
    /// The settings of evolutionary programming.
    pub evolution: EvolutionSettings,
}

/// How near to the goal counts as arrived.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tolerance {
    /// Largest √(x_e² + y_e²) in metres.
    pub position: f64,
    /// Largest |θ_e| in radians.
    pub heading: f64,
}

/// The settings of evolutionary programming (section 4 of the paper).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct EvolutionSettings {
    /// N, the number of parents.
    pub population: u32,
    /// q, the number of opponents that each solution meets in the tournament.
    pub opponents: u32,
    /// The seed of all draws.
    pub seed: u32,
    /// The interval from which the first gains are drawn.
    pub initial_range: [f64; 2],
    /// The first σ of every gain.
    pub initial_sigma: f64,
}

/// The paper's two experiments.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Preset {
    /// Velocities limited: Figures 4 and 5.
    #[default]
    VelocityLimits,
    /// Velocities and accelerations limited: Figures 6 and 7.
    AccelerationLimits,
}

/// One row of the results that the paper prints.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PaperResult {
    /// The experiment.
    pub preset: Preset,
    /// The figure that shows the run.
    pub figure: &'static str,
    /// How the gains were found.
    pub method: PaperMethod,
    /// kx, ky, kθ.
    pub gains: [f64; 3],
    /// J as the paper prints it. Its weights, and so its scale, are not given.
    pub cost: f64,
}

/// How the paper found its gains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PaperMethod {
    /// By evolutionary programming.
    Ep,
    /// "Arbitrarily selected positive values".
    Arbitrary,
}

/// The results that the paper prints with Figures 4 and 6.
pub const PAPER_RESULTS: [PaperResult; 4] = [
    PaperResult {
        preset: Preset::VelocityLimits,
        figure: "4(a)",
        method: PaperMethod::Ep,
        gains: [3.23673, 0.09678, 5.17891],
        cost: 12.4685,
    },
    PaperResult {
        preset: Preset::VelocityLimits,
        figure: "4(b)",
        method: PaperMethod::Arbitrary,
        gains: [10.0, 10.0, 10.0],
        cost: 17.28398,
    },
    PaperResult {
        preset: Preset::AccelerationLimits,
        figure: "6(a)",
        method: PaperMethod::Ep,
        gains: [6.7901, 0.090295, 3.968482],
        cost: 16.53249,
    },
    PaperResult {
        preset: Preset::AccelerationLimits,
        figure: "6(b)",
        method: PaperMethod::Arbitrary,
        gains: [30.0, 30.0, 30.0],
        cost: 23.12529,
    },
];

impl PaperResult {
    /// The gains as the law takes them.
    pub fn gains(&self) -> Gains {
        let [x, y, theta] = self.gains;
        Gains::new(x, y, theta)
    }
}

impl Preset {
    /// The name used in links and in JavaScript.
    pub const fn name(self) -> &'static str {
        match self {
            Self::VelocityLimits => "velocity-limits",
            Self::AccelerationLimits => "acceleration-limits",
        }
    }

    /// The preset with this name.
    pub fn named(name: &str) -> Result<Self, InvalidInput> {
        [Self::VelocityLimits, Self::AccelerationLimits]
            .into_iter()
            .find(|preset| preset.name() == name)
            .ok_or_else(|| {
                InvalidInput::new(
                    "experiment",
                    "'velocity-limits' or 'acceleration-limits'",
                    format!("'{name}'"),
                )
            })
    }

    /// The experiment, with every field filled in.
    ///
    /// From the paper: the goal, the reference velocity, the limits, the sample time, q, the initial range and σ.
    /// Chosen by us, for it gives none: the start, the horizon, the tolerances, W, R, κ and N.
    pub fn experiment(self) -> Experiment {
        let (acceleration, turn_acceleration) = match self {
            Self::VelocityLimits => (None, None),
            Self::AccelerationLimits => (Some(5.0), Some(5.0 * PI)),
        };
        Experiment {
            law: Law::ShimKim,
            starts: vec![Posture::default()],
            goal: Posture { x: 2.0, y: 2.0, theta: FRAC_PI_4 },
            reference_velocity: Velocity::ZERO,
            sample_time: 0.01,
            horizon: 10.0,
            limits: Limits {
                speed: Some(2.0),
                turn_rate: Some(TAU),
                acceleration,
                turn_acceleration,
            },
            tolerance: Tolerance { position: 0.05, heading: 0.05 },
            weights: Weights { final_error: [1.0; 3], velocity: [1.0; 2], penalty: 1000.0 },
            disturbance: Disturbance::default(),
            evolution: EvolutionSettings {
                population: 20,
                opponents: 10,
                seed: 1,
                initial_range: [0.01, 10.0],
                initial_sigma: 1.0,
            },
        }
    }
}

/// Most samples in one run: horizon / sampleTime.
pub const MAX_SAMPLES: f64 = 100_000.0;
/// Most start postures.
pub const MAX_STARTS: usize = 10_000;
/// Most samples that one call may have to drive: robots × starts × samples. It bounds how long a call can take.
pub const MAX_WORK: f64 = 4e8;

impl Experiment {
    /// Samples until the horizon: the first n with n · sample_time ≥ horizon.
    pub fn samples(&self) -> u32 {
        let mut n = (self.horizon / self.sample_time) as u32;
        while f64::from(n) * self.sample_time < self.horizon {
            n += 1;
        }
        n
    }

    /// Whether the reference moves.
    pub fn is_tracking(&self) -> bool {
        self.reference_velocity != Velocity::ZERO
    }

    /// Checks every field against its range, and the few rules between fields.
    pub fn validate(&self) -> Result<(), InvalidInput> {
        for field in &FIELDS {
            for (index, value) in field.values(self).into_iter().enumerate() {
                if value.is_some_and(|value| !field.allows(value)) {
                    let path = field.path.replace("[]", &format!("[{index}]"));
                    let found = value.map_or_else(String::new, shown);
                    return Err(InvalidInput::new(path, field.expected(), found));
                }
            }
        }
        let invalid = |field: &str, expected: String, found: String| {
            Err(InvalidInput::new(field, expected, found))
        };
        if self.starts.is_empty() || self.starts.len() > MAX_STARTS {
            let expected = format!("a list of 1 to {MAX_STARTS} postures");
            return invalid("starts", expected, format!("a list of {}", self.starts.len()));
        }
        if self.horizon / self.sample_time > MAX_SAMPLES {
            let expected = format!("at most {MAX_SAMPLES} times sampleTime");
            let found = format!("{} with sampleTime {}", self.horizon, self.sample_time);
            return invalid("horizon", expected, found);
        }
        let [low, high] = self.evolution.initial_range;
        if low >= high {
            let expected = "[low, high] with low under high".to_string();
            return invalid("evolution.initialRange", expected, format!("[{low}, {high}]"));
        }
        if self.disturbance.kind == DisturbanceKind::Random {
            for (name, bound) in
                [("linear", self.disturbance.linear), ("angular", self.disturbance.angular)]
            {
                if bound < 0.0 {
                    let expected = "0 or more for a random disturbance".to_string();
                    return invalid(&format!("disturbance.{name}"), expected, shown(bound));
                }
            }
        }
        self.validate_work("evolution.population", self.evolution.population as usize)
    }

    /// Refuses to drive more than [`MAX_WORK`] samples in one call.
    pub(crate) fn validate_work(&self, field: &str, robots: usize) -> Result<(), InvalidInput> {
        let one = self.starts.len().max(1) as f64 * (self.horizon / self.sample_time).max(1.0);
        if robots as f64 * one > MAX_WORK {
            let expected = format!(
                "at most {} with {} starts and {} samples a run",
                (MAX_WORK / one).floor(),
                self.starts.len().max(1),
                self.samples()
            );
            return Err(InvalidInput::new(field, expected, robots.to_string()));
        }
        Ok(())
    }
}
