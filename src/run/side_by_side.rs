//! The numbers of one robot among those that share a register.

use super::rules::Robot;
use crate::number::Lanes;
use crate::robot::{Gains, Velocity};

impl Gains<Lanes> {
    pub(super) fn set(&mut self, index: usize, k: &Gains) {
        let Self { x, y, theta } = self;
        for (lanes, value) in [(x, k.x), (y, k.y), (theta, k.theta)] {
            lanes.set(index, value);
        }
    }
}

impl Velocity<Lanes> {
    pub(super) fn set(&mut self, index: usize, velocity: Velocity) {
        self.linear.set(index, velocity.linear);
        self.angular.set(index, velocity.angular);
    }
}

impl Robot<Lanes> {
    pub(super) fn set(&mut self, index: usize, robot: &Robot<f64>) {
        let Self { error, velocity, path, energy } = self;
        for (lanes, value) in [
            (&mut error.x, robot.error.x),
            (&mut error.y, robot.error.y),
            (&mut error.theta, robot.error.theta),
            (&mut error.cos, robot.error.cos),
            (&mut error.sin, robot.error.sin),
            (path, robot.path),
        ] {
            lanes.set(index, value);
        }
        velocity.set(index, robot.velocity);
        energy.set(index, robot.energy);
    }
}
