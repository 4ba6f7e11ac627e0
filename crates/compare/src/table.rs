//! The page's main table, for a terminal.

use crate::number::{ratio, seconds, short};
use crate::results::{Estimate, MethodResults, Metrics, Results, SceneResults, Target};
use std::fmt::Write;

/// Writes the most important results as text of some 130 columns.
pub fn table(results: &Results) -> String {
    let mut text = String::new();
    for scene in &results.scenes {
        text += &of_scene(scene);
    }
    if let Some(oracle) = &results.oracle {
        let found = |e: Estimate| format!("{:.4} ({:.4} to {:.4})", e.value, e.low, e.high);
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "oracle\n  puremc and directlight are equally noisy at R/h = {}, theory {:.5}\n  \
             and worth the same time at {}, theory {:.5}",
            found(oracle.crossing.measured),
            oracle.crossing.theory,
            found(oracle.crossing_in_time.measured),
            oracle.crossing_in_time.theory,
        );
    }
    text
}

fn of_scene(scene: &SceneResults) -> String {
    let mut text = format!("{}\n  {}\n", scene.name, scene.verdict.sentence);
    let Some(first) = scene.methods.first() else { return text + "\n" };
    let errors: Vec<String> =
        first.targets.iter().map(|target| format!("to {:.0e}", target.error)).collect();
    let names = scene.methods.iter().map(|method| method.marked_name().chars().count());
    let width = names.max().unwrap_or(0).max(20);
    let head = row(&["x time", "s a pass", "error a pass"].map(String::from), &errors);
    let _ = writeln!(text, "  {:<width$}{head}{:>10}{:>7}{:>7}", "method", "bias", "z", "tail");
    for method in &scene.methods {
        let _ = writeln!(text, "  {:<width$}{}", method.marked_name(), of_method(method, scene));
    }
    text.push('\n');
    text
}

fn of_method(method: &MethodResults, scene: &SceneResults) -> String {
    let known = scene.verdict.best.is_some();
    let each = [
        if known { ratio(method).cell() } else { "-".into() },
        short(method.seconds_per_pass.value),
        short(method.error_per_pass.value),
    ];
    let times: Vec<String> = method.targets.iter().map(time).collect();
    let tail = match (&method.stability.tail, method.stability.alarm) {
        (_, true) => String::from("ALARM"),
        (Some(index), false) => format!("{:.1}", index.value),
        (None, false) => String::from("-"),
    };
    let Metrics { bias, bias_z, .. } = method.metrics;
    let (bias, z) = (format!("{:+.2} %", 100.0 * bias), format!("{bias_z:+.1}"));
    format!("{}{bias:>10}{z:>7}{tail:>7}", row(&each, &times))
}

fn time(target: &Target) -> String {
    target.seconds.map_or_else(|| "never".into(), |time| seconds(time.value))
}

fn row([ratio, pass, error]: &[String; 3], times: &[String]) -> String {
    let times: Vec<String> = times.iter().map(|time| format!("{time:>12}")).collect();
    format!("{ratio:>24}{pass:>10}{error:>13}{}", times.concat())
}
