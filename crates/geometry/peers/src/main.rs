//! The same rays in the same rooms, by this crate and by its peers: how fast, how
//! often wrong, how tight, how soon built, how large.

mod clock;
mod contest;
mod contestant;
mod heap;
mod leaks;
mod options;
mod reference;
mod statistics;
#[path = "../../benches/support/support.rs"]
mod support;
mod table;

use clap::Parser;
use contestant::Contestant;
use options::{Options, RoomSize};
use std::error::Error;
use std::process::ExitCode;
use support::room::Room;

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let contestants = contestant::chosen(options);
    println!("{}", how_compiled());
    if !options.without_leaks {
        table::print_leaks(&leaks::count(&contestants, options.seam_rays)?);
    }
    for size in &options.rooms {
        let room = make_room(*size)?;
        println!("\n## {} room, {} triangles", room.name, room.mesh.triangle_count());
        measure(&room, &contestants, options)?;
    }
    Ok(())
}

fn make_room(size: RoomSize) -> Result<Room, traylib_geometry::Error> {
    match size {
        RoomSize::Small => Room::small(),
        RoomSize::Medium => Room::medium(),
        RoomSize::Large => Room::large(),
    }
}

fn measure(room: &Room, contestants: &[Contestant], options: &Options) -> Result<(), String> {
    let (mut entries, builds) = contest::build_all(&room.mesh, contestants)?;
    table::print_builds(&builds, room.mesh.triangle_count());
    for set in contest::ray_sets(room, options.side) {
        let scores = contest::run(&mut entries, &set, options.runs);
        table::print_scores(&set, &scores, options.runs);
    }
    Ok(())
}

/// Some libraries choose their instructions when they are compiled.
fn how_compiled() -> String {
    let has = |name, it| if it { format!(" {name}") } else { String::new() };
    format!(
        "compiled for {}{}{}; queries on one thread",
        std::env::consts::ARCH,
        has("avx2", cfg!(target_feature = "avx2")),
        has("fma", cfg!(target_feature = "fma")),
    )
}
