//! The runs as comma-separated values: one line a run, with its metrics.

use crate::judge::Entry;
use crate::reference::Reference;
use std::fmt::Write;

/// The names of the columns.
pub const HEADER: &str = "scene,method,seed,passes,seconds,rel_mse,reference_rel_mse,\
trimmed_rel_mse,smape,mean_ratio,camera_rays,bounce_rays,shadow_rays,peak_bytes,rejected\n";

/// The lines of a scene. `rel_mse` still has the noise of the reference in it.
pub fn lines(scene: &str, entries: &[Entry], reference: &Reference, first_seed: u64) -> String {
    let mut text = String::new();
    for entry in entries {
        for (record, seed) in entry.records.iter().zip(first_seed..) {
            let [camera, bounce, shadow] = record.rays;
            let error = record.snapshots.last().map_or(f64::NAN, |snapshot| snapshot.error);
            // Writing to a string does not fail.
            let _ = writeln!(
                text,
                "{},{},{seed},{},{:.6},{error:e},{:e},{:e},{:e},{:.8},{camera},{bounce},{shadow},{},{}",
                quoted(scene),
                quoted(&entry.method.to_string()),
                record.passes,
                record.seconds,
                reference.results.own_error,
                record.trimmed_rel_mse,
                record.smape,
                record.mean_ratio,
                record.peak_bytes,
                record.rejected,
            );
        }
    }
    text
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_commas_stay_one_field() {
        assert_eq!(quoted("a,b"), "\"a,b\"");
        assert_eq!(quoted("bdpt --max-depth 6"), "bdpt --max-depth 6");
        assert_eq!(quoted("6\" disk"), "\"6\"\" disk\"");
    }
}
