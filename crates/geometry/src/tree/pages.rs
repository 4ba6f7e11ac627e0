//! Large arrays on large pages of memory, so that rays that jump about in them need
//! not look up so many addresses.

#![allow(unsafe_code)]

use std::alloc::{Layout, alloc, dealloc, handle_alloc_error};
use std::ops::Deref;
use std::ptr::NonNull;

/// A large page of x86-64 and of most other machines.
const PAGE: usize = 2 << 20;

/// A list that does not change, on large pages when it is large.
pub(crate) enum Pages<T> {
    Small(Vec<T>),
    Large(Large<T>),
}

/// A list on pages of its own.
pub(crate) struct Large<T> {
    start: NonNull<T>,
    len: usize,
    layout: Layout,
}

impl<T: Copy> Pages<T> {
    pub(crate) fn new(list: Vec<T>) -> Self {
        let bytes = size_of_val(&*list);
        let layout = Layout::from_size_align(bytes.next_multiple_of(PAGE), PAGE);
        match layout {
            Ok(layout) if bytes >= PAGE => Self::Large(Large::new(&list, layout)),
            _ => Self::Small(list),
        }
    }
}

impl<T: Copy> Large<T> {
    /// A copy of `list`, which the layout, of one page or more, has room for.
    fn new(list: &[T], layout: Layout) -> Self {
        const { assert!(align_of::<T>() <= PAGE) };
        // SAFETY: the layout is that of at least one page.
        let Some(start) = NonNull::new(unsafe { alloc(layout) }) else {
            handle_alloc_error(layout)
        };
        advise(start, layout.size());
        let start = start.cast::<T>();
        // SAFETY: the new memory is as long as the list, aligned to a page, and
        // nobody else's; what is copied may be.
        unsafe { start.copy_from_nonoverlapping(NonNull::from(list).cast(), list.len()) };
        Self { start, len: list.len(), layout }
    }
}

/// Asks for large pages. Nothing depends on whether they are given.
#[cfg(all(target_os = "linux", not(miri)))]
fn advise(start: NonNull<u8>, bytes: usize) {
    use std::ffi::{c_int, c_void};
    unsafe extern "C" {
        fn madvise(start: *mut c_void, bytes: usize, advice: c_int) -> c_int;
    }
    const HUGE: c_int = 14;
    // SAFETY: the range is whole pages of memory of ours; the advice changes
    // nothing that can be read from it.
    unsafe { madvise(start.as_ptr().cast(), bytes, HUGE) };
}

#[cfg(any(not(target_os = "linux"), miri))]
fn advise(_: NonNull<u8>, _: usize) {}

impl<T> Deref for Pages<T> {
    type Target = [T];

    #[inline(always)]
    fn deref(&self) -> &[T] {
        match self {
            Self::Small(list) => list,
            // SAFETY: so many were written at the start, and nobody changes them.
            Self::Large(large) => unsafe {
                std::slice::from_raw_parts(large.start.as_ptr(), large.len)
            },
        }
    }
}

impl<T> Drop for Large<T> {
    fn drop(&mut self) {
        // SAFETY: it was allocated with this layout; what can be copied needs no drop.
        unsafe { dealloc(self.start.as_ptr().cast(), self.layout) };
    }
}

// SAFETY: it owns its list, as a vector does.
unsafe impl<T: Send> Send for Large<T> {}
// SAFETY: as above.
unsafe impl<T: Sync> Sync for Large<T> {}

impl<T: Copy> Clone for Pages<T> {
    fn clone(&self) -> Self {
        Self::new(self.to_vec())
    }
}

impl<T: std::fmt::Debug> std::fmt::Debug for Pages<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 4096 bytes each, so that 512 fill a large page.
    fn list(count: u32) -> Vec<[u32; 1024]> {
        (0..count).map(|i| [i; 1024]).collect()
    }

    #[test]
    fn lists_are_kept_as_they_are() {
        for count in [0, 1, 511, 512, 513, 1025] {
            let pages = Pages::new(list(count));
            assert_eq!(matches!(pages, Pages::Large(_)), count >= 512);
            assert!(pages[..] == list(count)[..], "{count}");
        }
    }

    #[test]
    fn large_lists_begin_on_a_page_and_outlive_what_they_were_cloned_from() {
        let pages = Pages::new(list(513));
        let clone = pages.clone();
        assert_ne!(pages.as_ptr(), clone.as_ptr());
        drop(pages);
        assert!(clone.as_ptr().addr().is_multiple_of(PAGE));
        let sum = std::thread::spawn(move || clone.iter().map(|row| row[1023]).sum::<u32>());
        assert_eq!(sum.join().ok(), Some(513 * 256));
    }
}
