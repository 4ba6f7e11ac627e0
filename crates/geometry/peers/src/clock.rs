//! Time that the processor worked for us: what others do on the machine is not in it.
#![allow(unsafe_code, reason = "the clocks are functions of the C library")]

/// Seconds that this thread has worked, from some moment on.
pub(crate) fn thread_seconds() -> f64 {
    seconds(libc::CLOCK_THREAD_CPUTIME_ID)
}

/// Seconds that all threads of this process have worked, added up.
pub(crate) fn process_seconds() -> f64 {
    seconds(libc::CLOCK_PROCESS_CPUTIME_ID)
}

fn seconds(clock: libc::clockid_t) -> f64 {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: the pointer is to a live value; both clocks exist wherever this compiles.
    unsafe { libc::clock_gettime(clock, &raw mut time) };
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_takes_time_and_sleep_does_not() {
        let start = thread_seconds();
        std::thread::sleep(std::time::Duration::from_millis(100));
        let asleep = thread_seconds() - start;
        while thread_seconds() - start < 0.01 {}
        assert!(asleep < 0.05, "{asleep} s");
        assert!(process_seconds() >= 0.01);
    }
}
