//! What a search is told before it begins.

use crate::number::Real;
use crate::robot::Gains;
use crate::schema::{Allowed, InvalidInput, Result, Text, record, words};

words! {
    input
    /// How gains are looked for: by the paper's evolutionary programming, or by one of its rivals.
    pub enum Method {
        /// Evolutionary programming, the paper's.
        Ep = "ep",
        /// Random search.
        Random = "random",
        /// Differential evolution, DE/rand/1/bin.
        De = "de",
        /// Covariance matrix adaptation.
        CmaEs = "cma-es",
        /// One parent, one offspring, and the 1/5 success rule.
        OnePlusOneEs = "one-plus-one-es",
        /// The simplex of Nelder and Mead, begun anew where it has shrunk to a point.
        NelderMead = "nelder-mead",
        /// One gain after the other, as a hand does it.
        OneAtATime = "one-at-a-time",
        /// Down the slope, which finite differences tell.
        FiniteDifferences = "finite-differences",
    }
}

words! {
    input
    /// How the steps of a mutation are distributed.
    pub enum Step {
        /// Normally, as in the paper.
        Gaussian = "gaussian",
        /// As Cauchy's distribution has it: small less often, at times much larger.
        Cauchy = "cauchy",
    }
}

words! {
    input
    /// Which solutions of a generation of evolutionary programming survive.
    pub enum Selection {
        /// Those with the most wins in the paper's tournament.
        Tournament = "tournament",
        /// Those of lowest J.
        Truncation = "truncation",
        /// The better one of each parent and its offspring.
        Parent = "parent",
    }
}

words! {
    input
    /// What becomes of gains under 0.
    pub enum BelowZero {
        /// They are tried, and J counts a penalty for them.
        Penalty = "penalty",
        /// They are mirrored at 0 before they are tried.
        Mirror = "mirror",
        /// They are 0 when they are tried, as at the end of a slider.
        Clamp = "clamp",
    }
}

record! { input (Copy)
    /// The settings of the search: those of evolutionary programming (section 4 of the paper), its ingredients, and its rivals.
    pub struct EvolutionSettings {
        /// N: the parents of evolutionary programming, the draws of random search in a generation, the members of
        /// differential evolution (at least 4), λ of CMA-ES (at least 2). The other methods go from one point to the next.
        pub population: u32 => "population" in Allowed::whole(1, 2000),
        /// q, the number of opponents that each solution meets in the tournament.
        pub opponents: u32 => "opponents" in Allowed::whole(1, 1000),
        /// The seed of all draws.
        pub seed: u32 => "seed" in Allowed::SEED,
        /// The interval from which the first gains are drawn.
        pub initial_range: [f64; 2] => "initialRange" in Allowed::within("", -1e6, 1e6),
        /// The first σ of every gain, or the floor where that is larger; of other methods the first step.
        pub initial_sigma: f64 => "initialSigma" in Allowed::within("", 0.0, 1e6),
        /// How gains are looked for.
        pub method: Method => "method",
        /// How the steps of evolutionary programming are distributed.
        pub step: Step => "step",
        /// A factor on τ and τ′ of evolutionary programming; with 0 every σ stays.
        pub adaptation: f64 => "adaptation" in Allowed::within("", 0.0, 10.0),
        /// What no σ of evolutionary programming falls under.
        pub sigma_floor: f64 => "sigmaFloor" in Allowed::within("", 0.0, 1e6),
        /// Which solutions of evolutionary programming survive.
        pub selection: Selection => "selection",
        /// How probable it is that a parent of evolutionary programming is crossed with another before it is mutated: each
        /// gain, with its σ, is then that of the one or the other.
        pub crossover: f64 => "crossover" in Allowed::within("", 0.0, 1.0),
        /// What becomes of gains under 0.
        pub below_zero: BelowZero => "belowZero",
    }
}

impl EvolutionSettings {
    /// The first σ, which in evolutionary programming is not under its floor.
    pub(super) fn first_sigma(&self) -> f64 {
        match self.method {
            Method::Ep => self.initial_sigma.at_least(self.sigma_floor),
            _ => self.initial_sigma,
        }
    }

    /// Checks the rules between fields.
    pub(crate) fn check_rules(&self) -> Result<()> {
        let [low, high] = self.initial_range;
        if low >= high {
            let expected = "[low, high] with low under high";
            let found = Text::from("[") + low + ", " + high + "]";
            return Err(InvalidInput::new("evolution.initialRange", expected, found));
        }
        let least = self.least_solutions();
        if !self.is_by_population() || self.population >= least {
            return Ok(());
        }
        let expected = format!("{least} or more with the method '{}'", self.method.word());
        Err(InvalidInput::new("evolution.population", expected, self.population))
    }

    /// Most new solutions in a generation of a method that has a number of its own.
    fn own_solutions(&self) -> Option<u32> {
        match self.method {
            Method::Ep | Method::Random | Method::De | Method::CmaEs => None,
            Method::NelderMead => Some(4),
            Method::FiniteDifferences => Some(3),
            Method::OnePlusOneEs | Method::OneAtATime => Some(1),
        }
    }

    /// Whether a generation has as many new solutions as the population members.
    fn is_by_population(&self) -> bool {
        self.own_solutions().is_none()
    }

    /// Fewest new solutions in a generation that the method can do with.
    pub(crate) fn least_solutions(&self) -> u32 {
        match self.method {
            Method::De => 4,
            Method::CmaEs => 2,
            Method::Ep | Method::Random => 1,
            Method::NelderMead
            | Method::FiniteDifferences
            | Method::OnePlusOneEs
            | Method::OneAtATime => self.most_solutions(),
        }
    }

    /// Most new solutions in a generation.
    pub(crate) fn most_solutions(&self) -> u32 {
        self.own_solutions().unwrap_or(self.population)
    }

    /// How many bouts of the tournament each solution has.
    pub(crate) fn bouts(&self) -> u32 {
        match (self.method, self.selection) {
            (Method::Ep, Selection::Tournament) => self.opponents,
            _ => 0,
        }
    }

    /// The gains that are tried for these.
    pub(super) fn tried(&self, gains: [f64; 3]) -> Gains {
        match self.below_zero {
            BelowZero::Penalty => gains.into(),
            BelowZero::Mirror => gains.map(f64::abs).into(),
            BelowZero::Clamp => gains.map(|gain| gain.at_least(0.0)).into(),
        }
    }
}
