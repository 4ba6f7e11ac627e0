//! Mitsuba as a judge from outside, where it is installed: a process that renders the files it is
//! told of.

use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::OnceLock;

/// What is asked of the process and how, a line of JSON each, is said there.
const PROGRAM: &str = include_str!("outside/worker.py");

/// A process that renders, and ends with this value.
#[derive(Debug)]
pub struct Mitsuba {
    process: Child,
    asked: Option<ChildStdin>,
    said: BufReader<ChildStdout>,
}

#[derive(Serialize)]
struct Question<'a> {
    file: &'a Path,
    seed: u64,
    passes: u32,
}

/// What it found.
#[derive(Clone, Debug, Deserialize)]
pub struct Passes {
    /// Of each pass the mean of the picture and of its quarters.
    pub passes: Vec<[f64; 5]>,
    /// Pixels of the picture.
    pub pixels: u32,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Answer {
    Found(Passes),
    Error { error: String },
}

/// The Python that has Mitsuba: that of `MITSUBA_PYTHON`, or `python3`.
///
/// # Errors
/// Why there is none, in words.
pub fn python() -> Result<OsString, String> {
    static FOUND: OnceLock<Result<OsString, String>> = OnceLock::new();
    FOUND.get_or_init(look_for_python).clone()
}

fn look_for_python() -> Result<OsString, String> {
    let python = std::env::var_os("MITSUBA_PYTHON").unwrap_or_else(|| "python3".into());
    let name = python.to_string_lossy().into_owned();
    let tried = Command::new(&python)
        .args(["-c", "import mitsuba, numpy; mitsuba.set_variant('scalar_rgb')"])
        .stdin(Stdio::null())
        .output();
    match tried {
        Ok(tried) if tried.status.success() => Ok(python),
        Ok(_) => Err(format!("`{name}` has no mitsuba; MITSUBA_PYTHON may name one that has")),
        Err(error) => Err(format!("`{name}` does not start: {error}")),
    }
}

impl Mitsuba {
    /// Starts it.
    ///
    /// # Errors
    /// Why not, in words.
    pub fn start() -> Result<Self, String> {
        let process = Command::new(python()?)
            .args(["-c", PROGRAM])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn();
        let mut process = process.map_err(|error| error.to_string())?;
        let asked = process.stdin.take();
        let said = process.stdout.take().ok_or("it has no output")?;
        Ok(Self { process, asked, said: BufReader::new(said) })
    }

    /// Renders a file; the seed says with which random numbers.
    ///
    /// # Errors
    /// Why not, in its words.
    pub fn render(&mut self, file: &Path, seed: u64, passes: u32) -> Result<Passes, String> {
        let question = Question { file, seed, passes };
        let question = serde_json::to_string(&question).map_err(|error| error.to_string())?;
        let asked = self.asked.as_mut().ok_or("it has no input")?;
        writeln!(asked, "{question}").map_err(|error| error.to_string())?;
        let mut line = String::new();
        self.said.read_line(&mut line).map_err(|error| error.to_string())?;
        match serde_json::from_str(&line).map_err(|error| error.to_string())? {
            Answer::Found(passes) => Ok(passes),
            Answer::Error { error } => Err(error),
        }
    }
}

impl Drop for Mitsuba {
    fn drop(&mut self) {
        // Without input it ends by itself.
        drop(self.asked.take());
        let _ = self.process.wait();
    }
}
