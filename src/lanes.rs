//! Many runs at once, each robot in a lane of its own, with the bits that it would have alone.

use core::array::from_fn;
use core::f64::consts::PI;
use core::ops::{Add, Div, Mul, Neg, Sub};

use wide::f64x2;

use crate::control::Gains;
use crate::cost::Cost;
use crate::disturbance::{DisturbanceKind, DisturbanceSequence};
use crate::episode::{Outcome, Robot, Rules, Setting, Step};
use crate::posture::{ErrorPosture, Posture, Velocity};
use crate::real::{Real, SMALL_ANGLE, sinc_cos_series};

/// Registers that are computed with side by side, so that the processor need not wait for one division.
const REGISTERS: usize = 4;

/// How many robots are driven side by side: two in each register.
const LANES: usize = 2 * REGISTERS;

/// A number of each of the robots that are driven side by side, or a mask.
#[derive(Clone, Copy)]
struct Lanes([f64x2; REGISTERS]);

impl Lanes {
    #[inline(always)]
    fn map(self, f: impl Fn(f64x2) -> f64x2) -> Self {
        Self(self.0.map(f))
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64x2, f64x2) -> f64x2) -> Self {
        Self(from_fn(|i| f(self.0[i], other.0[i])))
    }

    fn lane(&self, index: usize) -> f64 {
        self.0[index / 2].as_array()[index % 2]
    }

    fn set(&mut self, index: usize, value: f64) {
        self.0[index / 2].as_mut_array()[index % 2] = value;
    }

    #[inline(always)]
    fn under(self, bound: f64) -> Self {
        self.map(|a| a.simd_lt(f64x2::splat(bound)))
    }

    #[inline(always)]
    fn at_most_mask(self, bound: f64) -> Self {
        self.map(|a| a.simd_le(f64x2::splat(bound)))
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.zip(other, |a, b| a & b)
    }

    #[inline(always)]
    fn any(self) -> bool {
        self.0.into_iter().reduce(|a, b| a | b).is_some_and(f64x2::any)
    }

    #[inline(always)]
    fn all(self) -> bool {
        self.0.into_iter().reduce(|a, b| a & b).is_some_and(f64x2::all)
    }
}

macro_rules! lanewise {
    ($($operator:ident $function:ident),*) => {$(
        impl $operator for Lanes {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                self.zip(other, f64x2::$function)
            }
        }
    )*};
}

lanewise!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Lanes {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(f64x2::neg)
    }
}

impl Real for Lanes {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([f64x2::splat(value); REGISTERS])
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f64x2::abs)
    }

    #[inline(always)]
    fn away_from_zero(self, least: f64) -> Self {
        let sign = f64x2::splat(-0.0);
        let magnitude = self.map(|a| a & !sign).at_least(Self::splat(least));
        magnitude.zip(self, |a, b| a | (b & sign))
    }

    // x86 and WebAssembly differ in which operand they give back when one is NaN.
    #[inline(always)]
    fn at_most(self, bound: Self) -> Self {
        self.zip(bound, |a, bound| {
            if cfg!(target_arch = "wasm32") { a.fast_min(bound) } else { bound.fast_min(a) }
        })
    }

    #[inline(always)]
    fn at_least(self, bound: Self) -> Self {
        self.zip(bound, |a, bound| {
            if cfg!(target_arch = "wasm32") { a.fast_max(bound) } else { bound.fast_max(a) }
        })
    }

    #[inline(always)]
    fn sinc_cos(self) -> (Self, Self) {
        sinc_cos_series(self)
    }

    #[inline(always)]
    fn kept_in_range(self, _h: Self, _cos: Self, _sin: Self) -> Self {
        self
    }
}

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
        Convoy::new(self, count, run).drive()
    }
}

/// Many runs. A lane whose robot has ended its run takes up the next.
struct Convoy<'a, F> {
    setting: &'a Setting,
    run: F,
    ends: Vec<RunEnd>,
    /// How many runs were taken up.
    taken: usize,
    team: Team,
    /// What only one robot has; none in an idle lane.
    lanes: [Option<Lane>; LANES],
    /// Samples since the convoy set out.
    now: u64,
}

/// The robots that are driven side by side, and their gains.
#[derive(Clone, Copy)]
struct Team {
    robots: Robot<Lanes>,
    gains: Gains<Lanes>,
    /// A mask of the lanes that are not idle.
    busy: Lanes,
}

struct Lane {
    /// The number of its run.
    run: usize,
    gains: Gains,
    /// The sample of the convoy at which it set out.
    since: u64,
    disturbances: DisturbanceSequence,
}

impl<'a, F: Fn(usize) -> Run> Convoy<'a, F> {
    fn new(setting: &'a Setting, count: usize, run: F) -> Self {
        let team = Team {
            robots: Robot::at_rest(ErrorPosture::new(0.0, 0.0, 0.0)).splat(),
            gains: Gains::new(0.0, 0.0, 0.0).splat(),
            busy: Lanes::splat(0.0),
        };
        let ends = vec![RunEnd { cost: Cost::default(), outcome: Outcome::Horizon }; count];
        Self { setting, run, ends, taken: 0, team, lanes: [const { None }; LANES], now: 0 }
    }

    fn drive(mut self) -> Vec<RunEnd> {
        (0..LANES).for_each(|index| self.take_next(index));
        while let Some(next_horizon) = self.next_horizon() {
            self.advance(next_horizon);
            (0..LANES).for_each(|index| self.finish(index));
        }
        self.ends
    }

    /// The sample of the convoy at which the next robot reaches the horizon; none if no robot drives.
    fn next_horizon(&self) -> Option<u64> {
        let samples = u64::from(self.setting.samples());
        self.lanes.iter().flatten().map(|lane| lane.since + samples).min()
    }

    /// Drives all robots until one has ended its run.
    fn advance(&mut self, next_horizon: u64) {
        // Copies, so that the compiler need not read them again for every sample.
        let (rules, mut team, mut now) = (self.setting.rules(), self.team, self.now);
        let noisy = self.setting.experiment().disturbance.kind != DisturbanceKind::None;
        let mut ended = false;
        while now < next_horizon && !ended {
            ended = team.step(&rules, noisy.then(|| disturbance(&mut self.lanes)));
            now += 1;
        }
        (self.team, self.now) = (team, now);
    }

    /// Notes the end of a robot's run, if it has ended, and lets its lane take up the next.
    fn finish(&mut self, index: usize) {
        let Some(lane) = &self.lanes[index] else { return };
        let robot = self.team.robots.lane(index);
        let n = (self.now - lane.since) as u32;
        let (run, gains) = (lane.run, lane.gains);
        if self.note_end(run, &robot, &gains, n) {
            self.take_next(index);
        }
    }

    fn take_next(&mut self, index: usize) {
        self.lanes[index] = None;
        self.team.busy.set(index, 0.0);
        while self.taken < self.ends.len() {
            let number = self.taken;
            self.taken += 1;
            let Run { gains, start, stream } = (self.run)(number);
            let robot = self.setting.robot_at(start);
            if self.note_end(number, &robot, &gains, 0) {
                continue;
            }
            let disturbances = self.setting.experiment().disturbance.sequence(stream);
            self.team.seat(index, &robot, &gains);
            self.team.busy.set(index, f64::from_bits(u64::MAX));
            self.lanes[index] = Some(Lane { run: number, gains, since: self.now, disturbances });
            return;
        }
    }

    /// Whether the run ends with sample `n`; if so, how and at what cost is noted.
    fn note_end(&mut self, run: usize, robot: &Robot<f64>, gains: &Gains, n: u32) -> bool {
        let Some(outcome) = self.setting.outcome(&robot.error, n) else { return false };
        let cost = self.setting.cost_at(robot, gains, n, Some(outcome));
        self.ends[run] = RunEnd { cost, outcome };
        true
    }
}

#[cold]
fn disturbance(lanes: &mut [Option<Lane>; LANES]) -> Velocity<Lanes> {
    let mut velocity = Velocity::ZERO.splat::<Lanes>();
    for (index, lane) in lanes.iter_mut().enumerate() {
        if let Some(delta) = lane.as_mut().and_then(|lane| lane.disturbances.next()) {
            velocity.linear.set(index, delta.linear);
            velocity.angular.set(index, delta.angular);
        }
    }
    velocity
}

impl Team {
    /// One sample of all robots. Returns whether one has arrived or diverged.
    #[inline(always)]
    fn step(&mut self, rules: &Rules, disturbance: Option<Velocity<Lanes>>) -> bool {
        let Step { arc, next, .. } = rules.step(&self.robots, &self.gains, disturbance);
        let heading = next.error.theta.abs();
        let usual = arc.half_turn().abs().under(SMALL_ANGLE);
        let usual = usual.and(heading.under(PI)).and(next.deviation.under(f64::INFINITY));
        if !usual.all() || rules.reference_turns_far() {
            return self.step_one_by_one(rules, disturbance);
        }
        self.robots = next;
        let Some([square, tolerance]) = rules.arrival else { return false };
        let near = next.error.squared_distance().at_most_mask(square);
        near.and(heading.at_most_mask(tolerance)).and(self.busy).any()
    }

    /// The same where the formulas for all together do not hold: after a large turn, or out of range.
    #[cold]
    fn step_one_by_one(&mut self, rules: &Rules, disturbance: Option<Velocity<Lanes>>) -> bool {
        let mut ended = false;
        for index in 0..LANES {
            let gains = self.gains.lane(index);
            let disturbance = disturbance.map(|delta| delta.lane(index));
            let next = rules.step(&self.robots.lane(index), &gains, disturbance).next;
            self.seat(index, &next, &gains);
            ended |= rules.end(&next.error).is_some() && self.busy.lane(index) != 0.0;
        }
        ended
    }

    /// Puts a robot into a lane.
    fn seat(&mut self, index: usize, robot: &Robot<f64>, k: &Gains) {
        let Self { robots: Robot { error, deviation, velocity, path, energy }, gains, .. } = self;
        for (lanes, value) in [
            (&mut error.x, robot.error.x),
            (&mut error.y, robot.error.y),
            (&mut error.theta, robot.error.theta),
            (&mut error.cos, robot.error.cos),
            (&mut error.sin, robot.error.sin),
            (&mut velocity.linear, robot.velocity.linear),
            (&mut velocity.angular, robot.velocity.angular),
            (deviation, robot.deviation),
            (path, robot.path),
            (&mut energy.linear, robot.energy.linear),
            (&mut energy.angular, robot.energy.angular),
            (&mut gains.x, k.x),
            (&mut gains.y, k.y),
            (&mut gains.theta, k.theta),
        ] {
            lanes.set(index, value);
        }
    }
}

impl Gains<Lanes> {
    fn lane(&self, index: usize) -> Gains {
        let [x, y, theta] = [self.x, self.y, self.theta].map(|k| k.lane(index));
        Gains { x, y, theta }
    }
}

impl Velocity<Lanes> {
    fn lane(&self, index: usize) -> Velocity {
        let [linear, angular] = [self.linear, self.angular].map(|q| q.lane(index));
        Velocity { linear, angular }
    }
}

impl Robot<Lanes> {
    fn lane(&self, index: usize) -> Robot<f64> {
        let e = &self.error;
        let [x, y, theta, cos, sin] = [e.x, e.y, e.theta, e.cos, e.sin].map(|a| a.lane(index));
        let [deviation, path] = [self.deviation, self.path].map(|a| a.lane(index));
        let [velocity, energy] = [self.velocity, self.energy].map(|q| q.lane(index));
        Robot { error: ErrorPosture { x, y, theta, cos, sin }, deviation, velocity, path, energy }
    }
}
