//! What can be asked from outside, in whatever language, and the types that TypeScript has for it.

mod given;

mod calls;

mod declarations;

pub use calls::*;
pub use declarations::declarations;
pub use given::{experiment, generation, number, setting, start, steps};

#[cfg(all(target_arch = "wasm32", any(feature = "javascript", feature = "bytes")))]
// else there is no boundary
pub(crate) use calls::calls;
