//! Many runs at once, each robot in a lane of its own, with the bits that it would have alone.

use wide::f64x8;

use crate::control::Gains;
use crate::cost::Cost;
use crate::disturbance::{DisturbanceKind, DisturbanceSequence};
use crate::episode::{Robot, Setting};
use crate::posture::{ErrorPosture, Velocity};
use crate::real::Real;

/// A number of each of the robots that are driven side by side.
type Lanes = f64x8;

/// How many there are.
const LANES: usize = 8;

impl Real for Lanes {
    #[inline]
    fn splat(value: f64) -> Self {
        Lanes::splat(value)
    }

    #[inline]
    fn abs(self) -> Self {
        Lanes::abs(self)
    }

    #[inline]
    fn copysign(self, sign: Self) -> Self {
        Lanes::abs(self) | (sign & Lanes::splat(-0.0))
    }

    // x86 and WebAssembly differ in which operand they give back when one is NaN.
    #[inline]
    fn at_most(self, bound: Self) -> Self {
        if cfg!(target_arch = "wasm32") { self.fast_min(bound) } else { bound.fast_min(self) }
    }

    #[inline]
    fn at_least(self, bound: Self) -> Self {
        if cfg!(target_arch = "wasm32") { self.fast_max(bound) } else { bound.fast_max(self) }
    }

    #[inline]
    fn lane(self, index: usize) -> f64 {
        self.as_array()[index]
    }

    #[inline]
    fn any_beyond(self, limit: f64) -> bool {
        Lanes::abs(self).simd_ge(Lanes::splat(limit)).to_bitmask() != 0
    }

    #[cold]
    fn replaced_beyond(self, angle: Self, limit: f64, exact: impl Fn(usize) -> f64) -> Self {
        let mut lanes = self.to_array();
        for (index, lane) in lanes.iter_mut().enumerate() {
            *lane = lane.replaced_beyond(angle.lane(index), limit, |_| exact(index));
        }
        Lanes::new(lanes)
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
        let busy = (0..LANES).filter(|index| self.lanes[*index].is_some());
        let busy = busy.fold(0, |bits, index| bits | 1 << index);
        let noisy = self.setting.experiment().disturbance.kind != DisturbanceKind::None;
        let (mut robots, mut now) = (self.robots, self.now);
        while now < next_horizon && self.ended(&robots.error) & busy == 0 {
            let disturbance = noisy.then(|| self.disturbance());
            robots = self.setting.step(&robots, &self.robots_gains, disturbance).next;
            now += 1;
        }
        (self.robots, self.now) = (robots, now);
    }

    /// One bit for each robot that has arrived or diverged; idle lanes may have one too.
    #[inline(always)]
    fn ended(&self, e: &ErrorPosture<Lanes>) -> u32 {
        let finite = e.squared_deviation().simd_lt(Lanes::splat(f64::INFINITY));
        let ended = match self.setting.arrival() {
            Some([square, heading]) => {
                let near = e.squared_distance().simd_le(Lanes::splat(square))
                    & Lanes::abs(e.theta).simd_le(Lanes::splat(heading));
                near | !finite
            }
            None => !finite,
        };
        ended.to_bitmask()
    }

    #[cold]
    fn disturbance(&mut self) -> Velocity<Lanes> {
        let mut velocity = Velocity::ZERO.splat();
        for (index, lane) in self.lanes.iter_mut().enumerate() {
            if let Some(delta) = lane.as_mut().and_then(|lane| lane.disturbances.next()) {
                set(&mut velocity.linear, index, delta.linear);
                set(&mut velocity.angular, index, delta.angular);
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
            set(&mut self.robots_gains.x, index, gains.x);
            set(&mut self.robots_gains.y, index, gains.y);
            set(&mut self.robots_gains.theta, index, gains.theta);
            let disturbances = self.setting.experiment().disturbance.sequence(start as u32);
            self.lanes[index] = Some(Lane { run, gains, since: self.now, disturbances });
            return;
        }
    }
}

fn set(lanes: &mut Lanes, index: usize, value: f64) {
    lanes.as_mut_array()[index] = value;
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
        set(lanes, index, value);
    }
}
