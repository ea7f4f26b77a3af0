//! One robot: where it is and how it moves, what the law commands, and what the motors and the ground make of it.

mod posture;

mod arc;

mod error;

mod gains;

mod law;

mod limits;

mod disturbance;

pub use disturbance::{Disturbance, DisturbanceKind};
pub use error::ErrorPosture;
pub use gains::Gains;
pub use law::{CommandTerms, Law, SMALLEST_DIVISOR};
pub use limits::Limits;
pub use posture::{METRES, Posture, Velocity};

pub(crate) use arc::Arc;
pub(crate) use disturbance::DisturbanceSequence;
pub(crate) use error::Frame;
pub(crate) use gains::Triples;
pub(crate) use limits::limit;
