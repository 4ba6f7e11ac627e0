//! Which program a command starts, with which arguments.

use crate::count_instructions;
use crate::task::Task;

/// What the words of a command ask for.
#[derive(Debug, PartialEq)]
pub(super) enum Meaning<'a> {
    /// A task that has no program of its own, and is understood.
    Task,
    Program {
        name: &'a str,
        arguments: Vec<&'a str>,
    },
}

/// Finds what words mean; an error if they are not understood.
pub(super) fn meaning<'a>(words: &[&'a str]) -> Result<Meaning<'a>, String> {
    match words {
        ["cargo", "run", rest @ ..] => run(rest),
        ["cargo", "xtask", rest @ ..] => task(rest),
        [name, arguments @ ..] => Ok(Meaning::Program { name, arguments: arguments.to_vec() }),
        [] => Err("no words".into()),
    }
}

/// The words after `cargo run`.
fn run<'a>(words: &[&'a str]) -> Result<Meaning<'a>, String> {
    let mut words = words.iter();
    let mut name = None;
    while let Some(word) = words.next() {
        match *word {
            "--release" => {}
            "-p" | "--package" => drop(words.next()),
            "--bin" | "--example" => name = words.next(),
            "--" => break,
            other => return Err(format!("`{other}` stands before `--`")),
        }
    }
    let name = name.ok_or("no program is named")?;
    Ok(Meaning::Program { name, arguments: words.copied().collect() })
}

/// The words after `cargo xtask`.
fn task<'a>(words: &[&'a str]) -> Result<Meaning<'a>, String> {
    let program = |name, arguments| Ok(Meaning::Program { name, arguments });
    match Task::of(words).ok_or("there is no task like that")? {
        Task::Relations(arguments) => program("relations", arguments),
        Task::Stability(arguments) => program("stability", arguments),
        Task::Chart { program: name, arguments } => program(name, arguments),
        Task::CountInstructions(arguments) => {
            count_instructions::check(&arguments).map_err(|error| format!("{error:#}"))?;
            Ok(Meaning::Task)
        }
        Task::Layers
        | Task::CheckData { .. }
        | Task::Ci
        | Task::Package
        | Task::Book
        | Task::Release { .. }
        | Task::Prove
        | Task::Faults { .. }
        | Task::EditFault { .. }
        | Task::SaveFault { .. }
        | Task::Help => Ok(Meaning::Task),
        #[cfg(unix)]
        Task::Engines => Ok(Meaning::Task),
    }
}

#[test]
fn programs_and_tasks_are_told_apart() {
    let program =
        |name, arguments: &[&'static str]| Meaning::Program { name, arguments: arguments.to_vec() };
    let words = ["cargo", "run", "--release", "--bin", "bdpt", "--", "cornell"];
    assert_eq!(meaning(&words).unwrap(), program("bdpt", &["cornell"]));
    let words = ["cargo", "xtask", "needs", "pyramid"];
    assert_eq!(meaning(&words).unwrap(), program("needs", &["pyramid"]));
    assert_eq!(meaning(&["cargo", "xtask", "prove"]).unwrap(), Meaning::Task);
    assert_eq!(meaning(&["film", "info"]).unwrap(), program("film", &["info"]));
    assert!(meaning(&["cargo", "run", "--bin", "bdpt", "cornell"]).is_err());
    assert!(meaning(&["cargo", "xtask", "count-instructions", "--safe"]).is_err());
}
