//! Many runs at once, each robot in a lane of its own, with the bits that it would have alone.

use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

use wide::f64x2;

use crate::control::Gains;
use crate::cost::Cost;
use crate::disturbance::{DisturbanceKind, DisturbanceSequence};
use crate::episode::{Robot, Setting};
use crate::posture::{ErrorPosture, Velocity};
use crate::real::Real;

/// SIMD registers side by side: enough that one division need not wait for the other.
const REGISTERS: usize = 4;

/// How many robots are driven side by side.
const LANES: usize = 2 * REGISTERS;

/// A number of each of the robots that are driven side by side.
#[derive(Clone, Copy)]
struct Lanes([f64x2; REGISTERS]);

impl Lanes {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64x2, f64x2) -> f64x2) -> Self {
        Self(from_fn(|i| f(self.0[i], other.0[i])))
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64x2) -> f64x2) -> Self {
        Self(self.0.map(f))
    }

    fn set(&mut self, index: usize, value: f64) {
        self.0[index / 2].as_mut_array()[index % 2] = value;
    }

    /// Whether any lane of a mask is set.
    #[inline(always)]
    fn any(self) -> bool {
        self.0.into_iter().reduce(|a, b| a | b).is_some_and(f64x2::any)
    }
}

impl Add for Lanes {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for Lanes {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl Div for Lanes {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, |a, b| a / b)
    }
}

impl Neg for Lanes {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
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
    fn copysign(self, sign: Self) -> Self {
        self.zip(sign, |a, sign| a.abs() | (sign & f64x2::splat(-0.0)))
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

    #[inline]
    fn lane(self, index: usize) -> f64 {
        self.0[index / 2].as_array()[index % 2]
    }

    #[inline(always)]
    fn any_beyond(self, limit: f64) -> bool {
        self.map(|a| a.abs().simd_ge(f64x2::splat(limit))).any()
    }

    #[cold]
    fn replaced_beyond(mut self, angle: Self, limit: f64, exact: impl Fn(usize) -> f64) -> Self {
        for index in 0..LANES {
            let replaced =
                self.lane(index).replaced_beyond(angle.lane(index), limit, |_| exact(index));
            self.set(index, replaced);
        }
        self
    }
}

impl Setting {
    /// J of each of these gains, in parts: the mean over all start postures.
    pub fn costs(&self, gains: &[Gains]) -> Vec<Cost> {
        let starts = self.starts();
        let costs = Convoy::new(self, gains).drive();
        costs.chunks_exact(starts).map(|costs| Cost::mean(costs.iter().copied())).collect()
    }

    /// J of these gains, in parts: the mean over all start postures.
    pub fn cost(&self, gains: &Gains) -> Cost {
        self.costs(core::slice::from_ref(gains))[0]
    }
}

/// All runs of some gains from all starts. A lane whose robot has ended its run takes up the next.
struct Convoy<'a> {
    setting: &'a Setting,
    gains: &'a [Gains],
    /// The cost of each run: of the first gains from all starts, of the second, and so on.
    costs: Vec<Cost>,
    /// How many runs were taken up.
    taken: usize,
    lanes: [Option<Lane>; LANES],
    robots: Robot<Lanes>,
    robots_gains: Gains<Lanes>,
    /// Samples since the convoy set out.
    now: u64,
}

/// What only one robot has.
struct Lane {
    run: usize,
    gains: Gains,
    /// The sample of the convoy at which it set out.
    since: u64,
    disturbances: DisturbanceSequence,
}

impl<'a> Convoy<'a> {
    fn new(setting: &'a Setting, gains: &'a [Gains]) -> Self {
        Self {
            setting,
            gains,
            costs: vec![Cost::default(); gains.len() * setting.starts()],
            taken: 0,
            lanes: [const { None }; LANES],
            robots: Robot::at_rest(ErrorPosture::new(0.0, 0.0, 0.0)).splat(),
            robots_gains: Gains::new(0.0, 0.0, 0.0).splat(),
            now: 0,
        }
    }

    fn drive(mut self) -> Vec<Cost> {
        for index in 0..LANES {
            self.take_next(index);
        }
        while let Some(next_horizon) = self.next_horizon() {
            self.advance(next_horizon);
            for index in 0..LANES {
                self.finish(index);
            }
        }
        self.costs
    }

    /// The sample of the convoy at which the next robot reaches the horizon; none if no robot drives.
    fn next_horizon(&self) -> Option<u64> {
        let samples = u64::from(self.setting.samples());
        self.lanes.iter().flatten().map(|lane| lane.since + samples).min()
    }

    /// Drives all robots until one has ended its run.
    fn advance(&mut self, next_horizon: u64) {
        let mut busy = Lanes::splat(0.0);
        for (index, lane) in self.lanes.iter().enumerate() {
            busy.set(index, if lane.is_some() { f64::from_bits(u64::MAX) } else { 0.0 });
        }
        let noisy = self.setting.experiment().disturbance.kind != DisturbanceKind::None;
        let (mut robots, mut now) = (self.robots, self.now);
        while now < next_horizon && !self.ended(&robots.error).zip(busy, |a, b| a & b).any() {
            let disturbance = noisy.then(|| self.disturbance());
            robots = self.setting.step(&robots, &self.robots_gains, disturbance).next;
            now += 1;
        }
        (self.robots, self.now) = (robots, now);
    }

    /// A mask of the robots that have arrived or diverged; idle lanes may be among them.
    #[inline(always)]
    fn ended(&self, e: &ErrorPosture<Lanes>) -> Lanes {
        let finite = |a: f64x2| a.simd_lt(f64x2::splat(f64::INFINITY));
        let diverged = e.squared_deviation().map(|a| !finite(a));
        let Some([square, heading]) = self.setting.arrival() else { return diverged };
        let near = |a: f64x2| a.simd_le(f64x2::splat(square));
        let aligned = |a: f64x2| a.abs().simd_le(f64x2::splat(heading));
        let arrived =
            e.squared_distance().zip(e.theta, |place, theta| near(place) & aligned(theta));
        arrived.zip(diverged, |a, b| a | b)
    }

    #[cold]
    fn disturbance(&mut self) -> Velocity<Lanes> {
        let mut velocity = Velocity::ZERO.splat::<Lanes>();
        for (index, lane) in self.lanes.iter_mut().enumerate() {
            if let Some(delta) = lane.as_mut().and_then(|lane| lane.disturbances.next()) {
                velocity.linear.set(index, delta.linear);
                velocity.angular.set(index, delta.angular);
            }
        }
        velocity
    }

    /// Notes the cost of a robot that has ended its run, and lets its lane take up the next run.
    fn finish(&mut self, index: usize) {
        let Some(lane) = &self.lanes[index] else { return };
        let robot = robot_in(&self.robots, index);
        let n = (self.now - lane.since) as u32;
        let outcome = self.setting.outcome(&robot.error, n);
        if outcome.is_some() {
            self.costs[lane.run] = self.setting.cost_at(&robot, &lane.gains, n, outcome);
            self.take_next(index);
        }
    }

    fn take_next(&mut self, index: usize) {
        self.lanes[index] = None;
        let starts = self.setting.starts();
        while self.taken < self.costs.len() {
            let run = self.taken;
            self.taken += 1;
            let (gains, start) = (self.gains[run / starts], run % starts);
            let robot = self.setting.robot_at(start);
            if let Some(outcome) = self.setting.outcome(&robot.error, 0) {
                self.costs[run] = self.setting.cost_at(&robot, &gains, 0, Some(outcome));
                continue;
            }
            put(&mut self.robots, index, &robot);
            self.robots_gains.x.set(index, gains.x);
            self.robots_gains.y.set(index, gains.y);
            self.robots_gains.theta.set(index, gains.theta);
            let disturbances = self.setting.experiment().disturbance.sequence(start as u32);
            self.lanes[index] = Some(Lane { run, gains, since: self.now, disturbances });
            return;
        }
    }
}

fn robot_in(robots: &Robot<Lanes>, index: usize) -> Robot<f64> {
    let Robot { error, velocity, path, energy } = robots;
    Robot {
        error: ErrorPosture {
            x: error.x.lane(index),
            y: error.y.lane(index),
            theta: error.theta.lane(index),
            cos: error.cos.lane(index),
            sin: error.sin.lane(index),
        },
        velocity: Velocity {
            linear: velocity.linear.lane(index),
            angular: velocity.angular.lane(index),
        },
        path: path.lane(index),
        energy: energy.lane(index),
    }
}

fn put(robots: &mut Robot<Lanes>, index: usize, robot: &Robot<f64>) {
    let Robot { error, velocity, path, energy } = robots;
    for (lanes, value) in [
        (&mut error.x, robot.error.x),
        (&mut error.y, robot.error.y),
        (&mut error.theta, robot.error.theta),
        (&mut error.cos, robot.error.cos),
        (&mut error.sin, robot.error.sin),
        (&mut velocity.linear, robot.velocity.linear),
        (&mut velocity.angular, robot.velocity.angular),
        (path, robot.path),
        (energy, robot.energy),
    ] {
        lanes.set(index, value);
    }
}
