//! Many runs at once: teams of robots that are driven side by side in SIMD lanes, each as if it were alone.
//!
//! All teams are driven for a block of samples in which nobody looks whether a run has ended. Whoever may have, or has
//! come where the formulas for several robots do not hold, drives that block again alone.

use super::cost::Cost;
use super::rules::Rules;
use super::runs::{Departure, RunEnd, Runs};
use super::setting::Setting;
use super::team::{BLOCK, Bounds, Team};
use super::work::check_bytes;
use crate::number::{LANES, Real};
use crate::robot::{DisturbanceKind, Gains};
use crate::schema::Result;

/// Most teams that are driven in turn: so many that the processor need not wait for the divisions of one.
const TEAMS: usize = 12;

/// About how many runs are driven before their ends become costs: enough to keep all teams busy, few enough for the
/// processor's memory.
const PART: usize = 8192;

/// What a sample of all teams may hold.
#[derive(Clone, Copy, PartialEq)]
enum Course {
    /// Nobody is disturbed, and no limit lets anybody turn far.
    Gentle,
    /// Nobody is disturbed.
    Undisturbed,
    /// Anything.
    Disturbed,
}

impl Setting {
    /// J of each of these gains, the mean over the start postures.
    ///
    /// The error says how many are allowed in one call.
    pub fn evaluate(&self, gains: &[Gains]) -> Result<Vec<f64>> {
        let (what, count) = ("the number of gain triples", gains.len() as f64);
        self.experiment().check_drives(what, count, self.experiment().starts.len())?;
        check_bytes(what, count, size_of::<[Cost; 2]>() as f64)?;
        Ok(self.totals(gains))
    }

    /// J of each of these gains, the mean over the start postures.
    pub(crate) fn totals(&self, gains: &[Gains]) -> Vec<f64> {
        self.costs(gains).iter().map(Cost::total).collect()
    }

    /// J of each of these gains, in parts: the mean over all start postures.
    pub fn costs(&self, gains: &[Gains]) -> Vec<Cost> {
        let starts = &self.experiment().starts;
        let mut costs = Vec::with_capacity(gains.len());
        for gains in gains.chunks((PART / starts.len()).max(1)) {
            let ends = self.drive(gains.len() * starts.len(), &|i| {
                let start = i % starts.len();
                let (gains, stream) = (gains[i / starts.len()], start as u32);
                Departure { gains, start: starts[start], stream }
            });
            let each = ends.chunks_exact(starts.len());
            costs.extend(each.map(|ends| Cost::mean(ends.iter().map(|end| end.cost))));
        }
        costs
    }

    /// J of these gains, in parts: the mean over all start postures.
    pub fn cost(&self, gains: &Gains) -> Cost {
        self.costs(core::slice::from_ref(gains))[0]
    }

    /// The ends of `count` runs, in their order.
    pub(crate) fn drive(
        &self,
        count: usize,
        departure: &dyn Fn(usize) -> Departure,
    ) -> Vec<RunEnd> {
        let mut runs = Runs::new(self, count, departure);
        let mut teams = vec![Team::idle(); count.div_ceil(LANES).min(TEAMS)];
        let bounds = Bounds::new(&self.rules());
        let mut now = 0;
        loop {
            teams.iter_mut().for_each(|team| team.take_up(&mut runs, now));
            teams.retain(|team| team.seats.iter().any(Option::is_some));
            let seats = teams.iter().flat_map(|team| &team.seats).flatten();
            let Some(horizon) = seats.map(|seat| seat.horizon).min() else { return runs.ends };
            let mut vacant = false;
            while now < horizon && !vacant {
                let samples = (horizon - now).min(BLOCK as u64) as usize;
                self.drive_block(&mut teams, samples);
                now += samples as u64;
                for team in &mut teams {
                    let usual = team.stayed_within(&bounds);
                    if !usual.all() {
                        vacant |= team.drive_again(usual, &mut runs, now, samples);
                    }
                }
            }
            if now == horizon {
                teams.iter_mut().for_each(|team| team.end_at_horizon(&mut runs, now));
            }
        }
    }

    /// Drives all teams for so many samples, as if no run could end.
    fn drive_block(&self, teams: &mut [Team], samples: usize) {
        let rules = self.rules();
        for team in &mut *teams {
            team.set_out();
        }
        if self.experiment().disturbance.kind != DisturbanceKind::None {
            teams.iter_mut().for_each(|team| team.draw_disturbances(samples));
            drive_teams(&rules, teams, samples, Course::Disturbed);
        } else if let Some(rules) = rules.parking::<false>() {
            drive_teams(&rules, teams, samples, Course::Gentle);
        } else if let Some(rules) = rules.parking::<true>() {
            drive_teams(&rules, teams, samples, Course::Gentle);
        } else {
            drive_teams(&rules, teams, samples, Course::Undisturbed);
        }
    }
}

/// Each sample in two halves, each for all teams in turn: the processor then works at several teams at once.
#[inline(always)]
fn drive_teams(rules: &Rules, teams: &mut [Team], samples: usize, course: Course) {
    for sample in 0..samples {
        for Team { robots, gains, extremes, .. } in &mut *teams {
            let error = &robots.error;
            let heading = error.theta * error.theta;
            extremes.least_distance = extremes.least_distance.at_most(error.squared_distance());
            extremes.least_heading = extremes.least_heading.at_most(heading);
            extremes.largest_heading = extremes.largest_heading.at_least(heading);
            (*robots, _) = rules.decided(robots, gains);
        }
        for Team { robots, disturbances, extremes, .. } in &mut *teams {
            let disturbance = (course == Course::Disturbed).then(|| disturbances[sample]);
            let (next, arc) = rules.moved(robots, disturbance);
            if course != Course::Gentle {
                let rate = arc.turn_rate();
                extremes.largest_turn_rate = extremes.largest_turn_rate.at_least(rate * rate);
            }
            *robots = next;
        }
    }
}
