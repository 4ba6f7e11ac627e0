//! Time and memory of a piece of work, where the system tells.

use std::fs;
use std::time::Instant;

/// Begins to measure.
pub(crate) struct Measure {
    start: Instant,
    worked: Option<f64>,
}

impl Measure {
    pub(crate) fn start() -> Self {
        // Makes the peak what is held now; without effect elsewhere than on Linux.
        let _ = fs::write("/proc/self/clear_refs", "5");
        Self { start: Instant::now(), worked: cpu_seconds() }
    }

    /// Seconds that this thread has worked, whatever else the machine did; elapsed ones
    /// where the system does not say.
    pub(crate) fn seconds(&self) -> f64 {
        let worked = cpu_seconds().zip(self.worked).map(|(now, then)| now - then);
        worked.unwrap_or_else(|| self.start.elapsed().as_secs_f64())
    }
}

fn cpu_seconds() -> Option<f64> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(text.split(' ').next()?.parse::<f64>().ok()? * 1e-9)
}

/// The most memory that this process has held since the last start, in KiB; 0 where the
/// system does not say.
pub(crate) fn peak_kib() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.trim().trim_end_matches(" kB").parse().ok()).unwrap_or(0)
}
