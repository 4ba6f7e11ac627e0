//! Being asked to stop: Ctrl-C, a closed terminal, a system going down.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A flag that the first request to stop raises; the second stops at once.
///
/// Pictures are written beside their target and renamed, so even that leaves no
/// half of one.
pub fn stop_flag() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let raised = Arc::clone(&stop);
    // Without a handler the system's own way to stop still works.
    let _ = ctrlc::set_handler(move || {
        if raised.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    stop
}
