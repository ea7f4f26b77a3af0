//! The cost J of equation (9), in its named parts.

use nalgebra::Vector3;

use crate::number::Real;
use crate::robot::{ErrorPosture, Frame, Gains};
use crate::schema::{Allowed, record, told};

const WEIGHT: Allowed = Allowed::within("", 0.0, 1e6);

record! { input (Copy)
    /// The weights of the cost (9). The paper does not give them; ours are W = I, R = I, κ = 1000.
    pub struct Weights {
        /// The diagonal of W, on the final (x, y, θ) error in the global frame.
        pub final_error: [f64; 3] => "final" in WEIGHT,
        /// The diagonal of R, on the velocity (v, ω).
        pub velocity: [f64; 2] => "velocity" in WEIGHT,
        /// κ, on negative gains.
        pub penalty: f64 => "penalty" in WEIGHT,
    }
}

/// J = t_f + (p(t_f) − p_r)ᵀ W (p(t_f) − p_r) + ½ ∫ ((p − p_r)ᵀ(p − p_r) + qᵀ R q) dt + κ Σ max(0, −k_i),
/// equation (9). Lower is better. A part that is not a number counts as infinite. The parts have different units: J is their sum
/// as bare numbers, in metres, seconds and radians, and would be another in others.
///
/// Our choices, for the paper is silent or says another thing: q is the velocity that is driven, after the limits and
/// without the disturbance, where (9) prints the commanded q_m; the integrals are sums over the samples, each with the values
/// at its beginning; angles count in radians, θ − θ_r in [−π, π); the robot begins at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// t_f in seconds.
    pub time: f64,
    /// (p(t_f) − p_r)ᵀ W (p(t_f) − p_r)
    pub final_error: f64,
    /// ½ ∫ (p − p_r)ᵀ(p − p_r) dt
    pub path: f64,
    /// ½ ∫ qᵀ R q dt
    pub energy: f64,
    /// κ Σ max(0, −k_i)
    pub penalty: f64,
}

told! {
    /// The cost J of equation (9) and its parts. Lower is better; Infinity if the run left the finite numbers, or a sum of
    /// squares did, whatever its weight.
    Cost: Cost {
        /// J, the sum of the parts.
        "total" => |cost| cost.total(),
        /// t_f in seconds.
        "time" => |cost| cost.time,
        /// (p(t_f) − p_r)ᵀ W (p(t_f) − p_r)
        "finalError" => |cost| cost.final_error,
        /// ½ ∫ (p − p_r)ᵀ(p − p_r) dt
        "path" => |cost| cost.path,
        /// ½ ∫ qᵀ R q dt
        "energy" => |cost| cost.energy,
        /// κ Σ max(0, −k_i)
        "penalty" => |cost| cost.penalty,
    }
}

impl Cost {
    /// J, the sum of the parts.
    pub fn total(&self) -> f64 {
        self.time + self.final_error + self.path + self.energy + self.penalty
    }

    /// The mean of several costs, part by part; of none it is NaN.
    pub fn mean(costs: impl ExactSizeIterator<Item = Cost>) -> Cost {
        let count = costs.len() as f64;
        let sum = costs.fold(Cost::default(), |a, b| a.zip(b, |a, b| a + b));
        sum.zip(sum, |a, _| a / count)
    }

    /// The same cost with every part that is NaN made infinite.
    pub(crate) fn without_nan(self) -> Cost {
        self.zip(self, |a, _| if a.is_nan() { f64::INFINITY } else { a })
    }

    fn zip(self, other: Cost, f: impl Fn(f64, f64) -> f64) -> Cost {
        Cost {
            time: f(self.time, other.time),
            final_error: f(self.final_error, other.final_error),
            path: f(self.path, other.path),
            energy: f(self.energy, other.energy),
            penalty: f(self.penalty, other.penalty),
        }
    }
}

impl Weights {
    /// (p − p_r)ᵀ W (p − p_r) in the frame of the reference: W is in the global one.
    pub(crate) fn final_error(&self, e: &ErrorPosture, frame: &Frame) -> f64 {
        let global = frame.global(e);
        let p = Vector3::new(global.x, global.y, e.theta);
        p.dot(&Vector3::from(self.final_error).component_mul(&p))
    }

    /// κ Σ max(0, −k_i)
    pub(crate) fn penalty(&self, k: &Gains) -> f64 {
        self.penalty * k.to_array().map(|k| 0.0_f64.at_least(-k)).iter().sum::<f64>()
    }
}
