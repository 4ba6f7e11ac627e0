//! The program as its users meet it.

use std::process::{Command, Output};

fn xtask(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_xtask");
    Command::new(program).args(arguments).output().expect("the program was just built")
}

#[test]
fn the_workspace_keeps_its_layers() {
    let output = xtask(&["layers"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}

#[test]
fn help_names_every_task() {
    let output = xtask(&["--help"]);
    assert!(output.status.success());
    let help = String::from_utf8(output.stdout).unwrap();
    let source = include_str!("../src/task.rs");
    let (_, tasks) = source.split_once("match (*first, rest) {").unwrap();
    let names = tasks.lines().filter_map(|line| line.trim().strip_prefix("(\"")?.split('"').next());
    let names: Vec<&str> = names.filter(|name| *name != "help").collect();
    assert!(names.len() > 10, "{names:?}");
    for task in names {
        assert!(help.contains(&format!("\n  {task} ")), "{task}: {help}");
    }
}

#[test]
fn an_unknown_task_is_a_mistake_of_the_command_line() {
    for words in [&[][..], &["polish"], &["layers", "ci"], &["faults", "--only"]] {
        assert_eq!(xtask(words).status.code(), Some(2), "{words:?}");
    }
}
