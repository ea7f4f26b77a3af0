//! The robots that share a register: driven side by side, and again alone where the formulas for several do not hold.

use core::f64::consts::PI;

use super::rules::{Robot, Rules};
use super::runs::{Runs, Seat};
use crate::number::{LANES, Lanes, Real, SMALL_TURN};
use crate::robot::{DisturbanceKind, ErrorPosture, Gains, Velocity};

/// Samples in a block.
pub(super) const BLOCK: usize = 16;

/// The robots that share a register.
#[derive(Clone)]
pub(super) struct Team {
    pub(super) robots: Robot<Lanes>,
    pub(super) gains: Gains<Lanes>,
    pub(super) extremes: Extremes,
    /// The robots at the beginning of the block.
    before: Robot<Lanes>,
    /// Those of the block, sample by sample.
    pub(super) disturbances: [Velocity<Lanes>; BLOCK],
    /// None in an idle lane.
    pub(super) seats: [Option<Seat>; LANES],
}

/// How far the robots of a team have been during a block, all as squares.
#[derive(Clone, Copy)]
pub(super) struct Extremes {
    pub(super) least_distance: Lanes,
    pub(super) least_heading: Lanes,
    pub(super) largest_heading: Lanes,
    pub(super) largest_turn_rate: Lanes,
}

/// The same for one robot: what it must stay within to be driven beside others.
pub(super) struct Bounds {
    least_distance: f64,
    least_heading: f64,
    largest_heading: f64,
    largest_turn_rate: f64,
}

impl Bounds {
    pub(super) fn new(rules: &Rules) -> Self {
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
    pub(super) fn idle() -> Self {
        let robots = Robot::at_rest(ErrorPosture::new(0.0, 0.0, 0.0)).map(Lanes::splat);
        Self {
            robots,
            gains: Gains::new(0.0, 0.0, 0.0).splat(),
            extremes: Extremes::none(),
            before: robots,
            disturbances: [Velocity::ZERO.map(Lanes::splat); BLOCK],
            seats: [const { None }; LANES],
        }
    }

    /// Gives the idle lanes the next runs, while there are any.
    pub(super) fn take_up(&mut self, runs: &mut Runs<'_>, now: u64) {
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
    pub(super) fn set_out(&mut self) {
        self.before = self.robots;
        self.extremes = Extremes::none();
    }

    /// Draws the disturbances of a block.
    pub(super) fn draw_disturbances(&mut self, samples: usize) {
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
    pub(super) fn stayed_within(&self, bounds: &Bounds) -> Lanes {
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
    pub(super) fn drive_again(
        &mut self,
        usual: Lanes,
        runs: &mut Runs<'_>,
        now: u64,
        samples: usize,
    ) -> bool {
        let rules = runs.setting.rules();
        let noisy = runs.setting.experiment().disturbance.kind != DisturbanceKind::None;
        let mut vacant = false;
        for index in (0..LANES).filter(|index| !usual.is_set(*index)) {
            let Some(seat) = &self.seats[index] else { continue };
            let mut robot = self.before.map(|lanes| lanes.lane(index));
            let block = self.disturbances[..samples].iter().zip(now - samples as u64..);
            let ended = block.into_iter().any(|(disturbance, now)| {
                let ended = runs.note_end(seat, &robot, now);
                let disturbance = noisy.then(|| disturbance.map(|lanes| lanes.lane(index)));
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
    pub(super) fn end_at_horizon(&mut self, runs: &mut Runs<'_>, now: u64) {
        for (index, seat) in self.seats.iter_mut().enumerate() {
            let robot = self.robots.map(|lanes| lanes.lane(index));
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
