//! Instructions a ray and a triangle: `cargo xtask count-instructions` runs this
//! under valgrind, one case a run, which counts inside of [`counted_by_valgrind`].
//!
//! Without a case it lists them, one a line. With one it does the work and says on
//! how many rays or triangles.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks to its user")]

#[path = "support/support.rs"]
mod support;

use std::hint::black_box;
use std::process::ExitCode;
use support::rays::RaySets;
use support::room::Room;
use traylib_geometry::{Bvh, Error, Options, Precision, Quality, Ray};

type MakeRoom = fn() -> Result<Room, Error>;

/// Without the large room, which takes minutes under valgrind.
const ROOMS: [(&str, MakeRoom); 2] = [("small", Room::small), ("medium", Room::medium)];

/// A picture of this many pixels squared: enough for a mean over the room.
const SIDE: u32 = 64;

#[derive(Clone, Copy)]
enum Task {
    Build(Quality),
    Nearest(Precision, fn(&RaySets) -> &[Ray]),
    NearestEach(fn(&RaySets) -> &[Ray]),
    AnyHit(fn(&RaySets) -> &[Ray]),
}

const TASKS: [(&str, Task); 9] = [
    ("build-fast", Task::Build(Quality::Fast)),
    ("build-balanced", Task::Build(Quality::Balanced)),
    ("build-best", Task::Build(Quality::Best)),
    ("primary", Task::Nearest(Precision::Watertight, |sets| &sets.primary)),
    ("primary-batch", Task::NearestEach(|sets| &sets.primary)),
    ("bounces", Task::Nearest(Precision::Watertight, |sets| &sets.bounces)),
    ("bounces-fast", Task::Nearest(Precision::Fast, |sets| &sets.bounces)),
    ("bounces-batch", Task::NearestEach(|sets| &sets.bounces)),
    ("shadow", Task::AnyHit(|sets| &sets.shadow)),
];

/// Does the work that is counted: `cargo xtask count-instructions` names this function to valgrind.
#[inline(never)]
fn counted_by_valgrind<T>(work: impl FnOnce() -> T) -> T {
    black_box(work())
}

/// Does the task; how many rays or triangles it was done on.
fn run(task: Task, room: &Room) -> Result<String, Error> {
    match task {
        Task::Build(quality) => {
            let options = Options { quality, ..Options::default() };
            counted_by_valgrind(|| Bvh::build_with(&room.mesh, options))?;
            Ok(format!("{} triangles", room.mesh.triangle_count()))
        }
        Task::Nearest(precision, set) => cast(room, precision, set, |bvh, rays| {
            counted_by_valgrind(|| rays.iter().filter_map(|ray| bvh.nearest(ray)).count());
        }),
        Task::NearestEach(set) => cast(room, Precision::Watertight, set, |bvh, rays| {
            let mut hits = vec![None; rays.len()];
            counted_by_valgrind(|| bvh.nearest_each(rays, &mut hits));
        }),
        Task::AnyHit(set) => cast(room, Precision::Watertight, set, |bvh, rays| {
            counted_by_valgrind(|| rays.iter().filter(|ray| bvh.any_hit(ray)).count());
        }),
    }
}

fn cast(
    room: &Room,
    precision: Precision,
    set: fn(&RaySets) -> &[Ray],
    work: impl FnOnce(&Bvh, &[Ray]),
) -> Result<String, Error> {
    let bvh = Bvh::build_with(&room.mesh, Options { precision, ..Options::default() })?;
    let sets = RaySets::new(room, SIDE, |ray| bvh.nearest(ray).map(|hit| (hit.t, hit.primitive)));
    let rays = set(&sets);
    work(&bvh, rays);
    Ok(format!("{} rays", rays.len()))
}

fn cases() -> impl Iterator<Item = (String, MakeRoom, Task)> {
    ROOMS.into_iter().flat_map(|(room, make)| {
        TASKS.into_iter().map(move |(name, task)| (format!("{room}/{name}"), make, task))
    })
}

fn main() -> ExitCode {
    // Cargo adds an option of its own, `--bench`.
    let Some(wanted) = std::env::args().skip(1).find(|word| !word.starts_with('-')) else {
        cases().for_each(|(name, ..)| println!("{name}"));
        return ExitCode::SUCCESS;
    };
    let Some((_, make, task)) = cases().find(|(name, ..)| *name == wanted) else {
        eprintln!("error: no case is named `{wanted}`");
        return ExitCode::from(2);
    };
    match make().and_then(|room| run(task, &room)) {
        Ok(done) => {
            println!("{done}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
