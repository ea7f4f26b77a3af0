//! What a method goes by, besides its population.

use crate::robot::Gains;
use crate::schema::{record, words};

record! {
    /// The normal distribution from which CMA-ES draws a generation.
    pub struct Ellipse {
        /// Its centre.
        pub mean: Gains => "mean",
        /// The three semi-axes of its ellipsoid of one standard deviation, the longest first.
        pub axes: Vec<[f64; 3]> => "axes",
    }
}

words! {
    /// A move of Nelder and Mead's simplex.
    pub enum Motion {
        /// A new simplex begins.
        Begin = "begin",
        /// The worst corner on the other side of the centre of the others.
        Reflection = "reflection",
        /// Twice as far, for the reflected one is the best.
        Expansion = "expansion",
        /// Half as far, for the reflected one would be the worst.
        OutsideContraction = "outside-contraction",
        /// Half of the way to the worst, for the reflected one is worse still.
        InsideContraction = "inside-contraction",
        /// All corners but the best, half of the way to it.
        Shrink = "shrink",
    }
}

record! { (Default)
    /// What a method goes by when it asks, besides its population; null or empty is what it does not have.
    pub struct Plan {
        /// The move of Nelder and Mead's simplex.
        pub motion: Option<Motion> => "motion",
        /// Its four corners by their places in the population, best first; empty where a simplex begins.
        pub corners: Vec<u32> => "corners",
        /// The distribution from which CMA-ES draws.
        pub ellipse: Option<Ellipse> => "ellipse",
        /// By how much the trials of CMA-ES will move its mean, the best first; those after them do not count.
        pub weights: Vec<f64> => "weights",
        /// How much J rises by a gain, as finite differences have told.
        pub slope: Option<[f64; 3]> => "slope",
        /// The next step in each gain: down the slope; one gain at a time, when it is its turn; σ of the (1+1) strategy.
        pub steps: Option<[f64; 3]> => "steps",
    }
}
