//! What can be called, by name.

use super::value::{Bytes, Given, Value};
use crate::robot::Gains;
use crate::run::{Experiment, PAPER_RESULTS, Preset, Setting};
use crate::schema::{Allowed, Column, Columns, Input, InvalidInput, Place, Plain, Source, shown};
use crate::study::{self, Circle, Evolution, GridOfRobot, Landscape, PartOfGrid, Trials};

type Result<T> = core::result::Result<T, InvalidInput>;

/// What was begun, and is asked since.
#[derive(Debug, Default)]
pub(super) enum Begun {
    /// Nothing.
    #[default]
    Nothing,
    /// An experiment that is driven often.
    Task(Setting),
    /// A run of evolution.
    Evolution(Evolution),
}

impl Begun {
    /// The answer to a list of a call's name and what is given to it, in bytes.
    pub(super) fn answer(&mut self, asked: &[u8]) -> Result<Vec<u8>> {
        let Some(Value::List(asked)) = Value::of(asked) else { panic!("what is asked is no list") };
        let Some((Value::Text(name), given)) = asked.split_first() else {
            panic!("a call has a name")
        };
        let call = CALLS.iter().find(|(known, _)| known == name);
        let Some((_, call)) = call else { panic!("there is no call {name}") };
        call(self, &Arguments(given))
    }

    fn setting(&self) -> &Setting {
        match self {
            Self::Nothing => panic!("no experiment was begun"),
            Self::Task(setting) => setting,
            Self::Evolution(evolution) => evolution.setting(),
        }
    }

    fn evolution(&mut self) -> &mut Evolution {
        match self {
            Self::Evolution(evolution) => evolution,
            _ => panic!("no evolution was begun"),
        }
    }
}

/// What is given to a call.
struct Arguments<'a>(&'a [Value]);

impl Arguments<'_> {
    fn at(&self, index: usize) -> Given<'_> {
        Given(self.0.get(index))
    }

    /// The given experiment, completed with the fields of the usual one.
    fn setting(&self) -> Result<Setting> {
        let mut experiment = Preset::VelocityLimits.experiment();
        experiment.read(&self.at(0))?;
        Setting::new(experiment)
    }

    fn number(&self, index: usize, name: &str) -> Result<f64> {
        let mut number = 0.0;
        number.read(&self.at(index), Place::Named(name), &Allowed::ANY)?;
        Ok(number)
    }

    /// The index of a start posture.
    fn start(&self, index: usize, setting: &Setting) -> Result<u32> {
        let start = self.number(index, "start")?;
        setting.starts().check("start", start)?;
        Ok(start as u32)
    }

    /// The number of a generation; the newest if it is null.
    fn generation(&self, evolution: &Evolution) -> Result<u32> {
        let newest = evolution.generation();
        if self.0.first() == Some(&Value::Null) {
            return Ok(newest);
        }
        let number = self.number(0, "generation")?;
        if number.fract() == 0.0 && (0.0..=f64::from(newest)).contains(&number) {
            return Ok(number as u32);
        }
        Err(evolution.refused(shown(number)))
    }
}

fn told(value: &impl Plain) -> Result<Vec<u8>> {
    Ok(value.write(&Bytes))
}

type Call = fn(&mut Begun, &Arguments<'_>) -> Result<Vec<u8>>;

const CALLS: &[(&str, Call)] = &[
    // Of nothing.
    ("experiment", |_, given| {
        let mut experiment = match given.0 {
            [Value::Text(name), ..] => Preset::find(name)?.experiment(),
            _ => given.setting()?.experiment().clone(),
        };
        if given.at(1).is_given() {
            experiment.read(&given.at(1))?;
        }
        told(Setting::new(experiment)?.experiment())
    }),
    ("fields", |_, _| told(&Experiment::fields().numbers)),
    ("word_fields", |_, _| told(&Experiment::fields().words)),
    ("paper", |_, _| told(&PAPER_RESULTS)),
    ("starts_on_circle", |_, given| told(&Circle::read(&given.at(0))?.starts()?)),
    ("starts_on_grid", |_, given| {
        let PartOfGrid { grid, part } = PartOfGrid::read(&given.at(0))?;
        told(&grid.postures(part)?)
    }),
    // What begins.
    ("begin_task", |begun, given| {
        let setting = given.setting()?;
        let whole = told(setting.experiment());
        *begun = Begun::Task(setting);
        whole
    }),
    ("begin_evolution", |begun, given| {
        let setting = given.setting()?;
        let whole = told(setting.experiment());
        *begun = Begun::Evolution(Evolution::new(setting));
        whole
    }),
    // Of an experiment.
    ("evaluate", |begun, given| {
        told(&Column(begun.setting().evaluate(&Gains::read_all(&given.at(0))?)?))
    }),
    ("simulate", |begun, given| {
        let setting = begun.setting();
        let start = given.start(1, setting)?;
        told(&setting.run(Gains::read_one(&given.at(0))?, start))
    }),
    ("landscape", |begun, given| {
        let (landscape, rows) = Landscape::read(&given.at(0))?;
        told(&Column(landscape.costs(begun.setting(), rows)?))
    }),
    ("robustness", |begun, given| {
        let GridOfRobot { gains, starts } = GridOfRobot::read(&given.at(0))?;
        told(&Columns(&study::robustness(begun.setting(), gains, &starts.grid, starts.part)?))
    }),
    ("fares", |begun, given| {
        told(&Columns(&study::fares(begun.setting(), Gains::read_one(&given.at(0))?)))
    }),
    ("stability", |begun, given| {
        let setting = begun.setting();
        let start = given.start(1, setting)?;
        told(&study::Stability::of(setting, &Gains::read_one(&given.at(0))?, start))
    }),
    ("trials", |begun, given| {
        let Trials { seeds, drives } = Trials::read(&given.at(0))?;
        told(&study::trials(begun.setting(), seeds, drives)?)
    }),
    // Of an evolution.
    ("step", |begun, _| told(&begun.evolution().step())),
    ("generation", |begun, _| told(&begun.evolution().generation())),
    ("hash", |begun, _| told(&begun.evolution().hash())),
    ("statistics", |begun, given| {
        let evolution = begun.evolution();
        told(&evolution.statistics(given.generation(evolution)?)?)
    }),
    ("record", |begun, given| {
        let evolution = begun.evolution();
        told(&evolution.record(given.generation(evolution)?)?)
    }),
    ("population", |begun, given| {
        let evolution = begun.evolution();
        told(&evolution.population(given.generation(evolution)?)?)
    }),
];
