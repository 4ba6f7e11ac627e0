//! The page's main table, for a terminal.

use crate::page::number::short;
use crate::results::{Estimate, MethodResults, Results, SceneResults, Target};
use std::fmt::Write;

/// Everything that matters most, as text of some 100 columns.
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
    let errors: Vec<String> = scene
        .methods
        .first()
        .map(|method| method.targets.iter().map(|t| format!("to {:.0e}", t.error)).collect())
        .unwrap_or_default();
    text += &row("method", &["x time", "s a pass", "error a pass"], &errors, "bias", "tail");
    for method in &scene.methods {
        text += &of_method(method);
    }
    text.push('\n');
    text
}

fn of_method(method: &MethodResults) -> String {
    let Estimate { value, low, high } = method.cost_ratio;
    let ratio = if low == high {
        String::from("1")
    } else {
        format!("{} ({}-{})", short(value), short(low), short(high))
    };
    let each = [ratio, short(method.seconds_per_pass.value), short(method.error_per_pass.value)];
    let times: Vec<String> = method.targets.iter().map(time).collect();
    let tail = match (&method.stability.tail, method.stability.alarm) {
        (_, true) => String::from("ALARM"),
        (Some(index), false) => format!("{:.1}", index.value),
        (None, false) => String::from("-"),
    };
    let bias = format!("{:+.2} %", 100.0 * method.metrics.bias);
    let [ratio, pass, error] = &each;
    row(&method.name, &[ratio, pass, error], &times, &bias, &tail)
}

fn time(target: &Target) -> String {
    target.seconds.map_or_else(|| "never".into(), |s| format!("{} s", short(s.value)))
}

fn row(name: &str, each: &[&str; 3], times: &[String], bias: &str, tail: &str) -> String {
    let mut text = format!("  {name:<22}{:>20}{:>10}{:>13}", each[0], each[1], each[2]);
    for time in times {
        let _ = write!(text, "{time:>12}");
    }
    let _ = writeln!(text, "{bias:>10}{tail:>7}");
    text
}
