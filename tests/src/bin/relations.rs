//! `cargo xtask relations`: scenes drawn by chance, and relations that must hold.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks to its user")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};
use traylib_io::printable;
use traylib_tests::relations::case::Case;
use traylib_tests::relations::judge::First;
use traylib_tests::relations::outside;
use traylib_tests::relations::pooled::ratio;
use traylib_tests::relations::relation::Relation;
use traylib_tests::relations::render::Workshop;
use traylib_tests::relations::report::save;
use traylib_tests::relations::run::{Bench, Outcome, Plan, Summary, run};

const HELP: &str = "\
Draws scenes by chance and holds relations on them that a right renderer keeps.

Usage: cargo xtask relations [OPTIONS]

  --scenes N          how many [default: 5000]
  --first N           the number of the first [default: 0]
  --seed S            another seed, other scenes [default: 1]
  --case FILE         the scene of this file instead
  --relation NAME     this relation alone
  --shrink SECONDS    how long to look for a smaller scene where one is broken
                      [default: 20]
  --passes N          passes of the first look [default: 128]
  --changes N         forms of each scene to try [default: 6]

Exit status: 0 all hold, 1 not so, 2 the command line was not understood.";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.iter().any(|word| word == "--help" || word == "-h") {
        println!("{HELP}");
        return ExitCode::SUCCESS;
    }
    let Some((plan, case)) = understand(&arguments) else {
        eprintln!("error: not understood: `{}`\n\n{HELP}", arguments.join(" "));
        return ExitCode::from(2);
    };
    if let (None | Some(Relation::Mitsuba), Err(why)) = (plan.only, outside::python()) {
        println!("Mitsuba not asked: {why}");
    }
    let start = Instant::now();
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../target/relations"));
    let tell = |outcome: &Outcome| match save(outcome, plan.seed, &folder) {
        Ok(file) => println!("{outcome}\n    {}", file.display()),
        Err(error) => println!("{outcome}\n    not saved: {error}"),
    };
    let summary = if let Some(case) = &case { again(case, &plan) } else { run(&plan, &tell) };
    print_summary(&summary, start.elapsed());
    if summary.others.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn understand(arguments: &[String]) -> Option<(Plan, Option<PathBuf>)> {
    let mut plan = Plan::default();
    let (mut count, mut first, mut case) = (5000, 0, None);
    let mut words = arguments.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--scenes" => count = words.next()?.parse().ok()?,
            "--first" => first = words.next()?.parse().ok()?,
            "--seed" => plan.seed = words.next()?.parse().ok()?,
            "--passes" => plan.passes = words.next()?.parse().ok()?,
            "--changes" => plan.changes = words.next()?.parse().ok()?,
            "--shrink" => plan.shrink = Some(Duration::from_secs(words.next()?.parse().ok()?)),
            "--case" => case = Some(PathBuf::from(words.next()?)),
            "--relation" => plan.only = Some(Relation::named(words.next()?)?),
            _ => return None,
        }
    }
    plan.scenes = first..first + count;
    Some((plan, case))
}

/// Every relation on one scene from disk.
fn again(file: &Path, plan: &Plan) -> Summary {
    let workshop = Workshop::new(plan.patience).expect("a folder for files");
    let case = match Case::read(file) {
        Ok(case) => case,
        Err(error) => {
            eprintln!("error: {}", printable(&error));
            return Summary::default();
        }
    };
    let relations = plan.only.map_or_else(Relation::all, |only| vec![only]);
    let number = plan.scenes.start;
    let bench = Bench {
        workshop: &workshop,
        seed: plan.seed,
        number,
        passes: plan.passes,
        right: case.right,
        turn: 0,
    };
    let summary = bench.judge(&case.drawn, &relations);
    for (relation, what, First { means: [left, right], variances, p }) in &summary.held {
        let [a, b] = variances.map(f64::sqrt);
        println!("{relation}: {what}: {left:.6e} ± {a:.1e}, {right:.6e} ± {b:.1e}, p = {p:.1e}");
    }
    summary.others.iter().for_each(|outcome| println!("{}", printable(&outcome.to_string())));
    summary
}

fn print_summary(summary: &Summary, time: Duration) {
    let mut by_claim: BTreeMap<(Relation, String), Vec<First>> = BTreeMap::new();
    for (relation, what, first) in &summary.held {
        let what = if *relation == Relation::Methods { what.clone() } else { String::new() };
        by_claim.entry((*relation, what)).or_default().push(*first);
    }
    for ((relation, what), firsts) in &by_claim {
        let pooled = ratio(firsts).map_or(String::from("-"), |(interval, scenes)| {
            format!("{:+.2e} ± {:.1e} over {scenes}", interval.mean, interval.half_width)
        });
        println!("{relation} {what}: {} held, mean log ratio {pooled}", firsts.len());
    }
    println!(
        "{} scenes, {} claims, {} do not hold, {:.0} s; slowest {:?}",
        summary.scenes,
        summary.claims,
        summary.others.len(),
        time.as_secs_f64(),
        summary.slowest,
    );
}
