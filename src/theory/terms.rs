//! What a law makes of one error posture.

use super::lyapunov::PromisedRate;
use crate::robot::{CommandTerms, ErrorPosture, Gains, Law, Posture, Velocity};
use crate::schema::{Place, Plain, Result, Source, read_object, record, refused};

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
        Self { command: law.terms(e, k, r), promised: law.promised_rate(e, k, r) }
    }
}

/// An error posture that is given by its three numbers.
pub fn read_error<S: Source>(given: &S) -> Result<ErrorPosture> {
    let place = Place::Named("error");
    read_object(given, place, Posture::KEYS)?;
    let number = |name| {
        let (given, at) = (given.field(name), Place::Field(&place, name));
        let number = given.number().filter(|number| number.is_finite());
        number.ok_or_else(|| refused(&given, at, "a finite number"))
    };
    Ok(ErrorPosture::new(number("x")?, number("y")?, number("theta")?))
}
