//! The numbers of one robot among those that share a register.

use super::rules::Robot;
use crate::number::Lanes;
use crate::robot::{ErrorPosture, Gains, Velocity};

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
        let Self { linear, angular } = self;
        linear.set(index, velocity.linear);
        angular.set(index, velocity.angular);
    }
}

impl ErrorPosture<Lanes> {
    fn set(&mut self, index: usize, error: &ErrorPosture) {
        let Self { x, y, theta, cos, sin } = self;
        for (lanes, value) in
            [(x, error.x), (y, error.y), (theta, error.theta), (cos, error.cos), (sin, error.sin)]
        {
            lanes.set(index, value);
        }
    }
}

impl Robot<Lanes> {
    pub(super) fn set(&mut self, index: usize, robot: &Robot<f64>) {
        let Self { error, velocity, path, energy } = self;
        error.set(index, &robot.error);
        path.set(index, robot.path);
        velocity.set(index, robot.velocity);
        energy.set(index, robot.energy);
    }
}
