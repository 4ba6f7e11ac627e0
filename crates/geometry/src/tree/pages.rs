//! Large lists on large pages of memory, so that rays that jump about in them need not
//! look up so many addresses, nor a builder wait for so many pages.

#![allow(unsafe_code)]

use std::mem::MaybeUninit;

/// A large page of x86-64 and of most other machines.
const PAGE: usize = 2 << 20;

/// An empty list with room for so many; what fills whole large pages is on such.
pub(crate) fn room<T>(count: usize) -> Vec<T> {
    let mut list = Vec::with_capacity(count);
    advise(list.spare_capacity_mut());
    list
}

/// Asks for large pages. Nothing depends on whether they are given.
#[cfg(all(target_os = "linux", not(miri)))]
fn advise<T>(room: &mut [MaybeUninit<T>]) {
    use std::ffi::{c_int, c_void};
    unsafe extern "C" {
        fn madvise(start: *mut c_void, bytes: usize, advice: c_int) -> c_int;
    }
    const HUGE: c_int = 14;
    let start = room.as_mut_ptr().cast::<u8>();
    let before = start.align_offset(PAGE);
    let bytes = size_of_val(room).saturating_sub(before) / PAGE * PAGE;
    if bytes > 0 {
        // SAFETY: the range is whole pages of memory of ours; the advice changes nothing
        // that can be read from it.
        unsafe { madvise(start.wrapping_add(before).cast(), bytes, HUGE) };
    }
}

#[cfg(any(not(target_os = "linux"), miri))]
fn advise<T>(_: &mut [MaybeUninit<T>]) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_is_room_for_few_and_many() {
        for count in [0, 1, PAGE / 4, PAGE] {
            let mut list = room::<u32>(count);
            assert!(list.is_empty() && list.capacity() >= count);
            let start = list.as_ptr();
            list.extend(0..count as u32);
            assert_eq!(
                (list.as_ptr(), list.last().copied()),
                (start, (count as u32).checked_sub(1))
            );
        }
    }
}
