//! The parts that the tests of the programs have in common.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicU32, Ordering};
use traylib_integrators::Method;

/// Every program that renders: one a method, and named as it is.
pub(crate) fn programs() -> [&'static str; Method::ALL.len()] {
    Method::ALL.map(Method::name)
}

/// The file of a program.
pub(crate) fn file(program: &str) -> PathBuf {
    let file = Path::new(env!("CARGO_BIN_EXE_film")).with_file_name(program);
    let file = file.with_extension(std::env::consts::EXE_EXTENSION);
    assert!(file.is_file(), "crates/demos/src/bin/{program}.rs is missing");
    file
}

/// A scene that makes sense, for tests to damage.
pub(crate) const SCENE: &str = r#"(
    camera: (position: (0, 0, 3), target: (0, 0, 0), fov: 40, resolution: (32, 24)),
    materials: { "grey": Lambert(reflectance: (0.5, 0.5, 0.5)) },
    objects: [
        (shape: Sphere(center: (0, 0, 0), radius: 1), material: "grey"),
        (shape: Quad(corner: (-1, 2, -1), edge_u: (2, 0, 0), edge_v: (0, 0, 2)), material: "grey", emission: (4, 4, 4)),
    ],
)
"#;

/// A new folder, removed with all that is in it when dropped.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let n = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("traylib-{}-{n}", std::process::id()));
        std::fs::create_dir(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).unwrap();
    }

    /// Returns the contents of a file.
    pub(crate) fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.0.join(name)).unwrap()
    }

    /// Names of all that is in it, in order.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// A program that is to run here, with arguments separated by blanks.
    pub(crate) fn command(&self, program: &str, arguments: &str) -> Command {
        let mut command = Command::new(file(program));
        command.current_dir(&self.0).args(arguments.split_whitespace());
        command
    }

    /// Runs a program here.
    pub(crate) fn run(&self, program: &str, arguments: &str) -> Run {
        Run::from(self.command(program, arguments).output().unwrap())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// All files of a folder and of those in it.
pub(crate) fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        if entry.path().is_dir() {
            let inner = self::files(&entry.path());
            files.extend(inner.into_iter().map(|(file, bytes)| (format!("{name}/{file}"), bytes)));
        } else {
            files.insert(name, std::fs::read(entry.path()).unwrap());
        }
    }
    files
}

/// Each program with options that change what is kept of it.
pub(crate) const MODES: [(&str, &str); 7] = [
    ("trace", ""),
    ("puremc", "--sampler independent"),
    ("directlight", "--combine --sampler sobol"),
    ("particle", "--sampler sobol"),
    ("bdpt", "--sampler independent"),
    ("bdpt", "--sampler sobol --max-depth 4"),
    ("bdpt", "--sampler independent --max-depth 3 --techniques techniques"),
];

/// Numbers that look drawn, always the same for a seed.
#[derive(Debug)]
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    /// Below `end`.
    pub(crate) fn below(&mut self, end: u64) -> u64 {
        // Knuth's linear congruences.
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (self.0 >> 33) % end
    }
}

/// The output and the status of a program.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) status: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl From<Output> for Run {
    fn from(output: Output) -> Self {
        Self {
            status: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}
