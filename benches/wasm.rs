//! The WebAssembly part of `npm run bench`: the same work, called from Node without any glue.

mod work;

/// See [`work::lanes`].
#[unsafe(no_mangle)]
pub extern "C" fn lanes(case: u32, robots: u32) -> f64 {
    work::lanes(case, robots)
}

/// See [`work::scalar`].
#[unsafe(no_mangle)]
pub extern "C" fn scalar(case: u32, robots: u32) -> f64 {
    work::scalar(case, robots)
}

/// See [`work::samples`].
#[unsafe(no_mangle)]
pub extern "C" fn samples(case: u32, robots: u32) -> f64 {
    work::samples(case, robots)
}

/// See [`work::evolution`].
#[unsafe(no_mangle)]
pub extern "C" fn evolution(population: u32, generations: u32, horizon: f64) -> f64 {
    work::evolution(population, generations, horizon)
}

/// See [`work::landscape`].
#[unsafe(no_mangle)]
pub extern "C" fn landscape(count: u32) -> f64 {
    work::landscape(count)
}

/// See [`work::seeds`].
#[unsafe(no_mangle)]
pub extern "C" fn seeds() -> f64 {
    work::seeds()
}
