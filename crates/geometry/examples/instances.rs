//! Forty equal chairs, stored once: what that saves, and how a hit is told apart.
//!
//!     cargo run --example instances
#![allow(clippy::print_stdout, reason = "a program speaks to its user")]

use std::error::Error;
use std::f32::consts::TAU;
use std::sync::Arc;
use traylib_geometry::glam::{Affine3A, BVec3, Quat};
use traylib_geometry::{Bvh, Instance, Mesh, Ray, Vec3};

fn main() -> Result<(), Box<dyn Error>> {
    let chair = chair()?;
    let one = Arc::new(Bvh::build(&chair)?);
    let chairs: Result<_, _> = places().map(|at| Instance::new(one.clone(), at)).collect();
    let room = Bvh::of_instances(chairs?)?;
    let copied = Bvh::build(&copies(&chair)?)?;
    println!("one chair:             {:7} bytes", one.memory());
    println!("forty, stored once:    {:7} bytes and the chair", room.memory());
    println!("forty, copied:         {:7} bytes", copied.memory());

    let eye = Vec3::new(3.5, 4.0, -2.0);
    for at in places().step_by(13) {
        let seat = at.transform_point3(Vec3::new(0.1, 0.46, 0.2));
        let ray = Ray::new(eye, seat - eye);
        let Some(hit) = room.nearest(&ray) else { continue };
        // Copies are numbered one after the other, here as there.
        assert_eq!(copied.nearest(&ray).map(|hit| hit.primitive), Some(hit.primitive));
        let Some((instance, triangle)) = room.locate(hit.primitive) else { continue };
        println!("triangle {triangle} of chair {instance}, at {}", ray.at(hit.t));
    }
    Ok(())
}

/// Five rows of eight, each turned a little further.
fn places() -> impl Iterator<Item = Affine3A> {
    (0..40).map(|i| {
        let place = Vec3::new((i % 8) as f32, 0.0, (i / 8) as f32);
        Affine3A::from_rotation_translation(Quat::from_rotation_y(TAU / 40.0 * i as f32), place)
    })
}

/// A seat, a back and four legs: boxes between two corners.
fn chair() -> Result<Mesh, Box<dyn Error>> {
    let legs = [0.0, 0.4].map(|x| [0.0, 0.4].map(|z| ([x, 0.0, z], [x + 0.04, 0.42, z + 0.04])));
    let rest = [([0.0, 0.42, 0.0], [0.44, 0.46, 0.44]), ([0.0, 0.46, 0.0], [0.44, 0.9, 0.03])];
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for (low, high) in legs.into_iter().flatten().chain(rest) {
        let first = positions.len() as u32;
        let mask = |i| BVec3::new(i & 1 != 0, i & 2 != 0, i & 4 != 0);
        positions.extend((0..8).map(|i| Vec3::select(mask(i), high.into(), low.into())));
        // Faces by the bits of their corners: x 1, y 2, z 4.
        for [a, b, c, d] in
            [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
        {
            triangles.extend([[a, b, c], [a, c, d]].map(|t| t.map(|i| first + i)));
        }
    }
    Ok(Mesh::new(positions, triangles)?)
}

/// All chairs as one mesh, for comparison.
fn copies(chair: &Mesh) -> Result<Mesh, Box<dyn Error>> {
    let moved = |at: Affine3A| chair.positions().iter().map(move |&p| at.transform_point3(p));
    let corners = chair.positions().len() as u32;
    let shifted = |i: u32| chair.triangles().iter().map(move |t| t.map(|c| c + i * corners));
    Ok(Mesh::new(places().flat_map(moved).collect(), (0..40).flat_map(shifted).collect())?)
}
