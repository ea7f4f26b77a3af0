//! Seeded random material for the tests of laws.
#![allow(dead_code)] // each test file uses its own part

#[cfg(target_arch = "wasm32")]
pub mod javascript;
pub mod json;

use ep_locomotion::robot::{
    Disturbance, DisturbanceKind, ErrorPosture, Gains, Law, Limits, Posture, Velocity,
};
use ep_locomotion::run::{Cost, Experiment, Preset, Sample, Setting};
use ep_locomotion::schema::InvalidInput;
use ep_locomotion::search::{EvolutionSettings, GenerationRecord};
use ep_locomotion::study::{Evolution, Grid, Range};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{RngExt, SeedableRng};

/// The fields that are words: their paths, and what may stand there.
pub const WORDS: [(&str, &[&str]); 6] = [
    ("law", &["shim-kim", "kanayama"]),
    ("disturbance.kind", &["none", "random", "slip"]),
    (
        "evolution.method",
        &[
            "ep",
            "random",
            "de",
            "cma-es",
            "one-plus-one-es",
            "nelder-mead",
            "one-at-a-time",
            "finite-differences",
        ],
    ),
    ("evolution.step", &["gaussian", "cauchy"]),
    ("evolution.selection", &["tournament", "truncation", "parent"]),
    ("evolution.belowZero", &["penalty", "mirror", "clamp"]),
];

/// The usual experiment, as it is told outside.
pub const PRESET: &str = "{\"law\":\"shim-kim\",\"starts\":[{\"x\":0,\"y\":0,\"theta\":0}],\
         \"goal\":{\"x\":2,\"y\":2,\"theta\":0.7853981633974483},\
         \"referenceVelocity\":{\"linear\":0,\"angular\":0},\"sampleTime\":0.01,\"horizon\":10,\
         \"limits\":{\"speed\":2,\"turnRate\":6.283185307179586,\"acceleration\":null,\
         \"turnAcceleration\":null},\"tolerance\":{\"position\":0.05,\"heading\":0.05,\"speed\":null,\"turnRate\":null},\
         \"weights\":{\"final\":[1,1,1],\"velocity\":[1,1],\"penalty\":1000},\
         \"disturbance\":{\"kind\":\"none\",\"linear\":0,\"angular\":0,\"seed\":0},\
         \"evolution\":{\"population\":20,\"opponents\":10,\"seed\":1,\
         \"initialRange\":[0.01,10],\"initialSigma\":1,\
         \"method\":\"ep\",\"step\":\"gaussian\",\"adaptation\":1,\"sigmaFloor\":0,\
         \"selection\":\"tournament\",\"crossover\":0,\"belowZero\":\"penalty\"}}";

pub struct Random(pub Xoshiro256PlusPlus);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(Xoshiro256PlusPlus::seed_from_u64(seed))
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.random::<f64>()
    }

    /// One of the first `count` whole numbers.
    pub fn below(&mut self, count: u32) -> u32 {
        self.0.random_range(0..count)
    }

    /// A number of any magnitude, from the smallest to the largest, sometimes a special one.
    pub fn hostile(&mut self) -> f64 {
        const SPECIAL: [f64; 6] = [0.0, -0.0, f64::MAX, f64::MIN, f64::MIN_POSITIVE, 5e-324];
        let sign = if self.below(2) == 0 { 1.0 } else { -1.0 };
        match self.below(10) {
            0 => SPECIAL[self.below(6) as usize],
            1..=4 => sign * 10f64.powf(self.within(-300.0, 300.0)),
            _ => sign * 10f64.powf(self.within(-3.0, 3.0)),
        }
    }

    pub fn posture(&mut self, reach: f64) -> Posture {
        Posture {
            x: self.within(-reach, reach),
            y: self.within(-reach, reach),
            theta: self.within(-3.1, 3.1),
        }
    }

    pub fn velocity(&mut self, reach: f64) -> Velocity {
        Velocity { linear: self.within(-reach, reach), angular: self.within(-reach, reach) }
    }

    pub fn gains(&mut self, low: f64, high: f64) -> Gains {
        Gains::new(self.within(low, high), self.within(low, high), self.within(low, high))
    }

    /// An error posture away from the singularities sin θ_e = 0 and cos θ_e = 0.
    pub fn error(&mut self) -> ErrorPosture {
        loop {
            let p = self.posture(3.0);
            let e = ErrorPosture::new(p.x, p.y, p.theta);
            if e.sin.abs() > 0.05 && e.cos.abs() > 0.05 {
                return e;
            }
        }
    }
}

/// What the paper's evolution found within limits of velocity.
pub const EP_GAINS: Gains = Gains::new(3.23673, 0.09678, 5.17891);

/// Sixty starts.
pub const GRID: Grid = Grid {
    x: Range { from: -1.0, to: 3.0, count: 5 },
    y: Range { from: 0.0, to: 4.0, count: 3 },
    headings: 4,
};

/// The paper's first experiment.
pub fn velocity_limits() -> Experiment {
    Preset::VelocityLimits.experiment()
}

/// The same with another search.
pub fn searched_by(change: impl Fn(&mut EvolutionSettings)) -> Experiment {
    let mut experiment = velocity_limits();
    change(&mut experiment.evolution);
    experiment
}

/// An experiment that is in every range, ready to be driven.
#[track_caller]
pub fn valid(experiment: Experiment) -> Setting {
    Setting::new(experiment).expect("valid")
}

/// One run from the first start, sample by sample.
pub fn run(experiment: &Experiment, gains: Gains) -> Vec<Sample> {
    valid(experiment.clone()).episode(gains, 0).samples().collect()
}

/// J in its parts.
pub fn cost(experiment: &Experiment, gains: Gains) -> Cost {
    valid(experiment.clone()).cost(&gains)
}

/// Every generation in full.
pub fn records(evolution: &Evolution) -> Vec<GenerationRecord> {
    (0..=evolution.generation()).map(|n| evolution.record(n).expect("a generation")).collect()
}

/// The evolution of an experiment after so many generations.
pub fn evolved(experiment: Experiment, generations: u32) -> Evolution {
    let mut evolution = Evolution::new(valid(experiment));
    for _ in 0..generations {
        evolution.step();
    }
    evolution
}

/// An experiment with numbers of any magnitude that its fields allow.
pub fn wild(random: &mut Random) -> Experiment {
    let mut within = |low: f64, high: f64| random.hostile().clamp(low, high);
    let mut limit = || {
        let value = within(-1e6, 1e6);
        (value >= 0.0).then_some(value)
    };
    let limits = Limits {
        speed: limit(),
        turn_rate: limit(),
        acceleration: limit(),
        turn_acceleration: limit(),
    };
    let (speed, turn_rate) = (limit(), limit());
    let mut posture =
        || Posture { x: within(-1e3, 1e3), y: within(-1e3, 1e3), theta: within(-100.0, 100.0) };
    let (starts, goal) = (vec![posture(), posture()], posture());
    let sample_time = within(1e-5, 10.0).abs().max(1e-5);
    let mut weight = || within(-1e6, 1e6).abs();
    let mut experiment = Experiment { starts, goal, limits, sample_time, ..velocity_limits() };
    experiment.horizon = (12.0 * sample_time).min(1e5);
    experiment.weights.final_error = [weight(), weight(), weight()];
    experiment.weights.velocity = [weight(), weight()];
    experiment.weights.penalty = weight();
    experiment.tolerance.position = within(-1e3, 1e3).abs();
    experiment.tolerance.heading = within(-100.0, 100.0).abs();
    (experiment.tolerance.speed, experiment.tolerance.turn_rate) = (speed, turn_rate);
    let kind = [DisturbanceKind::None, DisturbanceKind::Random, DisturbanceKind::Slip]
        [random.below(3) as usize];
    experiment.disturbance = Disturbance {
        kind,
        linear: random.hostile().abs().min(100.0),
        angular: random.hostile().abs().min(100.0),
        seed: random.below(u32::MAX),
    };
    if random.below(3) == 0 {
        let mut velocity = || random.hostile().clamp(-100.0, 100.0);
        experiment.reference_velocity = Velocity { linear: velocity(), angular: velocity() };
    }
    if random.below(4) == 0 {
        experiment.law = Law::Kanayama;
    }
    experiment
}

/// Asserts that two numbers agree to `tolerance`, relative to the larger of them and 1.
#[track_caller]
pub fn assert_close(a: f64, b: f64, tolerance: f64) {
    let scale = a.abs().max(b.abs()).max(1.0);
    assert!((a - b).abs() <= tolerance * scale, "{a} and {b} differ by {:e}", (a - b).abs());
}

/// Asserts that an input was refused, with this message.
#[track_caller]
pub fn assert_refused<T>(result: Result<T, InvalidInput>, message: &str) {
    let error = result.err().expect("refused");
    assert_eq!(error.to_string(), message);
    assert_eq!(format!("{error:?}"), message, "what `?` in main shows");
}

/// A cost as its bits.
pub fn bits(cost: &Cost) -> [u64; 6] {
    [cost.total(), cost.time, cost.final_error, cost.path, cost.energy, cost.penalty]
        .map(f64::to_bits)
}
