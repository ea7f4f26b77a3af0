//! CMA-ES: evolution strategy with covariance matrix adaptation (Hansen, "The CMA Evolution Strategy: A Tutorial", 2016),
//! without negative weights.

use rand_distr::{Distribution, StandardNormal};

use super::generation::{Brood, GenerationRecord, Making, by_cost};
use super::individual::{Individual, first_drawn};
use super::plan::{Ellipse, Plan};
use super::search::{Found, Search, found};
use super::settings::EvolutionSettings;
use super::symmetric::{Matrix, UNIT, Vector, dot, eigen, plus, spectral};
use super::tournament::in_order;
use crate::number::{Purpose, Real, stream};

/// A normal distribution that moves to where trials cost less, and takes the shape of the steps that led there.
///
/// It begins around a draw from the initial range, with the initial σ in each gain.
#[derive(Clone, Debug, Default)]
pub struct CmaEs {
    found: Found,
    /// Where it stands; nothing before generation 0 is told.
    normal: Option<Normal>,
}

impl Search for CmaEs {
    fn ask(&self, e: &EvolutionSettings, generation: u32) -> Brood {
        assert!(e.population > 1, "CMA-ES needs a population of two, not {}", e.population);
        let normal = self.normal(e);
        let sigmas = normal.sigmas();
        let steps = normal.steps(e, generation);
        let tried = |step: Vector| e.tried(plus(normal.mean, normal.sigma, step));
        let trials = steps.into_iter().map(|step| Individual::new(tried(step), sigmas)).collect();
        let making = Making { ellipse: Some(normal.ellipse()), ..Making::default() };
        Brood::beside(&self.found.population, trials, generation).made_by(making)
    }

    fn tell(&mut self, e: &EvolutionSettings, brood: Brood, costs: &[f64]) -> GenerationRecord {
        let (generation, normal) = (brood.generation, self.normal(e));
        // As they were drawn: what was tried may be mirrored, or held at 0.
        let steps = normal.steps(e, generation);
        let brood = brood.with_costs(costs);
        let order = by_cost(&brood.offspring);
        let ranked: Vec<_> = order.iter().map(|number| steps[*number as usize]).collect();
        self.normal = Some(normal.moved(&ranked));
        let record = brood.survived_by_offspring();
        self.found.follow(&record);
        record
    }

    fn plan(&self, e: &EvolutionSettings) -> Plan {
        let Rates { weights, .. } = Rates::new(e.population as usize);
        Plan { ellipse: Some(self.normal(e).ellipse()), weights, ..Plan::default() }
    }

    found!(found);
}

impl CmaEs {
    fn normal(&self, e: &EvolutionSettings) -> Normal {
        let first = || Normal::new(first_drawn(e, 0).gains.to_array(), e.initial_sigma);
        self.normal.unwrap_or_else(first)
    }
}

/// The distribution, and the paths on which its changes are counted.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Normal {
    mean: Vector,
    sigma: f64,
    covariance: Matrix,
    /// The roots of its eigenvalues, and its eigenvectors.
    axes: (Vector, [Vector; 3]),
    /// p_σ, along which the steps of the mean are summed up for the length of the next ones.
    length_path: Vector,
    /// p_c, the same for their shape.
    shape_path: Vector,
    /// How many generations it has moved.
    moves: u32,
}

/// n, the number of gains.
const N: f64 = 3.0;

/// What |N(0, I)| is in the mean: √n (1 − 1/(4n) + 1/(21n²)).
const EXPECTED_LENGTH: f64 = 1.732_050_807_568_877_2 * (1.0 - 1.0 / 12.0 + 1.0 / 189.0);

/// The rates that follow from n and λ, by the tutorial's names.
struct Rates {
    /// w_i of the better half, which sum up to 1.
    weights: Vec<f64>,
    /// μ_eff = 1 / Σ w_i²
    effective: f64,
    /// c_σ, of p_σ.
    length: f64,
    /// d_σ, of σ.
    damping: f64,
    /// c_c, of p_c.
    shape: f64,
    /// c_1, of the covariance by p_c.
    rank_one: f64,
    /// c_μ, of the covariance by the steps.
    rank_mu: f64,
}

impl Rates {
    fn new(lambda: usize) -> Self {
        let mu = lambda / 2;
        let half = libm::log((lambda as f64 + 1.0) / 2.0);
        let raw: Vec<f64> = (1..=mu).map(|rank| half - libm::log(rank as f64)).collect();
        let sum: f64 = raw.iter().sum();
        let weights: Vec<f64> = raw.iter().map(|weight| weight / sum).collect();
        let effective = 1.0 / weights.iter().map(|weight| weight * weight).sum::<f64>();
        let length = (effective + 2.0) / (N + effective + 5.0);
        let excess = ((effective - 1.0) / (N + 1.0)).sqrt() - 1.0;
        let rank_one = 2.0 / ((N + 1.3) * (N + 1.3) + effective);
        let rank_mu =
            2.0 * (effective - 2.0 + 1.0 / effective) / ((N + 2.0) * (N + 2.0) + effective);
        Self {
            effective,
            length,
            damping: 1.0 + 2.0 * 0.0_f64.at_least(excess) + length,
            shape: (4.0 + effective / N) / (N + 4.0 + 2.0 * effective / N),
            rank_one,
            rank_mu: rank_mu.at_most(1.0 - rank_one),
            weights,
        }
    }
}

impl Normal {
    fn new(mean: Vector, sigma: f64) -> Self {
        let [length_path, shape_path] = [[0.0; 3]; 2];
        let axes = axes(&UNIT);
        Self { mean, sigma, covariance: UNIT, axes, length_path, shape_path, moves: 0 }
    }

    /// Draws y = C^½ z of a generation, one for each trial m + σ y.
    fn steps(&self, e: &EvolutionSettings, generation: u32) -> Vec<Vector> {
        let mut rng = stream(e.seed, Purpose::Steps, generation);
        let (roots, vectors) = self.axes;
        let step = |_| spectral(roots, &vectors, [0; 3].map(|_| StandardNormal.sample(&mut rng)));
        (0..e.population).map(step).collect()
    }

    /// The standard deviation of each gain.
    fn sigmas(&self) -> [f64; 3] {
        [0, 1, 2].map(|j| self.sigma * 0.0_f64.at_least(self.covariance[j][j]).sqrt())
    }

    fn ellipse(&self) -> Ellipse {
        let (roots, vectors) = self.axes;
        let order = in_order(3, &|i, j| roots[j].total_cmp(&roots[i]));
        let axis = |i: u32| vectors[i as usize].map(|x| self.sigma * roots[i as usize] * x);
        Ellipse { mean: self.mean.into(), axes: order.into_iter().map(axis).collect() }
    }

    /// The next distribution, after steps that are ordered by what they cost.
    fn moved(&self, ranked: &[Vector]) -> Self {
        let rates = Rates::new(ranked.len());
        let weighted = || rates.weights.iter().zip(ranked);
        let step = weighted().fold([0.0; 3], |sum, (weight, y)| plus(sum, *weight, *y));
        let (roots, vectors) = self.axes;
        let inverse = roots.map(|root| if root > 0.0 { 1.0 / root } else { 0.0 });
        let whitened = spectral(inverse, &vectors, step);
        let Rates { effective, length, damping, shape, rank_one, rank_mu, .. } = rates;
        let moves = self.moves + 1;

        let remembered = self.length_path.map(|p| (1.0 - length) * p);
        let gain = (length * (2.0 - length) * effective).sqrt();
        let length_path = plus(remembered, gain, whitened);
        let norm = dot(length_path, length_path).sqrt();
        let growth = (length / damping) * (norm / EXPECTED_LENGTH - 1.0);

        // Where the path is long because σ is too small, the shape does not learn from it.
        let forgotten = libm::pow(1.0 - length, 2.0 * f64::from(moves));
        let is_usual = norm / (1.0 - forgotten).sqrt() < (1.4 + 2.0 / (N + 1.0)) * EXPECTED_LENGTH;
        let learnt = if is_usual { (shape * (2.0 - shape) * effective).sqrt() } else { 0.0 };
        let shape_path = plus(self.shape_path.map(|p| (1.0 - shape) * p), learnt, step);
        let lost = if is_usual { 0.0 } else { rank_one * shape * (2.0 - shape) };

        let kept = 1.0 - rank_one - rank_mu + lost;
        let entry = |i: usize, j: usize| {
            let steps = weighted().fold(0.0, |sum, (weight, y)| sum + weight * y[i] * y[j]);
            kept * self.covariance[i][j]
                + rank_one * shape_path[i] * shape_path[j]
                + rank_mu * steps
        };
        let covariance = [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i.min(j), i.max(j))));
        Self {
            mean: plus(self.mean, self.sigma, step),
            sigma: self.sigma * libm::exp(1.0_f64.at_most(growth)),
            covariance,
            axes: axes(&covariance),
            length_path,
            shape_path,
            moves,
        }
    }
}

/// The roots of the eigenvalues of a covariance, and its eigenvectors.
fn axes(covariance: &Matrix) -> (Vector, [Vector; 3]) {
    let (values, vectors) = eigen(covariance);
    (values.map(|value| 0.0_f64.at_least(value).sqrt()), vectors)
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand::rngs::Xoshiro256PlusPlus;

    use super::*;

    /// Turned by 0.7 around z and then by 1.1 around x.
    fn turned([x, y, z]: Vector) -> Vector {
        let ((s, c), (t, d)) = (libm::sincos(0.7), libm::sincos(1.1));
        let [x, y] = [c * x - s * y, s * x + c * y];
        [x, d * y - t * z, t * y + d * z]
    }

    fn assert_near(a: Vector, b: Vector) {
        let scale = dot(a, a).sqrt().max(1e-300);
        assert!((0..3).all(|j| (a[j] - b[j]).abs() < 1e-9 * scale), "{a:?} {b:?}");
    }

    #[test]
    fn it_does_not_know_how_the_axes_lie() {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(3);
        let mut one = Normal::new([1.0, 2.0, 3.0], 0.5);
        let mut other = Normal::new(turned(one.mean), 0.5);
        for _ in 0..50 {
            let (roots, vectors) = one.axes;
            let mut steps: Vec<Vector> = (0..10)
                .map(|_| spectral(roots, &vectors, [0; 3].map(|_| StandardNormal.sample(&mut rng))))
                .collect();
            let cost = |y: &Vector| {
                let [a, b, c] = plus(one.mean, one.sigma, *y);
                a * a + 100.0 * b * b + 1e4 * c * c
            };
            steps.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
            one = one.moved(&steps);
            other = other.moved(&steps.into_iter().map(turned).collect::<Vec<_>>());
            assert_near(turned(one.mean), other.mean);
            assert_near(turned(one.shape_path), other.shape_path);
            assert_near(turned(one.length_path), other.length_path);
            assert!((one.sigma / other.sigma - 1.0).abs() < 1e-9);
        }
        assert!(dot(one.mean, one.mean) < 1.0, "it has come nearer");
    }

    /// The tutorial's table for n = 3 and λ = 7.
    #[test]
    fn its_rates_are_those_of_the_tutorial() {
        let rates = Rates::new(7);
        assert!((rates.weights.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        assert!(rates.weights.is_sorted_by(|a, b| a > b) && rates.weights.len() == 3);
        assert!((rates.effective - 2.2548).abs() < 1e-4, "{}", rates.effective);
        assert!((rates.length - 0.41491).abs() < 1e-4, "{}", rates.length);
        assert!((rates.damping - 1.41491).abs() < 1e-4, "{}", rates.damping);
        assert!((rates.shape - 0.55880).abs() < 1e-4, "{}", rates.shape);
        assert!((rates.rank_one - 0.09641).abs() < 1e-4, "{}", rates.rank_one);
        assert!((rates.rank_mu - 0.05124).abs() < 1e-4, "{}", rates.rank_mu);
        // Three normal draws are √(8/π) long in the mean.
        let mean = (8.0 / core::f64::consts::PI).sqrt();
        assert!((EXPECTED_LENGTH / mean - 1.0).abs() < 1e-3, "{EXPECTED_LENGTH}");
    }

    #[test]
    fn where_it_has_no_width_it_stays() {
        let mut flat = Normal::new([1.0; 3], 0.5);
        flat.covariance[2][2] = 0.0;
        flat.axes = axes(&flat.covariance);
        let next = flat.moved(&[[0.1, -0.2, 0.0]; 7]);
        assert_eq!((next.mean[2], next.length_path[2], next.axes.0[2]), (1.0, 0.0, 0.0));
        assert!(next.sigma.is_finite() && next.mean[0] > 1.0 && next.mean[1] < 1.0);
    }

    /// The limit for n = 3 and λ = 7 is a first step of 2.02 σ: beyond, the path is long because σ is too small.
    #[test]
    fn from_a_path_that_is_too_long_the_shape_does_not_learn() {
        let first = Normal::new([0.0; 3], 1.0);
        let shape_path = |step: f64| first.moved(&[[step, 0.0, 0.0]; 7]).shape_path[0];
        assert!(shape_path(2.0) > 0.0);
        assert_eq!(shape_path(2.04), 0.0);
    }
}
