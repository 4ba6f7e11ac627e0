//! `cargo xtask engines`: a rendering in seven parts by the queues that people have, with the
//! files of `docs/howto/cluster`; parts are moved in the middle, and killed. What comes
//! of it has the bytes of one run. A queue that is not installed is skipped, aloud.

mod openjd;
mod parallel;
mod slurm;

use crate::workspace;
use anyhow::{Context, Result, bail, ensure};
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

/// Parts of the rendering.
const PARTS: u32 = 7;

/// The rendering: program, scene and options; each part takes some seconds.
const PROGRAM: &str = "bdpt";
const SCENE: &str = "cornell";
const OPTIONS: &str = "--resolution 80x60 --spp 400";

/// Runs all engines; an error if any makes other bytes.
pub(crate) fn run() -> Result<()> {
    let programs = workspace::programs()?;
    let folder = tempfile::tempdir()?;
    let whole = Place::new(folder.path(), "whole", &programs)?;
    let options = format!("{SCENE} {OPTIONS} -q --checkpoint all.film -o all.exr");
    workspace::finish(whole.command(PROGRAM).args(options.split(' ')))?;
    for (name, needs, install, engine) in ENGINES {
        if let Some(missing) = needs.iter().find(|program| find(program).is_none()) {
            println!("engines: {name}: skipped, there is no {missing}; {install}");
            continue;
        }
        let place = Place::new(folder.path(), name, &programs)?;
        let start = Instant::now();
        let said = engine(&place).with_context(|| format!("{name} failed"))?;
        for file in ["all.film", "all.exr"] {
            let [found, expected] = [&place, &whole].map(|place| fs::read(place.folder.join(file)));
            let same = found.with_context(|| format!("{name} left no {file}"))? == expected?;
            ensure!(same, "{name}: {file} is not as from one run");
        }
        println!("engines: {name}: {said}; the bytes of one run, {:.1} s", seconds(start));
    }
    Ok(())
}

type Engine = fn(&Place) -> Result<String>;

/// Each with the programs that it needs, and where they are from.
const ENGINES: [(&str, &[&str], &str, Engine); 3] = [
    (
        "slurm",
        &["munged", "slurmctld", "slurmd", "sbatch"],
        "apt-get install slurm-wlm munge",
        slurm::run,
    ),
    ("parallel", &["parallel"], "apt-get install parallel", parallel::run),
    ("openjd", &["openjd"], "pip install openjd-cli", openjd::run),
];

fn seconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64()
}

/// The file of a program, also of one for administrators.
fn find(program: &str) -> Option<PathBuf> {
    let folders = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::env::split_paths(&folders).chain([PathBuf::from("/usr/sbin")]);
    folders.map(|folder| folder.join(program)).find(|file| file.is_file())
}

/// A folder to render in.
struct Place {
    folder: PathBuf,
    path: OsString,
}

impl Place {
    fn new(above: &Path, name: &str, programs: &Path) -> Result<Self> {
        let folder = above.join(name);
        fs::create_dir(&folder)?;
        let path = std::env::var_os("PATH").unwrap_or_default();
        let folders = std::env::split_paths(&path).chain([PathBuf::from("/usr/sbin")]);
        let path = std::env::join_paths([programs.to_path_buf()].into_iter().chain(folders))?;
        Ok(Self { folder, path })
    }

    /// A program that is run here, and finds ours.
    fn command(&self, program: &str) -> Command {
        let found = std::env::split_paths(&self.path).map(|folder| folder.join(program));
        let file = found.into_iter().find(|file| file.is_file());
        let mut command = Command::new(file.unwrap_or_else(|| program.into()));
        command.current_dir(&self.folder).env("PATH", &self.path);
        command
    }

    /// Returns the output of a program that is run here.
    fn output(&self, program: &str, arguments: &[&str]) -> Result<String> {
        let output = self.command(program).args(arguments).output();
        let output = output.with_context(|| format!("{program} does not start"))?;
        let said = String::from_utf8_lossy(&output.stderr);
        ensure!(output.status.success(), "{program} {arguments:?}: {}: {said}", output.status);
        Ok(String::from_utf8_lossy(&output.stdout).trim().to_string())
    }

    /// Waits until a part has its first checkpoint.
    fn wait_for_part(&self, part: u32) -> Result<()> {
        let file = self.folder.join(format!("part-{part}.film"));
        wait_until(&format!("part {part} has no checkpoint"), || Ok(file.exists()))
    }

    /// Kills the program that renders a part, as a system does that lacks memory.
    fn kill_part(&self, part: u32) -> Result<()> {
        let shard = format!("{part}/{PARTS}");
        for entry in fs::read_dir("/proc")?.flatten() {
            let is_here =
                fs::read_link(entry.path().join("cwd")).is_ok_and(|cwd| cwd == self.folder);
            let words = fs::read(entry.path().join("cmdline")).unwrap_or_default();
            let mut words = words.split(|byte| *byte == 0);
            let is_program = words.next().is_some_and(|word| word.ends_with(PROGRAM.as_bytes()));
            if is_here && is_program && words.any(|word| word == shard.as_bytes()) {
                let number = entry.file_name().to_string_lossy().into_owned();
                return workspace::finish(Command::new("kill").args(["-KILL", &number]));
            }
        }
        bail!("part {part} was done before it could be killed")
    }

    /// Tells whether a log tells that a part went on from its checkpoint.
    fn went_on(&self, log: &str) -> Result<bool> {
        Ok(fs::read_to_string(self.folder.join(log))?.contains("going on from part-"))
    }
}

/// Longer than all of it takes on a machine with other work.
const LONGEST: Duration = Duration::from_mins(8);

/// Waits until something is so; an error with these words if it never is.
fn wait_until(else_words: &str, mut is_so: impl FnMut() -> Result<bool>) -> Result<()> {
    let start = Instant::now();
    while !is_so()? {
        ensure!(start.elapsed() < LONGEST, "{else_words} after {:.0} s", seconds(start));
        std::thread::sleep(Duration::from_millis(100));
    }
    Ok(())
}
