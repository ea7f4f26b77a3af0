//! How an offspring comes from its parent (step 3 of the paper's procedure).

use rand::Rng;
use rand_distr::{Distribution, StandardNormal};

use super::individual::Individual;
use crate::schema::record;

record! { (Copy)
    /// How much a σ changes by itself, τ, and how much all three change together, τ'.
    pub struct LearningRates {
        /// τ
        pub own: f64 => "own",
        /// τ'
        pub common: f64 => "common",
    }
}

impl LearningRates {
    /// τ = 1 / √(2 √n) and τ' = 1 / √(2n) with n = 3 gains.
    pub const PAPER: Self = Self { own: 0.537_284_965_911_771, common: 0.408_248_290_463_863 };
}

record! { (Copy)
    /// The standard normal draws that made one offspring. One for each component is our reading of the paper's N_i(0, 1).
    pub struct Mutation {
        /// N_j(0, 1) of each gain.
        pub gains: [f64; 3] => "gains",
        /// N(0, 1), drawn once for all three σ.
        pub common: f64 => "common",
        /// N_j(0, 1) of each σ.
        pub sigmas: [f64; 3] => "sigmas",
    }
}

impl Mutation {
    /// Draws seven numbers: three for the gains, the common one, three for the σ.
    pub fn draw(rng: &mut impl Rng) -> Self {
        let mut normal = || StandardNormal.sample(rng);
        Self { gains: [0; 3].map(|_| normal()), common: normal(), sigmas: [0; 3].map(|_| normal()) }
    }

    /// The offspring, not yet driven: k'_j = k_j + σ_j N_j(0, 1), σ'_j = σ_j exp(τ' N(0, 1) + τ N_j(0, 1)).
    ///
    /// The gains move by the parent's σ, not by the new one.
    pub fn offspring(&self, parent: &Individual) -> Individual {
        let LearningRates { own, common } = LearningRates::PAPER;
        let [k, sigmas] = [parent.gains.to_array(), parent.sigmas];
        let gain = |j| k[j] + sigmas[j] * self.gains[j];
        let sigma = |j| sigmas[j] * libm::exp(common * self.common + own * self.sigmas[j]);
        Individual {
            gains: [0, 1, 2].map(gain).into(),
            sigmas: [0, 1, 2].map(sigma),
            cost: f64::INFINITY,
        }
    }
}
