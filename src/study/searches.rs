//! What searches with many seeds have in common: what they may cost, and that all take a step together.

use crate::robot::Gains;
use crate::run::{BYTES_OF_AN_OBJECT, Setting, check_bytes, check_bytes_beside};
use crate::schema::Result;
use crate::search::Brood;

/// Parents, offspring, draws, costs, tournament: what a solution takes while its generation is under way.
const BYTES_OF_A_SOLUTION: f64 = 512.0;
const BYTES_OF_A_ROW: f64 = size_of::<[f64; 2]>() as f64;

/// Refuses so many searches, each with so many drives, if they take too long, or if what they keep takes too much memory:
/// their solutions, and in the end columns of two numbers for each of so many rows.
pub(super) fn check_searches(setting: &Setting, count: f64, drives: f64, rows: f64) -> Result<()> {
    let all = "the number of drives of all seeds together";
    setting.experiment().check_solutions(all, drives * count)?;
    let e = &setting.experiment().evolution;
    let solutions = f64::from(e.population.max(e.most_solutions())) * BYTES_OF_A_SOLUTION;
    let beside = solutions + BYTES_OF_AN_OBJECT;
    if count > 0.0 {
        // Where one alone takes too much, fewer seeds would not help.
        check_bytes_beside(beside, "the number of drives", rows, BYTES_OF_A_ROW)?;
    }
    check_bytes("the number of seeds", count, beside + rows * BYTES_OF_A_ROW)
}

/// So many solutions are driven at once: enough for every lane, and few beside those that the searches keep.
const AT_ONCE: usize = 1 << 14;

/// Asks each search for what it tries next, and tells it what that has cost. Many are driven together, so that there are many
/// runs to drive at once.
pub(super) fn step_together<S>(
    setting: &Setting,
    searches: &mut [S],
    ask: impl Fn(&mut S) -> (Brood, Vec<Gains>),
    tell: impl Fn(&mut S, Brood, &[f64]),
) {
    let each = setting.experiment().evolution.most_solutions() as usize;
    for some in searches.chunks_mut((AT_ONCE / each).max(1)) {
        let (broods, gains): (Vec<_>, Vec<_>) = some.iter_mut().map(&ask).unzip();
        let costs = setting.totals(&gains.concat());
        let mut rest = costs.as_slice();
        for ((search, brood), gains) in some.iter_mut().zip(broods).zip(gains) {
            let (own, others) = rest.split_at(gains.len());
            tell(search, brood, own);
            rest = others;
        }
    }
}
