//! A browser without a window.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const VARIABLE: &str = "TRAYLIB_BROWSER";
const TIME: Duration = Duration::from_mins(2);
const QUIET: [&str; 11] = [
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--enable-logging=stderr",
    "--virtual-time-budget=5000",
    "--dump-dom",
];

/// The colour scheme that the system prefers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scheme {
    Light,
    Dark,
}

/// The output of a browser.
#[derive(Debug)]
pub(crate) struct Dump {
    /// The document after its scripts ran.
    pub(crate) document: String,
    /// The complaints on its console.
    pub(crate) complaints: Vec<String>,
}

/// A program that shows pages.
#[derive(Debug)]
pub(crate) struct Browser(PathBuf);

impl Browser {
    #[allow(clippy::print_stderr, reason = "a test that is skipped has to say so")]
    /// The one named by the environment, or the first on the path.
    pub(crate) fn find() -> Option<Self> {
        if let Some(named) = std::env::var_os(VARIABLE) {
            return Some(Self(named.into()));
        }
        let path = std::env::var_os("PATH").unwrap_or_default();
        let found = std::env::split_paths(&path)
            .flat_map(|folder| NAMES.map(|name| folder.join(name)))
            .find(|file| file.is_file());
        if found.is_none() {
            eprintln!("skipped: no browser ({}) is installed; {VARIABLE} may name one", NAMES[0]);
        }
        found.map(Self)
    }

    /// Opens a page and waits until its scripts are done.
    pub(crate) fn open(&self, page: &str, scheme: Scheme) -> Dump {
        let folder = Folder::new();
        let file = folder.0.join("page.html");
        std::fs::write(&file, page).unwrap();
        let mut running = self.start(&folder.0, &file, scheme);
        finish(&mut running);
        let read = |name: &str| {
            String::from_utf8_lossy(&std::fs::read(folder.0.join(name)).unwrap()).into_owned()
        };
        let log = read("log");
        let complaints = log.lines().filter(|line| line.contains(":CONSOLE"));
        Dump { document: read("document"), complaints: complaints.map(String::from).collect() }
    }

    /// Output goes to files: a pipe that nobody empties would stop the browser.
    fn start(&self, folder: &Path, page: &Path, scheme: Scheme) -> Child {
        let create = |name: &str| Stdio::from(std::fs::File::create(folder.join(name)).unwrap());
        let prefers = u8::from(scheme == Scheme::Light);
        Command::new(&self.0)
            .args(QUIET)
            .arg(format!("--user-data-dir={}", folder.join("profile").display()))
            .arg("--window-size=1400,900")
            .arg(format!("--blink-settings=preferredColorScheme={prefers}"))
            .arg(format!("file://{}", page.display()))
            .stdin(Stdio::null())
            .stdout(create("document"))
            .stderr(create("log"))
            .spawn()
            .unwrap_or_else(|cause| panic!("{}: {cause}", self.0.display()))
    }
}

/// Waits for the end, and makes one if there is none.
fn finish(running: &mut Child) {
    let start = Instant::now();
    while start.elapsed() < TIME {
        if running.try_wait().unwrap().is_some() {
            return;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    running.kill().unwrap();
    running.wait().unwrap();
    panic!("the browser took more than {} s", TIME.as_secs());
}

/// A new folder, removed when dropped.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let n = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("traylib-page-{}-{n}", std::process::id()));
        std::fs::create_dir(&path).unwrap();
        Self(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
