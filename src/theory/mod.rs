//! What can be proved of the laws: the Lyapunov functions, and Theorem 2 on bounded disturbances.

mod lyapunov;

mod theorem2;

mod terms;

pub use lyapunov::{Lyapunov, PromisedRate};
pub use terms::{LawTerms, read_error};
pub use theorem2::{ErrorSizes, lyapunov_rate_bound, robust_gains, theorem_2_sets};
