//! The machine and the program that a comparison was made with, as it tells of them.

use crate::options::Options;
use crate::results::How;
use traylib_math::Fnv;

/// Describes how it is made, but for how long it takes.
pub fn how(options: &Options, arguments: &[String]) -> How {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    How {
        command: command(arguments),
        program: concat!("TrayLib ", env!("CARGO_PKG_VERSION")).into(),
        commit: commit(traylib_demos::VERSION).map(String::from),
        processor: processor().unwrap_or_else(|| std::env::consts::ARCH.into()),
        threads: if options.threads == 0 { processors } else { options.threads },
        sampler: options.sampler.to_string(),
        seeds: options.seeds(),
        first_seed: options.first_seed,
        budgets: options.budgets(),
        seconds: 0.0,
    }
}

fn command(arguments: &[String]) -> String {
    let quoted = |word: &String| {
        let plain = word.chars().all(|c| c.is_ascii_alphanumeric() || "-_=:,./".contains(c));
        if plain { word.clone() } else { format!("'{}'", word.replace('\'', r"'\''")) }
    };
    let words = arguments.iter().map(quoted);
    [String::from("cargo xtask compare-integrators")]
        .into_iter()
        .chain(words)
        .collect::<Vec<_>>()
        .join(" ")
}

/// Returns the commit in the text that `--version` prints, such as `0.1.0 (ec3c1fe01234)`.
fn commit(version: &str) -> Option<&str> {
    version.split_once('(')?.1.strip_suffix(')')
}

/// The processor's name, as Linux tells it.
fn processor() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_string())
}

/// FNV-1a of 64 bits (RFC 9923) of the program itself: another build may be faster, or wrong.
pub fn build_key() -> u64 {
    let bytes = std::env::current_exe().and_then(std::fs::read).unwrap_or_default();
    let mut hash = Fnv::default();
    hash.add(&bytes);
    hash.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[test]
    fn the_commit_is_that_of_the_program() {
        assert_eq!(commit("0.1.0 (ec3c1fe01234)"), Some("ec3c1fe01234"));
        assert_eq!(commit("0.1.0"), None);
        let told = how(&Options::parse_from(["x"]), &[]).commit;
        assert_eq!(told.as_deref(), commit(traylib_demos::VERSION));
    }

    #[test]
    fn the_command_can_be_pasted() {
        let words = ["my scene.ron", "--budgets", "1s,2s"].map(String::from);
        let text = command(&words);
        assert_eq!(text, "cargo xtask compare-integrators 'my scene.ron' --budgets 1s,2s");
    }
}
