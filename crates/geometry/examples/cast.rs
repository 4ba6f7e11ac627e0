//! Casts a grid of rays at a mesh, and says how many hit and which hit was nearest.
//!
//!     cargo run --release --example cast [FILE.obj]
//!
//! Of the file, only `v` and `f` lines are read; without one the mesh is a pyramid.
#![allow(clippy::print_stdout, reason = "a program speaks to its user")]

use std::error::Error;
use traylib_geometry::{Bvh, Mesh, Ray, Vec3};

const PYRAMID: &str = "
v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1.5 0
f 1 2 3 4\nf 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1";

/// Rays along each side of the grid.
const SIDE: usize = 512;

fn main() -> Result<(), Box<dyn Error>> {
    let text = std::env::args().nth(1).map_or(Ok(PYRAMID.to_owned()), std::fs::read_to_string)?;
    let mesh = parse(&text)?;
    let bvh = Bvh::build(&mesh)?;
    println!("{} triangles, {} bytes of tree", mesh.triangle_count(), bvh.memory());

    let rays = rays_along_z(&mesh);
    let mut hits = vec![None; rays.len()];
    bvh.nearest_each(&rays, &mut hits);
    println!("{} of {} rays hit", hits.iter().flatten().count(), rays.len());
    let both = rays.iter().zip(&hits).filter_map(|(ray, hit)| Some((ray, (*hit)?)));
    if let Some((ray, hit)) = both.min_by(|a, b| a.1.t.total_cmp(&b.1.t)) {
        println!("nearest: triangle {} at {}, t = {}", hit.primitive, ray.at(hit.t), hit.t);
    }
    Ok(())
}

/// A grid of parallel rays that covers the mesh, from outside of it.
fn rays_along_z(mesh: &Mesh) -> Vec<Ray> {
    let low = mesh.positions().iter().copied().reduce(Vec3::min).unwrap_or_default();
    let high = mesh.positions().iter().copied().reduce(Vec3::max).unwrap_or_default();
    let place = |i: usize| (i as f32 + 0.5) / SIDE as f32;
    let ray = |i: usize| {
        let part = Vec3::new(place(i % SIDE), place(i / SIDE), 2.0);
        Ray::new(low + part * (high - low + Vec3::Z), Vec3::NEG_Z)
    };
    (0..SIDE * SIDE).map(ray).collect()
}

/// The mesh of a Wavefront OBJ file; faces of many corners become fans.
fn parse(text: &str) -> Result<Mesh, Box<dyn Error>> {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for (number, line) in (1..).zip(text.lines()) {
        let mut words = line.split_whitespace();
        let read = match words.next() {
            Some("v") => position(words).map(|p| positions.push(p)),
            Some("f") => face(words, positions.len()).map(|f| triangles.extend(fan(&f))),
            _ => Some(()),
        };
        read.ok_or_else(|| format!("line {number} makes no sense: {line}"))?;
    }
    Ok(Mesh::new(positions, triangles)?)
}

fn position<'a>(words: impl Iterator<Item = &'a str>) -> Option<Vec3> {
    let numbers: Vec<f32> = words.take(3).map(str::parse).collect::<Result<_, _>>().ok()?;
    Some(Vec3::from(<[f32; 3]>::try_from(numbers).ok()?))
}

/// Corners are counted from one, or backwards from the last position.
fn face<'a>(words: impl Iterator<Item = &'a str>, positions: usize) -> Option<Vec<u32>> {
    let corner = |word: &str| {
        let index: i64 = word.split('/').next()?.parse().ok()?;
        u32::try_from(if index < 0 { i64::try_from(positions).ok()? + index } else { index - 1 })
            .ok()
    };
    words.map(corner).collect()
}

fn fan(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    corners.windows(2).skip(1).map(|pair| [corners[0], pair[0], pair[1]])
}
