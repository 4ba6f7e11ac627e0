//! Measures the memory that a piece of work takes.

use peak_alloc::PeakAlloc;

/// Counts the bytes of every program that this crate is part of.
#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

/// Does the work; also tells the most bytes it held at a time, beside what was held
/// before.
pub fn peak_during<T>(work: impl FnOnce() -> T) -> (T, u64) {
    HEAP.reset_peak_usage();
    let before = HEAP.current_usage();
    let result = work();
    (result, HEAP.peak_usage().saturating_sub(before) as u64)
}

/// Does the work; also tells the bytes that its result holds.
pub fn held_by<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let before = HEAP.current_usage();
    let result = work();
    (result, HEAP.current_usage().saturating_sub(before) as u64)
}
