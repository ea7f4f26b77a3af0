//! How an offspring comes from its parent (step 3 of the paper's procedure).

use core::f64::consts::PI;

use rand::{Rng, RngExt};
use rand_distr::{Distribution, StandardNormal};

use super::individual::Individual;
use super::settings::{EvolutionSettings, Step};
use crate::number::{Purpose, Real, stream};
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

    /// The paper's, times a factor.
    fn times(factor: f64) -> Self {
        Self { own: factor * Self::PAPER.own, common: factor * Self::PAPER.common }
    }
}

record! { (Copy)
    /// The draws that made one offspring, standard normal unless the steps are Cauchy's. One for each component is our reading
    /// of the paper's N_i(0, 1).
    pub struct Mutation {
        /// N_j(0, 1) of each gain, or C_j(0, 1).
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

    /// The mutations of a generation, one for each parent. Whatever the steps, the σ meet the same draws.
    pub(super) fn all(e: &EvolutionSettings, count: usize, generation: u32) -> Vec<Self> {
        let mut rng = stream(e.seed, Purpose::Mutation, generation);
        let mut mutations: Vec<_> = (0..count).map(|_| Self::draw(&mut rng)).collect();
        if e.step == Step::Cauchy {
            let mut rng = stream(e.seed, Purpose::Steps, generation);
            for mutation in &mut mutations {
                mutation.gains = [0; 3].map(|_| cauchy(&mut rng));
            }
        }
        mutations
    }

    /// The offspring, not yet driven: k'_j = k_j + σ_j N_j(0, 1), σ'_j = σ_j exp(τ' N(0, 1) + τ N_j(0, 1)).
    ///
    /// The gains move by the parent's σ, not by the new one. The settings say what becomes of gains under 0, by what factor τ
    /// and τ' are others than the paper's, and what no σ falls under.
    pub fn offspring(&self, e: &EvolutionSettings, parent: &Individual) -> Individual {
        let LearningRates { own, common } = LearningRates::times(e.adaptation);
        let [k, sigmas] = [parent.gains.to_array(), parent.sigmas];
        let gain = |j| k[j] + sigmas[j] * self.gains[j];
        let sigma = |j| sigmas[j] * libm::exp(common * self.common + own * self.sigmas[j]);
        let sigmas = [0, 1, 2].map(sigma).map(|sigma| sigma.at_least(e.sigma_floor));
        Individual::new(e.tried([0, 1, 2].map(gain)), sigmas)
    }
}

/// A draw from Cauchy's distribution, density 1 / (π (1 + x²)): its quartiles are −1 and 1.
fn cauchy(rng: &mut impl Rng) -> f64 {
    libm::tan(PI * (rng.random::<f64>() - 0.5))
}
