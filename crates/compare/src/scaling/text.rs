//! The measurements, as text.

use super::{AxisResults, METHODS, Scaling};
use crate::number::{bytes, significant};
use std::fmt::Write;

/// For people: a table an axis, with the power of size by which each quantity grows from
/// one line to the next.
pub fn table(scaling: &Scaling) -> String {
    scaling.axes.iter().map(axis).collect::<Vec<_>>().join("\n")
}

fn axis(results: &AxisResults) -> String {
    let mut text = format!("{:>10}  {:>10}  {:>10}", results.axis.name(), "build", "scene");
    for method in METHODS {
        let _ = write!(text, "  {:>22}  {:>6}  {:>10}", method.to_string(), "power", "picture");
    }
    text.push('\n');
    for (place, level) in results.levels.iter().enumerate() {
        let build = format!("{} s", significant(level.build_seconds, 2));
        let _ = write!(text, "{:>10}  {build:>10}  {:>10}", level.size, bytes(level.scene_bytes));
        for (number, (sample, memory)) in
            level.sample_seconds.iter().zip(&level.render_bytes).enumerate()
        {
            let nanoseconds = [sample.value, sample.low, sample.high].map(|t| (1e9 * t).round());
            let time = format!("{} ns ({}–{})", nanoseconds[0], nanoseconds[1], nanoseconds[2]);
            let power = results.growth(place, |level| level.sample_seconds[number].value);
            let power = if power.is_nan() { String::new() } else { format!("{power:.2}") };
            let _ = write!(text, "  {time:>22}  {power:>6}  {:>10}", bytes(*memory));
        }
        text.push('\n');
    }
    text
}

/// For programs: a line for each method at each level.
pub fn csv(scaling: &Scaling) -> String {
    let mut text = String::from(
        "axis,size,method,build_s,scene_bytes,render_bytes,sample_s,sample_low_s,sample_high_s\n",
    );
    for results in &scaling.axes {
        for level in &results.levels {
            for (i, method) in METHODS.iter().enumerate() {
                let (time, memory) = (level.sample_seconds[i], level.render_bytes[i]);
                let _ = writeln!(
                    text,
                    "{},{},{method},{:e},{},{memory},{:e},{:e},{:e}",
                    results.axis.name(),
                    level.size,
                    level.build_seconds,
                    level.scene_bytes,
                    time.value,
                    time.low,
                    time.high
                );
            }
        }
    }
    text
}
