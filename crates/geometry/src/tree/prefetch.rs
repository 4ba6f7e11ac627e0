//! Asking for memory before it is needed.

#![allow(unsafe_code)]

/// Bytes that memory moves at once.
const LINE: usize = 64;

/// Asks for the lines of `size` bytes; does nothing on machines other than x86-64.
#[inline(always)]
pub(crate) fn prefetch(start: *const u8, size: usize) {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    for offset in (0..size).step_by(LINE) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: prefetching changes nothing and fails at no address.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(start.wrapping_add(offset).cast()) };
    }
    #[cfg(any(not(target_arch = "x86_64"), miri))]
    let _ = (start, size, LINE);
}
