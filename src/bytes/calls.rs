//! What can be called, by name.

use super::value::{Bytes, Given, Value};
use crate::outside;
use crate::run::{Experiment, PAPER_RESULTS, Setting};
use crate::schema::{Plain, Result, Source};
use crate::study::{Circle, Evolution, Grid};

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
        let call = CALLS.iter().chain(OF_A_SETTING).find(|(known, _)| known == name);
        let Some((_, call)) = call else { panic!("there is no call {name}") };
        call(self, Arguments(given))
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

impl<'a> Arguments<'a> {
    fn next(&mut self) -> Given<'a> {
        Given(self.0.split_off_first())
    }

    /// The number of a generation; the newest if it is null.
    fn generation(mut self, evolution: &Evolution) -> Result<u32> {
        let given = Given(self.next().0.filter(|given| **given != Value::Null));
        outside::generation(evolution, &given)
    }
}

fn told(value: &impl Plain) -> Result<Vec<u8>> {
    Ok(value.write(&Bytes))
}

type Call = fn(&mut Begun, Arguments<'_>) -> Result<Vec<u8>>;

const CALLS: &[(&str, Call)] = &[
    // Of nothing.
    ("experiment", |_, mut given| {
        let [given, changes] = [given.next(), given.next()];
        if given.text().is_some() {
            return told(outside::experiment(&given, &changes)?.0.experiment());
        }
        let mut experiment = outside::setting(&given)?.0.experiment().clone();
        if changes.is_given() {
            experiment.read(&changes)?;
        }
        told(Setting::new(experiment)?.experiment())
    }),
    ("fields", |_, _| told(&Experiment::fields().numbers)),
    ("word_fields", |_, _| told(&Experiment::fields().words)),
    ("paper", |_, _| told(&PAPER_RESULTS)),
    ("starts_on_circle", |_, mut given| told(&Circle::read(&given.next())?.starts()?)),
    ("starts_on_grid", |_, mut given| {
        let (grid, part) = Grid::read(&given.next())?;
        told(&grid.starts(part)?)
    }),
    // What begins.
    ("begin_task", |begun, mut given| {
        let (setting, _) = outside::setting(&given.next())?;
        let whole = told(setting.experiment());
        *begun = Begun::Task(setting);
        whole
    }),
    ("begin_evolution", |begun, mut given| {
        let (setting, _) = outside::setting(&given.next())?;
        let whole = told(setting.experiment());
        *begun = Begun::Evolution(Evolution::new(setting));
        whole
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

/// Calls of an experiment; each is known by the name that it has in Rust.
macro_rules! of_a_setting {
    ($setting:ident $(
        $doc:literal
        $name:ident $js:literal($($given:ident: $type:literal),+ $(; $last:ident)?) -> $returned:ty as $told:literal
        $body:block
    )+) => {
        const OF_A_SETTING: &[(&str, Call)] = &[$((stringify!($name), |begun, mut asked| {
            $(let $given = asked.next();)+
            $(let $last = asked.next();)?
            told(&outside::$name(begun.setting(), $(&$given,)+ $(&$last)?)?)
        })),+];
    };
}

outside::calls!(of_a_setting);
