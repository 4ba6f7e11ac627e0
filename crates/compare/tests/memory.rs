//! Tests of the memory that work is found to take. All bytes of the process are counted, so this is
//! the only test of its program.

#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

use clap::Parser;
use std::hint::black_box;
use traylib_compare::memory::{held_by, peak_during};
use traylib_compare::options::Options;
use traylib_compare::prepare::prepare;

const BYTES: u64 = 1 << 22;

fn buffer() -> Vec<u8> {
    // Or else what is not looked at is not made.
    black_box(vec![1; BYTES as usize])
}

/// The bytes that the thread that waits for the test may take or give back meanwhile.
const OTHERS: u64 = BYTES / 16;

#[test]
fn what_is_held_and_what_was_held_is_counted() {
    let (left, peak) = peak_during(|| buffer().len() as u64);
    assert_eq!(left, BYTES);
    assert!(peak.abs_diff(BYTES) < OTHERS, "{peak}");

    let (_, bytes) = held_by(|| buffer().len());
    assert!(bytes < OTHERS, "{bytes}");
    let (kept, bytes) = held_by(buffer);
    assert!(bytes.abs_diff(kept.len() as u64) < OTHERS, "{bytes}");

    let scene = prepare("cornell", &Options::parse_from(["x", "--quick"])).unwrap();
    assert!(scene.bytes > 0);
}
