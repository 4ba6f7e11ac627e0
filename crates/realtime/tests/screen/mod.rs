//! A display that nobody sees, with a mouse and a keyboard that nobody touches.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A display; ended when dropped.
pub(crate) struct Screen {
    server: Child,
    name: String,
}

impl Screen {
    /// # Errors
    /// Says which program is not installed for it.
    pub(crate) fn open() -> Result<Self, &'static str> {
        let silent = |program: &str| {
            let mut command = Command::new(program);
            command.stdout(Stdio::null()).stderr(Stdio::null()).stdin(Stdio::null());
            command
        };
        silent("xdotool").arg("version").status().map_err(|_| "xdotool is not installed")?;
        // It chooses a number that is free, and tells it. Without the last it begins anew, and
        // refuses whoever comes meanwhile, when the last of its clients has left.
        let arguments =
            ["-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp", "-noreset"];
        let server = silent("Xvfb").args(arguments).stdout(Stdio::piped()).spawn();
        let mut server = server.map_err(|_| "Xvfb is not installed")?;
        let mut number = String::new();
        let out = server.stdout.take().unwrap();
        BufReader::new(out).read_line(&mut number).unwrap();
        Ok(Self { server, name: format!(":{}", number.trim()) })
    }

    /// Returns its name in `DISPLAY`.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// The window with such a title, if there is one yet.
    pub(crate) fn window(&self, title: &str) -> Option<String> {
        self.xdotool(&["search", "--onlyvisible", "--name", title])
    }

    /// Returns the title of a window.
    pub(crate) fn title(&self, window: &str) -> String {
        self.xdotool(&["getwindowname", window]).unwrap_or_default()
    }

    /// Keys go to the window that the mouse points at.
    pub(crate) fn point_at(&self, window: &str, (x, y): (u32, u32)) {
        let (x, y) = (x.to_string(), y.to_string());
        self.xdotool(&["mousemove", "--window", window, &x, &y]);
    }

    /// Presses a key for a moment.
    pub(crate) fn key(&self, name: &str) {
        self.xdotool(&["key", name]);
    }

    /// Presses a key for so long that one goes a step.
    pub(crate) fn hold(&self, name: &str) {
        self.xdotool(&["keydown", name, "sleep", "0.3", "keyup", name]);
        // Looks come sixty times a second.
        sleep(Duration::from_millis(200));
    }

    /// Draws the mouse with its left button.
    pub(crate) fn drag(&self, window: &str, from: (u32, u32), to: (u32, u32)) {
        let moment = || sleep(Duration::from_millis(200));
        self.point_at(window, from);
        self.xdotool(&["mousedown", "1"]);
        moment();
        self.point_at(window, to);
        moment();
        self.xdotool(&["mouseup", "1"]);
        moment();
    }

    pub(crate) fn resize(&self, window: &str, (width, height): (u32, u32)) {
        let (width, height) = (width.to_string(), height.to_string());
        self.xdotool(&["windowsize", window, &width, &height]);
    }

    /// Returns its answer; `None` if it fails.
    fn xdotool(&self, arguments: &[&str]) -> Option<String> {
        let mut command = Command::new("xdotool");
        let output = command.args(arguments).env("DISPLAY", &self.name).output().unwrap();
        let answer = String::from_utf8(output.stdout).unwrap();
        output.status.success().then(|| answer.trim().to_owned())
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// Asks until there is an answer, with a limit that only what hangs would reach.
pub(crate) fn wait<T>(mut ask: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(start.elapsed() < Duration::from_mins(2), "there is no answer");
        sleep(Duration::from_millis(50));
    }
}
