//! What a law makes of one error posture.

use crate::robot::{CommandTerms, ErrorPosture, Gains, Law, Posture, Velocity};
use crate::schema::{InvalidInput, Place, Plain, Source, read_object, record, refused};

record! { (Copy)
    /// The parts of dV/dt that a law promises for its command, in m²/s, as in `Stability`.
    pub struct PromisedRate {
        /// The part on x_e.
        pub x: f64 => "x",
        /// The part on y_e.
        pub y: f64 => "y",
        /// The part on θ_e.
        pub theta: f64 => "theta",
    }
}

record! { (Copy)
    /// What the control law makes of an error posture.
    pub struct LawTerms {
        /// What each gain asks for, and the reference velocity by itself: the command is their sum, up to rounding.
        pub command: CommandTerms => "command",
        /// What the law promises of dV/dt; null where nothing is promised.
        pub promised: Option<PromisedRate> => "promised",
    }
}

impl LawTerms {
    /// The terms of a law with these gains while the reference moves with `r`.
    pub fn new(law: Law, e: &ErrorPosture, k: &Gains, r: Velocity) -> Self {
        let promised = law.promised_rate(e, k, r).map(|[x, y, theta]| PromisedRate { x, y, theta });
        Self { command: law.terms(e, k, r), promised }
    }
}

/// An error posture that is given by its three numbers.
pub fn read_error<S: Source>(given: &S) -> Result<ErrorPosture, InvalidInput> {
    let place = Place::Named("error");
    read_object(given, place, Posture::KEYS)?;
    let number = |name| {
        let (given, at) = (given.field(name), Place::Field(&place, name));
        let number = given.number().filter(|number| number.is_finite());
        number.ok_or_else(|| refused(&given, at, "a finite number"))
    };
    Ok(ErrorPosture::new(number("x")?, number("y")?, number("theta")?))
}
