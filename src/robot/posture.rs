//! Postures and velocities: equation (1).

use crate::number::Real;
use crate::schema::{
    Allowed, Fields, Input, InvalidInput, Place, Result, Source, Text, record, refused,
};

/// No lesson needs coordinates beyond a kilometre.
pub const METRES: Allowed = Allowed::within("m", -1000.0, 1000.0);
const RADIANS: Allowed = Allowed::within("rad", -100.0, 100.0);
/// Speeds along the way.
pub(crate) const METRES_A_SECOND: Allowed = Allowed::within("m/s", -100.0, 100.0);
/// Turn rates.
pub(crate) const RADIANS_A_SECOND: Allowed = Allowed::within("rad/s", -100.0, 100.0);

record! { input (Copy, Default)
    /// A posture p = (x, y, θ) in the global frame, equation (1).
    pub struct Posture {
        /// x in metres.
        pub x: f64 => "x" in METRES,
        /// y in metres.
        pub y: f64 => "y" in METRES,
        /// θ in radians, counter-clockwise from the X axis.
        pub theta: f64 => "theta" in RADIANS,
    }
}

record! { input (Copy)
    /// A velocity q = (v, ω).
    pub struct Velocity<S = f64> {
        /// v in m/s, positive forwards.
        pub linear: S => "linear" in METRES_A_SECOND,
        /// ω in rad/s, positive counter-clockwise.
        pub angular: S => "angular" in RADIANS_A_SECOND,
    }
}

impl Velocity {
    /// The velocity of a robot at rest.
    pub const ZERO: Self = Self { linear: 0.0, angular: 0.0 };
}

impl<S> Velocity<S> {
    /// What this function makes of v and of ω.
    #[inline]
    pub(crate) fn map<T>(self, mut f: impl FnMut(S) -> T) -> Velocity<T> {
        Velocity { linear: f(self.linear), angular: f(self.angular) }
    }
}

impl<S: Real> core::ops::Add for Velocity<S> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { linear: self.linear + other.linear, angular: self.angular + other.angular }
    }
}

/// Start postures, as many as `allowed` counts: a list of them, or their numbers (x, y, θ) side by side.
impl Input for Vec<Posture> {
    fn fields(path: &str, allowed: &Allowed, rows: &mut Fields) {
        Posture::fields(&format!("{path}[]"), allowed, rows);
    }

    fn check(&self, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        if !allowed.allows(self.len() as f64) {
            let expected =
                Text::from("a list of ") + allowed.min + " to " + allowed.max + " postures";
            let found = format!("a list of {}", self.len());
            return Err(InvalidInput::new(place.to_string(), expected, found));
        }
        let mut postures = self.iter().enumerate();
        postures.try_for_each(|(i, posture)| posture.check(Place::Element(&place, i), allowed))
    }

    fn read<S: Source>(&mut self, given: &S, place: Place<'_>, allowed: &Allowed) -> Result<()> {
        let most = allowed.max as usize;
        let expected = || Text::from("an array of ") + allowed.min + " to " + allowed.max;
        if let Some(numbers) = given.column(place, most.saturating_mul(3))? {
            let postures = numbers.chunks_exact(3);
            if !postures.remainder().is_empty() {
                let expected = "three numbers (x, y, θ) for each posture";
                let found = format!("{} numbers", numbers.len());
                return Err(InvalidInput::new(place.to_string(), expected, found));
            }
            *self = postures.map(|p| Posture { x: p[0], y: p[1], theta: p[2] }).collect();
            return Ok(());
        }
        let count = given.length(false).filter(|count| *count <= most);
        let count = count.ok_or_else(|| refused(given, place, expected()))?;
        self.clear();
        for i in 0..count {
            let mut posture = Posture::default();
            posture.read(&given.element(i), Place::Element(&place, i), allowed)?;
            self.push(posture);
        }
        Ok(())
    }
}
