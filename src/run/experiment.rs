//! Everything that defines a run.

use super::cost::Weights;
use crate::robot::{Disturbance, DisturbanceKind, Law, Limits, Posture, Velocity, limit};
use crate::schema::{Allowed, Fields, Input, InvalidInput, Place, Result, Source, Text, record};
use crate::search::EvolutionSettings;

/// Most start postures.
pub const MAX_STARTS: u32 = 10_000;
/// Most samples in one run: horizon / sampleTime.
pub const MAX_SAMPLES: f64 = 100_000.0;

record! { input (Copy)
    /// How near to the goal, and how slow, counts as arrived. That the presets look at no velocity is our choice.
    pub struct Tolerance {
        /// Largest √(x_e² + y_e²) in metres.
        pub position: f64 => "position" in Allowed::within("m", 0.0, 1000.0),
        /// Largest |θ_e| in radians.
        pub heading: f64 => "heading" in Allowed::within("rad", 0.0, 100.0),
        /// Largest |v| in m/s of the sample before; null means that v is not looked at.
        pub speed: Option<f64> => "speed" in limit("m/s"),
        /// Largest |ω| in rad/s of the sample before; null means that ω is not looked at.
        pub turn_rate: Option<f64> => "turnRate" in limit("rad/s"),
    }
}

record! { input
    /// Everything that defines a run. The same experiment gives the same bits on every machine. Every number's range is in
    /// `fields()`, every word in `wordFields()`.
    pub struct Experiment {
        /// The control law: (5) of the paper, or the rule of Kanayama et al. (1990).
        pub law: Law => "law",
        /// Where the robot starts: 1 to 10 000 postures. With several, its cost is the mean over all of them.
        pub starts: Vec<Posture> => "starts" in Allowed::whole(1, MAX_STARTS),
        /// The reference posture p_r.
        pub goal: Posture => "goal",
        /// The reference velocity q_r. (0, 0) means parking; anything else means tracking: the reference moves from the
        /// goal along its own arc, there is no arrival, and the run lasts until the horizon. That is our choice: all
        /// experiments of the paper park.
        pub reference_velocity: Velocity => "referenceVelocity",
        /// Seconds between two commands.
        pub sample_time: f64 => "sampleTime" in Allowed::within("s", 1e-5, 10.0),
        /// Seconds after which a robot that has not arrived is stopped; at most 100 000 times `sampleTime`.
        pub horizon: f64 => "horizon" in Allowed::within("s", 1e-5, 1e5),
        /// Limits of velocity and acceleration.
        pub limits: Limits => "limits",
        /// How near counts as arrived.
        pub tolerance: Tolerance => "tolerance",
        /// W, R and κ of the cost (9).
        pub weights: Weights => "weights",
        /// What is added to the applied velocity.
        pub disturbance: Disturbance => "disturbance",
        /// The settings of evolutionary programming.
        pub evolution: EvolutionSettings => "evolution",
    }
}

impl Experiment {
    /// Takes over what is given; every field that is left out stays as it is. Numbers are checked by
    /// [`Self::validate`]. After an error it is read in part.
    pub fn read<S: Source>(&mut self, given: &S) -> Result<()> {
        Input::read(self, given, Place::Experiment, &Allowed::ANY)
    }

    /// The range of every number of an experiment, and every field that is one of a few words.
    pub fn fields() -> Fields {
        let mut fields = Fields::default();
        <Self as Input>::fields("", &Allowed::ANY, &mut fields);
        fields
    }

    /// Samples until the horizon: the first n with n · sample_time ≥ horizon.
    pub fn samples(&self) -> u32 {
        let n = (self.horizon / self.sample_time) as u32;
        // The quotient is rounded, but no whole number lies between it and the exact one.
        if f64::from(n) * self.sample_time < self.horizon { n.saturating_add(1) } else { n }
    }

    /// Whether the reference moves.
    pub fn is_tracking(&self) -> bool {
        self.reference_velocity != Velocity::ZERO
    }

    /// Checks every field against its range, and the few rules between fields. [`Setting::new`](super::Setting::new) asks
    /// besides what a generation takes.
    pub fn validate(&self) -> Result<()> {
        self.check(Place::Experiment, &Allowed::ANY)?;
        if self.horizon / self.sample_time > MAX_SAMPLES {
            let expected = Text::from("at most ") + MAX_SAMPLES + " times sampleTime";
            let found = Text::from(self.horizon) + " with sampleTime " + self.sample_time;
            return Err(InvalidInput::new("horizon", expected, found));
        }
        self.evolution.check_rules()?;
        self.validate_noise()
    }

    fn validate_noise(&self) -> Result<()> {
        let Disturbance { kind, linear, angular, .. } = self.disturbance;
        for (name, bound) in [("linear", linear), ("angular", angular)] {
            if kind == DisturbanceKind::Random && bound < 0.0 {
                let name = format!("disturbance.{name}");
                let expected = "0 or more for a random disturbance";
                return Err(InvalidInput::new(name, expected, bound));
            }
        }
        Ok(())
    }
}
