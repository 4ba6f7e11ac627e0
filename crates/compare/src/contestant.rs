//! What takes part in a comparison: an integrator with its settings.

use std::fmt;
use std::str::FromStr;
use traylib_integrators::{
    Bdpt, DirectLight, Integrator, Limits, Particle, PureMc, SceneFacts, Techniques, Trace,
};
use traylib_math::Heuristic;
use traylib_tests::stability::column::Column;

/// An integrator with its settings, as `bdpt` or `combined:balance:depth=6`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contestant {
    program: Column,
    limits: Limits,
    heuristic: Heuristic,
    techniques: Techniques,
    name: String,
}

/// What is compared unless something else is asked for: every program, and the
/// settings of the two best ones that may pay.
pub const DEFAULT: [&str; 9] = [
    "trace",
    "puremc",
    "directlight",
    "combined",
    "particle",
    "bdpt",
    "combined:balance",
    "bdpt:balance",
    "bdpt:no-connections",
];

/// What is compared in a hurry: the programs alone.
pub const QUICK: [&str; 6] = ["trace", "puremc", "directlight", "combined", "particle", "bdpt"];

/// A name that no contestant has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownContestant(String);

impl fmt::Display for UnknownContestant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let programs = Column::ALL.map(Column::name);
        write!(
            f,
            "`{}` is no integrator here; wanted: one of {}, and after it any of :depth=N (N \
             from 1) and :roulette=N (N from 2), for combined and bdpt also :balance, for bdpt \
             also :no-connections",
            self.0,
            programs.join(", ")
        )?;
        let combine = self.0.contains("--combine");
        if combine { f.write_str("; `directlight --combine` is `combined` here") } else { Ok(()) }
    }
}

impl std::error::Error for UnknownContestant {}

impl FromStr for Contestant {
    type Err = UnknownContestant;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let unknown = || UnknownContestant(text.to_string());
        let mut words = text.split(':');
        let name = words.next().unwrap_or_default();
        let program = Column::ALL.into_iter().find(|program| program.name() == name);
        let mut contestant = Self::of(program.ok_or_else(unknown)?, text);
        words.try_for_each(|word| contestant.set(word).ok_or_else(unknown))?;
        Ok(contestant)
    }
}

impl Contestant {
    /// A program as it is by default.
    fn of(program: Column, name: &str) -> Self {
        Self {
            program,
            limits: Limits::default(),
            heuristic: Heuristic::Power,
            techniques: Techniques::ALL,
            name: name.to_string(),
        }
    }

    fn set(&mut self, setting: &str) -> Option<()> {
        let weighted = matches!(self.program, Column::Combined | Column::Bdpt);
        let walks = self.program != Column::Trace;
        let (key, number) = match setting.split_once('=') {
            Some((key, number)) => (key, Some(number.parse::<u32>().ok()?)),
            None => (setting, None),
        };
        match (key, number) {
            ("balance", None) if weighted => self.heuristic = Heuristic::Balance,
            ("depth", Some(1..)) if walks => self.limits.max_depth = number,
            ("roulette", Some(edge @ 2..)) if walks => self.limits.roulette.from_edge = edge,
            ("no-connections", None) if self.program == Column::Bdpt => {
                self.techniques.connections = false;
            }
            _ => return None,
        }
        Some(())
    }

    /// Its name with its settings.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The integrator itself.
    pub fn integrator(&self) -> Box<dyn Integrator> {
        let Self { limits, heuristic, techniques, .. } = *self;
        match self.program {
            // All others estimate the mean over a pixel.
            Column::Trace => Box::new(Trace { jitter: true }),
            Column::PureMc => Box::new(PureMc { limits }),
            Column::DirectLight => Box::new(DirectLight { limits, combine: None }),
            Column::Combined => Box::new(DirectLight { limits, combine: Some(heuristic) }),
            Column::Particle => Box::new(Particle { limits }),
            Column::Bdpt => Box::new(Bdpt { limits, heuristic, techniques, ..Bdpt::default() }),
        }
    }

    /// Edges of the longest paths that it follows, if its settings limit them.
    pub fn longest_path(&self) -> Option<u32> {
        self.limits.max_depth
    }

    /// The light that it cannot produce in such a scene, in words.
    pub fn blind_spots(&self, facts: &SceneFacts) -> Vec<String> {
        self.integrator().blind_spots(facts).iter().map(ToString::to_string).collect()
    }

    /// Whether it loses light that full bidirectional tracing finds: for a limit on
    /// path lengths, or because it is blind to it.
    pub fn is_biased(&self, facts: &SceneFacts) -> bool {
        let all = Bdpt::default().blind_spots(facts);
        let blind = self.integrator().blind_spots(facts);
        self.limits.max_depth.is_some() || blind.iter().any(|spot| !all.contains(spot))
    }

    /// Whether there is any light in such a scene that it is for.
    pub fn suits(&self, facts: &SceneFacts) -> bool {
        self.program != Column::Trace || facts.point_lights
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contestant(name: &str) -> Contestant {
        name.parse().unwrap()
    }

    #[test]
    fn all_that_run_by_default_exist() {
        for name in DEFAULT.iter().chain(&QUICK) {
            assert_eq!(contestant(name).name(), *name);
        }
    }

    #[test]
    fn settings_are_taken_by_those_they_are_for() {
        let lean = contestant("bdpt:no-connections:depth=6:roulette=5:balance");
        assert_eq!((lean.limits.max_depth, lean.limits.roulette.from_edge), (Some(6), 5));
        assert!(!lean.techniques.connections && lean.techniques.splats);
        assert_eq!(lean.heuristic, Heuristic::Balance);
        for bad in [
            "",
            "pt",
            "puremc:balance",
            "bdpt:depth",
            "bdpt:depth=0",
            "bdpt:depth=x",
            "bdpt:roulette=1",
            "combined:no-connections",
            "bdpt:",
            "trace:depth=3",
            "bdpt:balance=1",
        ] {
            assert!(bad.parse::<Contestant>().is_err(), "{bad}");
        }
    }

    #[test]
    fn what_is_wanted_is_told() {
        let told = |text: &str| text.parse::<Contestant>().unwrap_err().to_string();
        assert!(told("bdpt:depth=0").contains(":depth=N (N from 1)"));
        assert!(told("directlight --combine").contains("is `combined` here"));
        assert!(!told("directlight:power").contains("`combined`"));
    }

    #[test]
    fn whoever_loses_light_is_biased() {
        let mirrors = SceneFacts { area_lights: true, point_lights: false, mirrors: true };
        let plain = SceneFacts { mirrors: false, ..mirrors };
        assert!(contestant("particle").is_biased(&mirrors));
        assert!(!contestant("particle").is_biased(&plain));
        assert!(contestant("bdpt:depth=4").is_biased(&plain));
        assert!(!contestant("bdpt").is_biased(&mirrors));
        assert!(!contestant("trace").suits(&plain) && contestant("puremc").suits(&plain));
    }
}
