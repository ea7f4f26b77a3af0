//! The native part of `npm run bench`: milliseconds of each measurement, as JSON.

#[allow(dead_code)] // the rest is measured as WebAssembly only
mod work;

use std::hint::black_box;
use std::time::Instant;

fn main() {
    // Cargo passes --bench; numbers are the rounds and the robots.
    let numbers: Vec<u32> = std::env::args().filter_map(|arg| arg.parse().ok()).collect();
    let [rounds, robots] = numbers.try_into().unwrap_or([9, 4096]);
    let measured = |f: &dyn Fn() -> f64| -> Vec<String> {
        let time = |_| {
            let start = Instant::now();
            black_box(f());
            format!("{:.4}", start.elapsed().as_secs_f64() * 1e3)
        };
        (0..rounds).map(time).collect()
    };
    let json =
        |name: &str, f: &dyn Fn() -> f64| format!("\"{name}\": [{}]", measured(f).join(", "));
    println!(
        "{{{}, {}, {}, {}}}",
        json("lanes0", &|| work::lanes(0, robots)),
        json("lanes1", &|| work::lanes(1, robots)),
        json("scalar0", &|| work::scalar(0, robots)),
        json("scalar1", &|| work::scalar(1, robots)),
    );
}
