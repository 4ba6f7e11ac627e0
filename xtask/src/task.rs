//! The words of a command line as a task.

use crate::proofs::Until;

/// Programs of `crates/compare` that are tasks under their own names.
const CHARTS: [&str; 4] = ["compare-integrators", "needs", "scaling", "costs"];

/// What `cargo xtask` is asked for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Task<'a> {
    Layers,
    CheckData {
        folder: &'a str,
    },
    Ci,
    #[cfg(unix)]
    Engines,
    Package,
    Book,
    Release {
        target: Option<&'a str>,
    },
    Prove,
    Faults {
        names: Vec<&'a str>,
        until: Until,
    },
    EditFault {
        name: &'a str,
    },
    SaveFault {
        name: &'a str,
        wrong: Option<&'a str>,
    },
    Relations(Vec<&'a str>),
    Stability(Vec<&'a str>),
    CountInstructions(Vec<&'a str>),
    Chart {
        program: &'a str,
        arguments: Vec<&'a str>,
    },
    Help,
}

impl<'a> Task<'a> {
    /// Finds the task that these words ask for; `None` if they are none.
    pub(crate) fn of(words: &[&'a str]) -> Option<Self> {
        let (first, rest) = words.split_first()?;
        let task = match (*first, rest) {
            ("layers", []) => Self::Layers,
            ("check-data", [folder]) => Self::CheckData { folder },
            ("ci", []) => Self::Ci,
            #[cfg(unix)]
            ("engines", []) => Self::Engines,
            ("package", []) => Self::Package,
            ("book", []) => Self::Book,
            ("release", []) => Self::Release { target: None },
            ("release", ["--target", target]) => Self::Release { target: Some(target) },
            ("prove", []) => Self::Prove,
            ("faults", arguments) => Self::faults(arguments)?,
            ("relations", arguments) => Self::Relations(arguments.to_vec()),
            ("stability", arguments) => Self::Stability(arguments.to_vec()),
            ("count-instructions", arguments) => Self::CountInstructions(arguments.to_vec()),
            (program, arguments) if CHARTS.contains(&program) => {
                Self::Chart { program, arguments: arguments.to_vec() }
            }
            ("help" | "-h" | "--help", []) => Self::Help,
            _ => return None,
        };
        Some(task)
    }

    fn faults(arguments: &[&'a str]) -> Option<Self> {
        let task = match *arguments {
            [] => Self::Faults { names: Vec::new(), until: Until::TheEnd },
            ["--only", ref names @ ..] if !names.is_empty() => {
                Self::Faults { names: names.to_vec(), until: Until::TheEnd }
            }
            ["--quick", ref names @ ..] => {
                Self::Faults { names: names.to_vec(), until: Until::OneFails }
            }
            ["--edit", name] => Self::EditFault { name },
            ["--save", name] => Self::SaveFault { name, wrong: None },
            ["--save", name, wrong] => Self::SaveFault { name, wrong: Some(wrong) },
            _ => return None,
        };
        Some(task)
    }
}
