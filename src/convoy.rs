//! Many runs at once: teams of robots that are driven side by side in SIMD lanes, each as if it were alone.
//!
//! All teams are driven for a block of samples in which nobody looks whether a run has ended. Whoever may have, or has
//! come where the formulas for several robots do not hold, drives that block again alone.

use core::f64::consts::PI;

use crate::control::Gains;
use crate::cost::Cost;
use crate::disturbance::{DisturbanceKind, DisturbanceSequence};
use crate::episode::{Outcome, Robot, Rules, Setting};
use crate::lanes::{LANES, Lanes};
use crate::posture::{ErrorPosture, Posture, Velocity};
use crate::real::{Real, SMALL_TURN};

/// Most teams that are driven in turn: so many that the processor need not wait for the divisions of one.
const TEAMS: usize = 12;

/// Samples in a block.
const BLOCK: usize = 16;

/// One run that is to be driven.
#[derive(Clone, Copy)]
pub(crate) struct Run {
    pub(crate) gains: Gains,
    pub(crate) start: Posture,
    /// Which of the streams of disturbances it meets.
    pub(crate) stream: u32,
}

/// How a run ended, and what it cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunEnd {
    /// J in parts; its time is t_f.
    pub cost: Cost,
    /// How the run ended.
    pub outcome: Outcome,
}

impl Setting {
    /// J of each of these gains, in parts: the mean over all start postures.
    pub fn costs(&self, gains: &[Gains]) -> Vec<Cost> {
        let starts = &self.experiment().starts;
        let run = |i| {
            let start = i % starts.len();
            Run { gains: gains[i / starts.len()], start: starts[start], stream: start as u32 }
        };
        let ends = self.drive(gains.len() * starts.len(), run);
        ends.chunks_exact(starts.len())
            .map(|ends| Cost::mean(ends.iter().map(|end| end.cost)))
            .collect()
    }

    /// J of these gains, in parts: the mean over all start postures.
    pub fn cost(&self, gains: &Gains) -> Cost {
        self.costs(core::slice::from_ref(gains))[0]
    }

    /// The ends of `count` runs, in their order.
    pub(crate) fn drive(&self, count: usize, run: impl Fn(usize) -> Run) -> Vec<RunEnd> {
        let mut runs = Runs::new(self, count, run);
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
            drive_teams(&rules, teams, samples, true, true);
        } else if let Some(rules) = rules.parking::<false>() {
            drive_teams(&rules, teams, samples, false, false);
        } else if let Some(rules) = rules.parking::<true>() {
            drive_teams(&rules, teams, samples, false, false);
        } else {
            drive_teams(&rules, teams, samples, false, true);
        }
    }
}

/// Runs that are taken up one after the other, and how they ended.
struct Runs<'a, F> {
    setting: &'a Setting,
    run: F,
    taken: usize,
    ends: Vec<RunEnd>,
}

impl<'a, F: Fn(usize) -> Run> Runs<'a, F> {
    fn new(setting: &'a Setting, count: usize, run: F) -> Self {
        let ends = vec![RunEnd { cost: Cost::default(), outcome: Outcome::Horizon }; count];
        Self { setting, run, taken: 0, ends }
    }

    /// The next robot that does not start at its goal, and its seat.
    fn next(&mut self, now: u64) -> Option<(Robot<f64>, Seat)> {
        while self.taken < self.ends.len() {
            let number = self.taken;
            self.taken += 1;
            let Run { gains, start, stream } = (self.run)(number);
            let robot = self.setting.robot_at(start);
            let horizon = now + u64::from(self.setting.samples());
            let disturbances = self.setting.experiment().disturbance.sequence(stream);
            let seat = Seat { run: number, gains, horizon, disturbances };
            if !self.note_end(&seat, &robot, now) {
                return Some((robot, seat));
            }
        }
        None
    }

    /// Whether the run of this seat ends now; if so, how and at what cost is noted.
    fn note_end(&mut self, seat: &Seat, robot: &Robot<f64>, now: u64) -> bool {
        let n = self.setting.samples() - (seat.horizon - now) as u32;
        let Some(outcome) = self.setting.outcome(&robot.error, n) else { return false };
        let cost = self.setting.cost_at(robot, &seat.gains, n, Some(outcome));
        self.ends[seat.run] = RunEnd { cost, outcome };
        true
    }
}

/// What a lane knows of the run that it is driving.
#[derive(Clone)]
struct Seat {
    /// The number of the run.
    run: usize,
    gains: Gains,
    /// The sample, counted from when the first robots set out, at which it reaches the horizon.
    horizon: u64,
    disturbances: DisturbanceSequence,
}

/// The robots that share a register.
#[derive(Clone)]
struct Team {
    robots: Robot<Lanes>,
    gains: Gains<Lanes>,
    extremes: Extremes,
    /// The robots at the beginning of the block.
    before: Robot<Lanes>,
    /// Those of the block, sample by sample.
    disturbances: [Velocity<Lanes>; BLOCK],
    /// None in an idle lane.
    seats: [Option<Seat>; LANES],
}

/// How far the robots of a team have been during a block, all as squares.
#[derive(Clone, Copy)]
struct Extremes {
    least_distance: Lanes,
    least_heading: Lanes,
    largest_heading: Lanes,
    largest_turn_rate: Lanes,
}

/// The same for one robot: what it must stay within to be driven beside others.
struct Bounds {
    least_distance: f64,
    least_heading: f64,
    largest_heading: f64,
    largest_turn_rate: f64,
}

impl Bounds {
    fn new(rules: &Rules) -> Self {
        // These squares are rounded; whoever fails drives alone, and there the comparison is exact.
        let (more, less) = (1.0 + 1e-15, 1.0 - 1e-15);
        // No square is as small as that of a tolerance that nobody can reach.
        let [least_distance, heading] = rules.arrival.unwrap_or([-1.0, 0.0]);
        // Room for the robot's turn and for that of the reference.
        let range = PI - 2.0 * SMALL_TURN;
        let turn_rate =
            if rules.reference_turns_far() { 0.0 } else { SMALL_TURN / rules.sample_time };
        Self {
            least_distance,
            least_heading: heading * heading * more,
            largest_heading: range * range,
            largest_turn_rate: turn_rate * turn_rate * less,
        }
    }
}

impl Team {
    fn idle() -> Self {
        let robots = Robot::at_rest(ErrorPosture::new(0.0, 0.0, 0.0)).splat();
        Self {
            robots,
            gains: Gains::new(0.0, 0.0, 0.0).splat(),
            extremes: Extremes::none(),
            before: robots,
            disturbances: [Velocity::ZERO.splat(); BLOCK],
            seats: [const { None }; LANES],
        }
    }

    /// Gives the idle lanes the next runs, while there are any.
    fn take_up(&mut self, runs: &mut Runs<impl Fn(usize) -> Run>, now: u64) {
        for index in 0..LANES {
            if self.seats[index].is_none()
                && let Some((robot, seat)) = runs.next(now)
            {
                self.robots.set(index, &robot);
                self.gains.set(index, &seat.gains);
                self.seats[index] = Some(seat);
            }
        }
    }

    #[inline(always)]
    fn set_out(&mut self) {
        self.before = self.robots;
        self.extremes = Extremes::none();
    }

    /// Draws the disturbances of a block.
    fn draw_disturbances(&mut self, samples: usize) {
        for (index, seat) in self.seats.iter_mut().enumerate() {
            let Some(seat) = seat else { continue };
            for velocity in &mut self.disturbances[..samples] {
                velocity.set(index, seat.disturbances.next().unwrap_or(Velocity::ZERO));
            }
        }
    }

    /// A mask of the robots that were where all together can be driven, and could not arrive.
    ///
    /// A sum of squares is finite only if all of them are, so that these robots have not diverged either.
    #[inline(always)]
    fn stayed_within(&self, bounds: &Bounds) -> Lanes {
        let Extremes { least_distance, least_heading, largest_heading, largest_turn_rate } =
            self.extremes;
        let away =
            least_distance.over(bounds.least_distance) | least_heading.over(bounds.least_heading);
        away & largest_heading.under(bounds.largest_heading)
            & largest_turn_rate.under(bounds.largest_turn_rate)
            & self.robots.path.under(f64::INFINITY)
    }

    /// Drives each robot that is not in the mask through the block again, alone. Returns whether a run has ended.
    #[cold]
    fn drive_again(
        &mut self,
        usual: Lanes,
        runs: &mut Runs<impl Fn(usize) -> Run>,
        now: u64,
        samples: usize,
    ) -> bool {
        let rules = runs.setting.rules();
        let noisy = runs.setting.experiment().disturbance.kind != DisturbanceKind::None;
        let mut vacant = false;
        for index in (0..LANES).filter(|index| !usual.is_set(*index)) {
            let Some(seat) = &self.seats[index] else { continue };
            let mut robot = self.before.lane(index);
            let block = self.disturbances[..samples].iter().zip(now - samples as u64..);
            let ended = block.into_iter().any(|(disturbance, now)| {
                let ended = runs.note_end(seat, &robot, now);
                let disturbance = noisy.then(|| disturbance.lane(index));
                robot = rules.step(&robot, &seat.gains, disturbance).next;
                ended
            });
            self.robots.set(index, &robot);
            self.seats[index].take_if(|_| ended);
            vacant |= ended;
        }
        vacant
    }

    /// Ends the runs that reach the horizon now.
    fn end_at_horizon(&mut self, runs: &mut Runs<impl Fn(usize) -> Run>, now: u64) {
        for (index, seat) in self.seats.iter_mut().enumerate() {
            let robot = self.robots.lane(index);
            seat.take_if(|seat| seat.horizon == now && runs.note_end(seat, &robot, now));
        }
    }
}

impl Extremes {
    #[inline(always)]
    fn none() -> Self {
        Self {
            least_distance: Lanes::splat(f64::INFINITY),
            least_heading: Lanes::splat(f64::INFINITY),
            largest_heading: Lanes::splat(0.0),
            largest_turn_rate: Lanes::splat(0.0),
        }
    }
}

/// Each sample in two halves, each for all teams in turn: the processor then works at several teams at once.
#[inline(always)]
fn drive_teams(rules: &Rules, teams: &mut [Team], samples: usize, noisy: bool, turns_far: bool) {
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
            let (next, arc) = rules.moved(robots, noisy.then(|| disturbances[sample]));
            if turns_far {
                let rate = arc.turn_rate();
                extremes.largest_turn_rate = extremes.largest_turn_rate.at_least(rate * rate);
            }
            *robots = next;
        }
    }
}
