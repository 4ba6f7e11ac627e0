//! Shapes of several kinds in the unit cube, and rays there.

use traylib_geometry::{Cone, Facing, Primitive, Quad, Ray, SidedPrimitive, Sides, Sphere, Vec3};
use traylib_math::{Sampler, warp};

/// Five walls, a lamp, two blocks' tops and six balls.
pub(crate) fn box_with_balls() -> Vec<SidedPrimitive> {
    let quad = |corner: [f32; 3], u: [f32; 3], v: [f32; 3]| {
        Quad::new(corner.into(), u.into(), v.into()).map(Primitive::Quad).ok()
    };
    let walls = [
        quad([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]),
        quad([0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        quad([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        quad([0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        quad([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        quad([0.4, 0.99, 0.4], [0.2, 0.0, 0.0], [0.0, 0.0, 0.2]),
        quad([0.1, 0.3, 0.1], [0.1, 0.0, 0.3], [0.3, 0.0, -0.1]),
        quad([0.6, 0.5, 0.2], [-0.1, 0.0, 0.2], [0.3, 0.0, 0.1]),
    ];
    let ball = |i: u8| {
        let x = 0.15 + 0.14 * f32::from(i);
        let centre = Vec3::new(x, 0.1 + 0.3 * (x * 7.0).sin().abs(), 0.6 + 0.3 * (x * 5.0).sin());
        Sphere::new(centre, 0.08, Facing::Outward).map(Primitive::Sphere).ok()
    };
    let primitives = walls.into_iter().chain((0..6).map(ball)).flatten();
    primitives.map(|primitive| SidedPrimitive { primitive, sides: Sides::Both }).collect()
}

/// Columns that grow thinner toward their tops, at ten by ten places.
pub(crate) fn hundred_columns() -> Vec<Primitive> {
    let column = |place: Vec3| {
        let ends = [place, place + 0.9 * Vec3::Y];
        Cone::new(ends, [0.02, 0.015], Facing::Outward).map(Primitive::Cone).ok()
    };
    places().filter_map(column).collect()
}

/// Balls at ten by ten places.
pub(crate) fn hundred_balls() -> Vec<Primitive> {
    let ball = |place| Sphere::new(place, 0.04, Facing::Outward).map(Primitive::Sphere).ok();
    places().filter_map(ball).collect()
}

fn places() -> impl Iterator<Item = Vec3> {
    (0..100_u8).map(|i| 0.05 + 0.1 * Vec3::new(f32::from(i % 10), 0.0, f32::from(i / 10)))
}

/// Rays from inside the unit cube in all directions, as bounces are.
pub(crate) fn bounces(count: usize) -> Vec<Ray> {
    let mut origins = Sampler::numbered(1, 0);
    let mut directions = Sampler::numbered(2, 0);
    let mut ray = || Ray::new(point(&mut origins), warp::uniform_sphere(directions.next_2d()));
    (0..count).map(|_| ray()).collect()
}

/// Segments between points in the unit cube, as shadow rays are.
pub(crate) fn segments(count: usize) -> Vec<Ray> {
    let mut points = Sampler::numbered(1, 0);
    (0..count).map(|_| Ray::segment(point(&mut points), point(&mut points))).collect()
}

fn point(sampler: &mut Sampler) -> Vec3 {
    Vec3::new(sampler.next_1d(), sampler.next_1d(), sampler.next_1d())
}
