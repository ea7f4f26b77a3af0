//! What is added to the velocity that the robot applies: assumptions B and C of the paper.

use rand::RngExt;
use rand::rngs::Xoshiro256PlusPlus;

use super::posture::{METRES_A_SECOND, RADIANS_A_SECOND, Velocity};
use crate::number::{Purpose, stream};
use crate::schema::{Allowed, record, words};

words! { input
    /// The kinds of disturbance δ = (δ1, δ2).
    pub enum DisturbanceKind {
        /// δ = 0.
        None = "none",
        /// Each component uniform in [−ε, ε), drawn afresh at each sample.
        Random = "random",
        /// δ is (linear, angular) at every sample, with their signs: wheels that slip.
        Slip = "slip",
    }
}

record! { input (Copy)
    /// What is added to the applied velocity, after the limits (our choice): fresh noise in ±(linear, angular) at each
    /// sample, or a constant slip.
    pub struct Disturbance {
        /// Which kind.
        pub kind: DisturbanceKind => "kind",
        /// ε1 or the slip, in m/s.
        pub linear: f64 => "linear" in METRES_A_SECOND,
        /// ε2 or the slip, in rad/s.
        pub angular: f64 => "angular" in RADIANS_A_SECOND,
        /// Seed of the random kind.
        pub seed: u32 => "seed" in Allowed::SEED,
    }
}

impl Disturbance {
    /// No disturbance.
    pub const NONE: Self = Self { kind: DisturbanceKind::None, linear: 0.0, angular: 0.0, seed: 0 };

    /// (ε1, ε2), the bounds of |δ1| and |δ2|.
    pub fn bound(&self) -> Velocity {
        match self.kind {
            DisturbanceKind::None => Velocity::ZERO,
            DisturbanceKind::Random | DisturbanceKind::Slip => self.velocity().map(f64::abs),
        }
    }

    fn velocity(&self) -> Velocity {
        Velocity { linear: self.linear, angular: self.angular }
    }

    /// The disturbances of a run from the start posture with this index, sample by sample.
    ///
    /// They do not depend on the gains, so that all gains are tried on the same bad luck.
    pub(crate) fn sequence(&self, start: u32) -> DisturbanceSequence {
        match self.kind {
            DisturbanceKind::None => DisturbanceSequence::None,
            DisturbanceKind::Slip => DisturbanceSequence::Constant(self.velocity()),
            DisturbanceKind::Random => DisturbanceSequence::Random {
                bound: self.velocity(),
                rng: stream(self.seed, Purpose::Disturbance, start),
            },
        }
    }
}

/// The disturbances of one run.
#[derive(Clone, Debug)]
pub(crate) enum DisturbanceSequence {
    None,
    Constant(Velocity),
    Random { bound: Velocity, rng: Xoshiro256PlusPlus },
}

impl DisturbanceSequence {
    #[inline]
    pub(crate) fn next(&mut self) -> Option<Velocity> {
        match self {
            Self::None => None,
            Self::Constant(velocity) => Some(*velocity),
            Self::Random { bound, rng } => {
                Some(bound.map(|bound| bound * (2.0 * rng.random::<f64>() - 1.0)))
            }
        }
    }
}
