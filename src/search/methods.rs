//! The methods, by their names.

use super::cma_es::CmaEs;
use super::differential_evolution::DifferentialEvolution;
use super::evolutionary_programming::EvolutionaryProgramming;
use super::finite_differences::FiniteDifferences;
use super::nelder_mead::NelderMead;
use super::one_at_a_time::OneAtATime;
use super::one_plus_one::OnePlusOne;
use super::random::RandomSearch;
use super::search::Search;
use super::settings::Method;

/// A search that has tried nothing yet.
pub fn search(method: Method) -> Box<dyn Search> {
    match method {
        Method::Ep => Box::<EvolutionaryProgramming>::default(),
        Method::Random => Box::<RandomSearch>::default(),
        Method::De => Box::<DifferentialEvolution>::default(),
        Method::CmaEs => Box::<CmaEs>::default(),
        Method::OnePlusOneEs => Box::<OnePlusOne>::default(),
        Method::NelderMead => Box::<NelderMead>::default(),
        Method::OneAtATime => Box::<OneAtATime>::default(),
        Method::FiniteDifferences => Box::<FiniteDifferences>::default(),
    }
}
