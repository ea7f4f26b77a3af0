//! The stochastic tournament (steps 5 and 6 of the paper's procedure).

use core::cmp::Ordering;

use rand::{Rng, RngExt};

/// Whom each solution met, and how many bouts it won.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tournament {
    /// For each solution the numbers of its q opponents.
    pub opponents: Vec<Vec<u32>>,
    /// For each solution the number of bouts won.
    pub wins: Vec<u32>,
}

/// Whether a solution wins its bout: its J is at most the opponent's. A J that is not finite never wins.
pub fn wins_bout(cost: f64, opponent: f64) -> bool {
    cost.is_finite() && cost <= opponent
}

/// Any of so many but oneself.
///
/// # Panics
/// If there is nobody else.
pub(super) fn another(own: u32, count: u32, rng: &mut impl Rng) -> u32 {
    let drawn = rng.random_range(0..count - 1);
    if drawn < own { drawn } else { drawn + 1 }
}

impl Tournament {
    /// Each solution meets `q` opponents, drawn uniformly and with replacement from all the others.
    ///
    /// That a solution may meet another twice, and never itself, is our choice.
    ///
    /// # Panics
    /// If there is one solution alone, and it shall meet others.
    pub fn hold(costs: &[f64], q: u32, rng: &mut impl Rng) -> Self {
        let count = costs.len() as u32;
        let opponents: Vec<Vec<u32>> =
            (0..count).map(|own| (0..q).map(|_| another(own, count, rng)).collect()).collect();
        let wins = costs
            .iter()
            .zip(&opponents)
            .map(|(cost, met)| {
                let won = met.iter().filter(|other| wins_bout(*cost, costs[**other as usize]));
                won.count() as u32
            })
            .collect();
        Self { opponents, wins }
    }

    /// All solutions in the order of their rank: most wins first, then lower J, then lower number. How ties are
    /// broken is our choice.
    ///
    /// # Panics
    /// If there are more costs than solutions.
    pub fn ranking(&self, costs: &[f64]) -> Vec<u32> {
        in_order(costs.len(), &|i, j| {
            self.wins[j].cmp(&self.wins[i]).then(costs[i].total_cmp(&costs[j]))
        })
    }
}

/// The numbers of so many solutions in this order; those that are equal by their number.
///
/// Neighbours are merged, then pairs, then fours. The sorts of the standard library would make the module 8 kB larger.
pub(super) fn in_order(count: usize, order: &dyn Fn(usize, usize) -> Ordering) -> Vec<u32> {
    let mut numbers: Vec<u32> = (0..count as u32).collect();
    let mut merged = numbers.clone();
    let mut width = 1;
    while width < count {
        for (from, to) in numbers.chunks(2 * width).zip(merged.chunks_mut(2 * width)) {
            let (mut left, mut right) = from.split_at(width.min(from.len()));
            for slot in to {
                let first = match (left.first(), right.first()) {
                    (Some(l), Some(r)) => order(*l as usize, *r as usize).is_le(),
                    (l, _) => l.is_some(),
                };
                let side = if first { &mut left } else { &mut right };
                *slot = side[0];
                *side = &side[1..];
            }
        }
        core::mem::swap(&mut numbers, &mut merged);
        width *= 2;
    }
    numbers
}
