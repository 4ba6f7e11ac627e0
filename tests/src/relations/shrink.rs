//! Smaller scenes that break the same relation.

mod simpler;

use crate::relations::scene::DrawnScene;
use std::time::{Duration, Instant};

/// The simplest scene that was found in this time, going from one that is broken to
/// a simpler one that still is, until none is.
pub fn shrink(
    scene: &DrawnScene,
    time: Duration,
    mut is_broken: impl FnMut(&DrawnScene) -> bool,
) -> DrawnScene {
    let start = Instant::now();
    let mut smallest = scene.clone();
    loop {
        let mut found = false;
        let (mut number, mut simpler) = (0, simpler::than(&smallest));
        while let Some(candidate) = simpler.get(number) {
            if start.elapsed() > time {
                return smallest;
            }
            if is_broken(candidate) {
                smallest = candidate.clone();
                // What was tried before this one was in vain, and is not tried again
                // in this round.
                simpler = simpler::than(&smallest);
                found = true;
            } else {
                number += 1;
            }
        }
        if !found {
            return smallest;
        }
    }
}
