//! The paper's two experiments, and what it found in them.

use core::f64::consts::{FRAC_PI_4, PI, TAU};

use super::cost::Weights;
use super::experiment::{Experiment, Tolerance};
use crate::robot::{Disturbance, Gains, Law, Limits, Posture, Velocity};
use crate::schema::{InvalidInput, Result, quoted, record, words};
use crate::search::{BelowZero, EvolutionSettings, Method, Selection, Step};

words! {
    /// The name of one of the paper's two experiments: Figures 4 and 5, or Figures 6 and 7.
    pub enum Preset {
        /// Velocities limited: Figures 4 and 5.
        VelocityLimits = "velocity-limits",
        /// Velocities and accelerations limited: Figures 6 and 7.
        AccelerationLimits = "acceleration-limits",
    }
}

words! {
    /// How the paper found its gains: by evolutionary programming, or as "arbitrarily selected positive values".
    pub enum PaperMethod {
        /// By evolutionary programming.
        Ep = "ep",
        /// "Arbitrarily selected positive values".
        Arbitrary = "arbitrary",
    }
}

record! { (Copy)
    /// What the paper states of one of its experiments.
    pub struct PaperResult {
        /// The experiment.
        pub preset: Preset => "preset",
        /// The number of the figure that shows the run.
        pub figure: &'static str => "figure",
        /// How the gains were found.
        pub method: PaperMethod => "method",
        /// kx, ky, kθ.
        pub gains: Gains => "gains",
        /// J as the paper prints it. Its weights, and so its scale, are not given.
        pub cost: f64 => "cost",
    }
}

/// The results that the paper prints with Figures 4 and 6.
pub const PAPER_RESULTS: [PaperResult; 4] = [
    PaperResult {
        preset: Preset::VelocityLimits,
        figure: "4(a)",
        method: PaperMethod::Ep,
        gains: Gains::new(3.23673, 0.09678, 5.17891),
        cost: 12.4685,
    },
    PaperResult {
        preset: Preset::VelocityLimits,
        figure: "4(b)",
        method: PaperMethod::Arbitrary,
        gains: Gains::new(10.0, 10.0, 10.0),
        cost: 17.28398,
    },
    PaperResult {
        preset: Preset::AccelerationLimits,
        figure: "6(a)",
        method: PaperMethod::Ep,
        gains: Gains::new(6.7901, 0.090295, 3.968482),
        cost: 16.53249,
    },
    PaperResult {
        preset: Preset::AccelerationLimits,
        figure: "6(b)",
        method: PaperMethod::Arbitrary,
        gains: Gains::new(30.0, 30.0, 30.0),
        cost: 23.12529,
    },
];

impl Preset {
    /// The preset with this name; the error says which there are.
    pub fn find(name: &str) -> Result<Self> {
        Self::named(name)
            .ok_or_else(|| InvalidInput::new("experiment", Self::expected(), quoted(name)))
    }

    /// The experiment, with every field filled in.
    ///
    /// From the paper: the goal, the reference velocity, the limits (2π and 5π are readings of its "2(rad/s)" and
    /// "5(rad/s²)"), the sample time, q, the initial range and σ.
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
            tolerance: Tolerance { position: 0.05, heading: 0.05, speed: None, turn_rate: None },
            weights: Weights { final_error: [1.0; 3], velocity: [1.0; 2], penalty: 1000.0 },
            disturbance: Disturbance::NONE,
            evolution: EvolutionSettings {
                population: 20,
                opponents: 10,
                seed: 1,
                initial_range: [0.01, 10.0],
                initial_sigma: 1.0,
                method: Method::Ep,
                step: Step::Gaussian,
                adaptation: 1.0,
                sigma_floor: 0.0,
                selection: Selection::Tournament,
                crossover: 0.0,
                below_zero: BelowZero::Penalty,
            },
        }
    }
}
