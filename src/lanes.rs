//! Many runs at once, each robot in a lane of its own, with the bits that it would have alone.

use core::f64::consts::PI;

use wide::f64x2;

use crate::control::Gains;
use crate::cost::Cost;
use crate::disturbance::{DisturbanceKind, DisturbanceSequence};
use crate::episode::{Robot, Rules, Setting, Step};
use crate::posture::{ErrorPosture, Velocity};
use crate::real::{Real, SMALL_ANGLE, sinc_cos_series};

/// Two robots share a register.
const PAIR: usize = 2;

/// Pairs that are driven in turn: while one waits for a division the processor goes on with the others.
const PAIRS: usize = 4;

impl Real for f64x2 {
    #[inline]
    fn splat(value: f64) -> Self {
        f64x2::splat(value)
    }

    #[inline]
    fn abs(self) -> Self {
        f64x2::abs(self)
    }

    #[inline]
    fn away_from_zero(self, least: f64) -> Self {
        let sign = f64x2::splat(-0.0);
        (self & !sign).at_least(f64x2::splat(least)) | (self & sign)
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
    fn sinc_cos(self) -> (Self, Self) {
        sinc_cos_series(self)
    }

    #[inline]
    fn kept_in_range(self, _h: Self, _cos: Self, _sin: Self) -> Self {
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
    pairs: [Pair; PAIRS],
    /// What only one robot has; none in an idle lane.
    lanes: [[Option<Lane>; PAIR]; PAIRS],
    /// Samples since the convoy set out.
    now: u64,
}

/// Two robots and their gains.
#[derive(Clone, Copy)]
struct Pair {
    robots: Robot<f64x2>,
    gains: Gains<f64x2>,
    /// A mask of the lanes that are not idle.
    busy: f64x2,
}

struct Lane {
    run: usize,
    gains: Gains,
    /// The sample of the convoy at which it set out.
    since: u64,
    disturbances: DisturbanceSequence,
}

impl<'a> Convoy<'a> {
    fn new(setting: &'a Setting, gains: &'a [Gains]) -> Self {
        let idle = Pair {
            robots: Robot::at_rest(ErrorPosture::new(0.0, 0.0, 0.0)).splat(),
            gains: Gains::new(0.0, 0.0, 0.0).splat(),
            busy: f64x2::splat(0.0),
        };
        Self {
            setting,
            gains,
            costs: vec![Cost::default(); gains.len() * setting.starts()],
            taken: 0,
            pairs: [idle; PAIRS],
            lanes: [const { [const { None }; PAIR] }; PAIRS],
            now: 0,
        }
    }

    fn drive(mut self) -> Vec<Cost> {
        let places = || (0..PAIRS).flat_map(|pair| (0..PAIR).map(move |index| (pair, index)));
        places().for_each(|(pair, index)| self.take_next(pair, index));
        while let Some(next_horizon) = self.next_horizon() {
            self.advance(next_horizon);
            places().for_each(|(pair, index)| self.finish(pair, index));
        }
        self.costs
    }

    /// The sample of the convoy at which the next robot reaches the horizon; none if no robot drives.
    fn next_horizon(&self) -> Option<u64> {
        let samples = u64::from(self.setting.samples());
        self.lanes.iter().flatten().flatten().map(|lane| lane.since + samples).min()
    }

    /// Drives all robots until one has ended its run.
    fn advance(&mut self, next_horizon: u64) {
        // Copies, so that the compiler need not read them again for every sample.
        let (rules, mut pairs, mut now) = (self.setting.rules(), self.pairs, self.now);
        let noisy = self.setting.experiment().disturbance.kind != DisturbanceKind::None;
        let mut ended = false;
        while now < next_horizon && !ended {
            let mut ended_robots = f64x2::splat(0.0);
            for (pair, lanes) in pairs.iter_mut().zip(&mut self.lanes) {
                ended_robots |= pair.step(&rules, noisy.then(|| disturbance(lanes)));
            }
            ended = ended_robots.any();
            now += 1;
        }
        (self.pairs, self.now) = (pairs, now);
    }

    /// Notes the cost of a robot that has ended its run, and lets its lane take up the next run.
    fn finish(&mut self, pair: usize, index: usize) {
        let Some(lane) = &self.lanes[pair][index] else { return };
        let robot = self.pairs[pair].robots.lane(index);
        let n = (self.now - lane.since) as u32;
        let outcome = self.setting.outcome(&robot.error, n);
        if outcome.is_some() {
            self.costs[lane.run] = self.setting.cost_at(&robot, &lane.gains, n, outcome);
            self.take_next(pair, index);
        }
    }

    fn take_next(&mut self, pair: usize, index: usize) {
        self.lanes[pair][index] = None;
        let starts = self.setting.starts();
        while self.taken < self.costs.len() {
            let run = self.taken;
            self.taken += 1;
            let (gains, start) = (self.gains[run / starts], run % starts);
            let robot = self.setting.robot_at(start);
            let outcome = self.setting.outcome(&robot.error, 0);
            if outcome.is_some() {
                self.costs[run] = self.setting.cost_at(&robot, &gains, 0, outcome);
                continue;
            }
            let disturbances = self.setting.experiment().disturbance.sequence(start as u32);
            self.pairs[pair].seat(index, &robot, &gains);
            self.pairs[pair].busy.as_mut_array()[index] = f64::from_bits(u64::MAX);
            self.lanes[pair][index] = Some(Lane { run, gains, since: self.now, disturbances });
            return;
        }
        self.pairs[pair].busy.as_mut_array()[index] = 0.0;
    }
}

#[cold]
fn disturbance(lanes: &mut [Option<Lane>; PAIR]) -> Velocity<f64x2> {
    let mut of = |index: usize| lanes[index].as_mut().and_then(|lane| lane.disturbances.next());
    let [a, b] = [of(0), of(1)].map(|delta| delta.unwrap_or(Velocity::ZERO));
    Velocity {
        linear: f64x2::new([a.linear, b.linear]),
        angular: f64x2::new([a.angular, b.angular]),
    }
}

impl Pair {
    /// One sample of both robots. Returns a mask of those that have arrived or diverged.
    #[inline(always)]
    fn step(&mut self, rules: &Rules, disturbance: Option<Velocity<f64x2>>) -> f64x2 {
        let Step { arc, next, .. } = rules.step(&self.robots, &self.gains, disturbance);
        let heading = next.error.theta.abs();
        let usual = arc.half_turn().abs().simd_lt(f64x2::splat(SMALL_ANGLE))
            & heading.simd_lt(f64x2::splat(PI))
            & next.deviation.simd_lt(f64x2::splat(f64::INFINITY));
        if !usual.all() || rules.reference_turns_far() {
            return self.step_one_by_one(rules, disturbance);
        }
        self.robots = next;
        let Some([square, tolerance]) = rules.arrival else { return f64x2::splat(0.0) };
        let near = next.error.squared_distance().simd_le(f64x2::splat(square));
        near & heading.simd_le(f64x2::splat(tolerance)) & self.busy
    }

    /// The same where the formulas for both together do not hold: after a large turn, or out of range.
    #[cold]
    fn step_one_by_one(&mut self, rules: &Rules, disturbance: Option<Velocity<f64x2>>) -> f64x2 {
        let mut ended = self.busy;
        for index in 0..PAIR {
            let gains = self.gains.lane(index);
            let disturbance = disturbance.map(|delta| delta.lane(index));
            let next = rules.step(&self.robots.lane(index), &gains, disturbance).next;
            self.seat(index, &next, &gains);
            if rules.end(&next.error).is_none() {
                ended.as_mut_array()[index] = 0.0;
            }
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
            lanes.as_mut_array()[index] = value;
        }
    }
}

impl Gains<f64x2> {
    fn lane(&self, index: usize) -> Gains {
        let [x, y, theta] = [self.x, self.y, self.theta].map(|k| k.as_array()[index]);
        Gains { x, y, theta }
    }
}

impl Velocity<f64x2> {
    fn lane(&self, index: usize) -> Velocity {
        let [linear, angular] = [self.linear, self.angular].map(|q| q.as_array()[index]);
        Velocity { linear, angular }
    }
}

impl Robot<f64x2> {
    fn lane(&self, index: usize) -> Robot<f64> {
        let e = &self.error;
        let [x, y, theta, cos, sin] =
            [e.x, e.y, e.theta, e.cos, e.sin].map(|a| a.as_array()[index]);
        let [deviation, path] = [self.deviation, self.path].map(|a| a.as_array()[index]);
        let [velocity, energy] = [self.velocity, self.energy].map(|q| q.lane(index));
        Robot { error: ErrorPosture { x, y, theta, cos, sin }, deviation, velocity, path, energy }
    }
}
