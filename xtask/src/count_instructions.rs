//! `cargo xtask count-instructions`: how many instructions a ray and a triangle take,
//! counted by valgrind. However busy the machine is, the number is the same.

mod options;
mod table;

use crate::workspace;
use anyhow::{Context, Result, bail, ensure};
use options::Options;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use table::{Count, Table};

/// The function that the bench works in, and whatever it calls.
const COUNTED: &str = "*counted_by_valgrind*";

/// Counts every case and prints them; saves and compares them when asked to.
pub(crate) fn run(arguments: &[&str]) -> Result<()> {
    let Some(options) = Options::parse(arguments)? else {
        println!("{}", options::HELP);
        return Ok(());
    };
    let before = options.against.as_deref().map(Table::read).transpose()?;
    check_for_valgrind()?;
    let bench = build_bench()?;
    let mut counted = Table::default();
    table::print_head();
    for case in cases(&bench)?.iter().filter(|case| options.wants(case)) {
        let count = count(&bench, case)?;
        table::print_row(case, &count, before.as_ref());
        counted.insert(case, &count);
    }
    ensure!(!counted.is_empty(), "no case has such a name");
    options.save.as_deref().map_or(Ok(()), |file| counted.write(file))
}

/// Tells whether [`run`] would understand these arguments.
#[cfg(all(test, unix))]
pub(crate) fn check(arguments: &[&str]) -> Result<()> {
    Options::parse(arguments).map(drop)
}

fn check_for_valgrind() -> Result<()> {
    let found = Command::new("valgrind").arg("--version").stdout(Stdio::null()).status();
    ensure!(
        found.is_ok_and(|status| status.success()),
        "`valgrind` does not start; install it, with `apt-get install valgrind` or as your \
         system has it, and run this again"
    );
    Ok(())
}

/// Without threads: valgrind counts in the thread that calls the function.
fn build_bench() -> Result<PathBuf> {
    let build = ["bench", "--package", "traylib-geometry", "--bench", "instructions"];
    let how = ["--no-default-features", "--no-run", "--message-format", "json"];
    let mut command = workspace::cargo(&[&build[..], &how].concat());
    let output = command.stderr(Stdio::inherit()).output().context("cargo does not start")?;
    ensure!(output.status.success(), "{command:?} ended with {}", output.status);
    executable(&String::from_utf8_lossy(&output.stdout)).context("cargo has built no bench")
}

/// The last executable that cargo's messages, one a line, tell of.
fn executable(messages: &str) -> Option<PathBuf> {
    let message = |line: &str| serde_json::from_str::<serde_json::Value>(line).ok();
    let path = |line| Some(PathBuf::from(message(line)?.get("executable")?.as_str()?));
    messages.lines().rev().find_map(path)
}

fn cases(bench: &Path) -> Result<Vec<String>> {
    let text = output_of(&mut Command::new(bench))?;
    Ok(text.lines().map(str::to_owned).collect())
}

fn count(bench: &Path, case: &str) -> Result<Count> {
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--error-exitcode=1"]);
    command.arg(format!("--toggle-collect={COUNTED}"));
    let output = command.arg(bench).arg(case).output()?;
    let (out, err) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    if !output.status.success() {
        bail!("{command:?} ended with {}:\n{err}", output.status);
    }
    let counted = collected(&err).filter(|&count| count > 0);
    let instructions = counted.with_context(|| format!("valgrind counted nothing:\n{err}"))?;
    Count::new(instructions, out.trim()).with_context(|| format!("{case} said `{out}`"))
}

/// The number behind `Collected :` in what callgrind reports.
fn collected(report: &str) -> Option<u64> {
    let number = report.lines().find_map(|line| line.split_once("Collected :"))?.1;
    number.trim().parse().ok()
}

fn output_of(command: &mut Command) -> Result<String> {
    let output = command.output().with_context(|| format!("{command:?} does not start"))?;
    ensure!(output.status.success(), "{command:?} ended with {}", output.status);
    Ok(String::from_utf8(output.stdout)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_is_read_from_the_report() {
        let report = "==7== Events    : Ir\n==7== Collected : 12345\n==7== \n";
        assert_eq!(collected(report), Some(12345));
        assert_eq!(collected("==7== Collected: none"), None);
    }

    #[test]
    fn the_bench_is_found_among_cargos_messages() {
        let messages = "{\"reason\":\"compiler-artifact\",\"executable\":null}\nnot json\n\
                        {\"executable\":\"/a/instructions-1\"}\n{\"reason\":\"build-finished\"}\n";
        assert_eq!(executable(messages), Some(PathBuf::from("/a/instructions-1")));
        assert_eq!(executable("{}"), None);
    }
}
