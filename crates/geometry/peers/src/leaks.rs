//! Rays from inside of a closed mesh, aimed at its corners and edges: none may get out.

use crate::contestant::{Contestant, Found};
use crate::support::ball;
use std::error::Error;

/// The numbers of rays that got through.
pub(crate) struct Leaks {
    pub(crate) name: &'static str,
    pub(crate) rays: usize,
    /// Leaks of rays asked for the nearest hit.
    pub(crate) nearest: usize,
    /// Leaks of rays asked for any hit.
    pub(crate) any_hit: usize,
}

pub(crate) fn count(contestants: &[Contestant], rays: usize) -> Result<Vec<Leaks>, Box<dyn Error>> {
    let mesh = ball::lumpy_ball()?;
    let rays = ball::rays_at_seams(&mesh, rays);
    let mut leaks = Vec::new();
    for contestant in contestants {
        let mut built = contestant.build(&mesh)?;
        let (mut found, mut any) = (vec![Found::NOTHING; rays.len()], vec![false; rays.len()]);
        built.nearest(&rays, &mut found);
        built.any_hit(&rays, &mut any);
        leaks.push(Leaks {
            name: contestant.name,
            rays: rays.len(),
            nearest: found.iter().filter(|found| **found == Found::NOTHING).count(),
            any_hit: any.iter().filter(|hit| !**hit).count(),
        });
    }
    Ok(leaks)
}
