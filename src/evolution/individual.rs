//! One trial solution.

use nalgebra::Vector3;
use rand::{Rng, RngExt};
use serde::Serialize;

use crate::experiment::EvolutionSettings;

/// A pair of real-valued vectors (k, σ) and the cost of k.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Individual {
    /// The gains (kx, ky, kθ).
    pub gains: Vector3<f64>,
    /// The strategy parameters: the standard deviation of each gain's mutation.
    pub sigmas: Vector3<f64>,
    /// J, the mean over the start postures; infinite if it is not finite or not yet known.
    pub cost: f64,
}

impl Individual {
    /// An individual with k_j uniform in [low, high) and σ_j the initial σ (step 1).
    pub(crate) fn random(settings: &EvolutionSettings, rng: &mut impl Rng) -> Self {
        let [low, high] = settings.initial_range;
        Self {
            gains: Vector3::from_fn(|_, _| low + (high - low) * rng.random::<f64>()),
            sigmas: Vector3::repeat(settings.initial_sigma),
            cost: f64::INFINITY,
        }
    }
}
