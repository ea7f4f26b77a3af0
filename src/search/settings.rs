//! What evolutionary programming is told before it begins.

use crate::schema::{Allowed, InvalidInput, record};

record! { input (Copy)
    /// The settings of evolutionary programming (section 4 of the paper).
    pub struct EvolutionSettings {
        /// N, the number of parents.
        pub population: u32 => "population" in Allowed::whole(1, 2000),
        /// q, the number of opponents that each solution meets in the tournament.
        pub opponents: u32 => "opponents" in Allowed::whole(1, 1000),
        /// The seed of all draws.
        pub seed: u32 => "seed" in Allowed::SEED,
        /// The interval from which the first gains are drawn.
        pub initial_range: [f64; 2] => "initialRange" in Allowed::within("", -1e6, 1e6),
        /// The first σ of every gain.
        pub initial_sigma: f64 => "initialSigma" in Allowed::within("", 0.0, 1e6),
    }
}

impl EvolutionSettings {
    /// Checks the rule between two of the fields.
    pub(crate) fn check_interval(&self) -> Result<(), InvalidInput> {
        let [low, high] = self.initial_range;
        if low < high {
            return Ok(());
        }
        let (expected, found) = ("[low, high] with low under high", format!("[{low}, {high}]"));
        Err(InvalidInput::new("evolution.initialRange", expected, found))
    }
}
