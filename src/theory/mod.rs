//! What can be proved of the laws: the Lyapunov functions, and Theorem 2 on bounded disturbances.

mod lyapunov;

mod theorem2;

mod terms;

pub use lyapunov::{Lyapunov, lyapunov_rate_parts};
pub use terms::{LawTerms, PromisedRate, read_error};
pub use theorem2::{ErrorParts, lyapunov_rate_bound, robust_gains, theorem_2_sets};
