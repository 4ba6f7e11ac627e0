//! Asking for memory before it is needed.

#![allow(unsafe_code)]

/// Bytes that memory moves at once.
const LINE: usize = 64;

/// Asks for all lines of a value; does nothing on machines other than x86-64.
#[inline(always)]
pub(crate) fn prefetch<T>(value: &T) {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    for offset in (0..size_of::<T>()).step_by(LINE) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: prefetching changes nothing and fails at no address.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(value).byte_add(offset).cast()) };
    }
    #[cfg(any(not(target_arch = "x86_64"), miri))]
    let _ = (value, LINE);
}
