//! How an offspring comes from its parent (step 3 of the paper's procedure).

use nalgebra::Vector3;
use rand::Rng;
use rand_distr::{Distribution, StandardNormal};
use serde::Serialize;

use super::Individual;

/// τ = 1 / √(2 √n) with n = 3 gains: how much each σ changes by itself.
pub const LEARNING_RATE: f64 = 0.537_284_965_911_771;
/// τ' = 1 / √(2n) with n = 3 gains: how much all three change together.
pub const COMMON_LEARNING_RATE: f64 = 0.408_248_290_463_863;

/// The standard normal draws that make one offspring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Mutation {
    /// N_j(0, 1) of each gain.
    pub gains: Vector3<f64>,
    /// N(0, 1), drawn once for all three σ.
    pub common: f64,
    /// N_j(0, 1) of each σ.
    pub sigmas: Vector3<f64>,
}

impl Mutation {
    /// Draws seven numbers: three for the gains, the common one, three for the σ.
    pub fn draw(rng: &mut impl Rng) -> Self {
        let mut normal = || StandardNormal.sample(rng);
        Self {
            gains: Vector3::from_fn(|_, _| normal()),
            common: normal(),
            sigmas: Vector3::from_fn(|_, _| normal()),
        }
    }

    /// The offspring, not yet driven: k'_j = k_j + σ_j N_j(0, 1), σ'_j = σ_j exp(τ' N(0, 1) + τ N_j(0, 1)).
    ///
    /// The gains move by the parent's σ, not by the new one.
    pub fn offspring(&self, parent: &Individual) -> Individual {
        let factor = |n: f64| libm::exp(COMMON_LEARNING_RATE * self.common + LEARNING_RATE * n);
        Individual {
            gains: parent.gains + parent.sigmas.component_mul(&self.gains),
            sigmas: parent.sigmas.component_mul(&self.sigmas.map(factor)),
            cost: f64::INFINITY,
        }
    }
}
