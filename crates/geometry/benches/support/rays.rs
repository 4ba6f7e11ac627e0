//! The rays of a path tracer in a room.

use super::room::{EYE, LAMP, Room, TARGET};
use traylib_geometry::{Mesh, Ray, Vec3};
use traylib_math::{Sampler, warp};

/// One kind of ray each, as many as the camera's picture has pixels or a few less.
#[derive(Debug)]
pub(crate) struct RaySets {
    /// From the camera, in tiles of 8 × 8 pixels.
    pub(crate) primary: Vec<Ray>,
    /// From where paths were scattered for the second time, in the camera's order.
    pub(crate) bounces: Vec<Ray>,
    /// The rays in random order, as a queue of rays may be.
    pub(crate) shuffled: Vec<Ray>,
    /// From the same points to points of the lamp, its end excluded.
    pub(crate) shadow: Vec<Ray>,
}

/// The hit that a ray found: t and the number of the triangle.
pub(crate) type Found = (f32, u32);

impl RaySets {
    /// Rays in `room` for a square picture of `side` pixels; paths go on where
    /// `nearest` says that they hit.
    pub(crate) fn new(room: &Room, side: u32, nearest: impl Fn(&Ray) -> Option<Found>) -> Self {
        let mut sampler = Sampler::numbered(3, 0);
        let primary = primary(side);
        let mut scatter = |ray: &Ray| {
            let (t, triangle) = nearest(ray)?;
            Some(scattered(&room.mesh, ray, t, triangle, &mut sampler))
        };
        let bounces: Vec<Ray> =
            primary.iter().filter_map(|ray| scatter(ray).and_then(|ray| scatter(&ray))).collect();
        let shadow = bounces.iter().map(|ray| to_lamp(ray.origin, &mut sampler)).collect();
        let shuffled = shuffled(&bounces, &mut sampler);
        Self { primary, bounces, shuffled, shadow }
    }
}

fn primary(side: u32) -> Vec<Ray> {
    const TILE: u32 = 8;
    let forward = (TARGET - EYE).normalize();
    let right = forward.cross(Vec3::Y).normalize();
    let up = right.cross(forward);
    let ray = |x: u32, y: u32| {
        let [x, y] = [x, y].map(|i| (i as f32 + 0.5) / side as f32 - 0.5);
        Ray::new(EYE, (forward + 1.3 * (x * right - y * up)).normalize())
    };
    let tiles = side.div_ceil(TILE);
    let pixel = |i: u32| {
        let (tile, within) = (i / (TILE * TILE), i % (TILE * TILE));
        (tile % tiles * TILE + within % TILE, tile / tiles * TILE + within / TILE)
    };
    let pixels = (0..tiles * tiles * TILE * TILE).map(pixel);
    pixels.filter(|&(x, y)| x < side && y < side).map(|(x, y)| ray(x, y)).collect()
}

/// A ray from where `ray` ended, as a matt surface scatters.
fn scattered(mesh: &Mesh, ray: &Ray, t: f32, triangle: u32, sampler: &mut Sampler) -> Ray {
    let normal = facing_normal(mesh, triangle, ray.direction);
    // A tenth of a millimetre off, so that no library meets the same surface again.
    let origin = ray.at(t) + 1e-4 * normal;
    Ray::new(origin, warp::cosine_hemisphere(normal, sampler.next_2d()))
}

fn facing_normal(mesh: &Mesh, triangle: u32, direction: Vec3) -> Vec3 {
    let [a, b, c] = mesh.triangles()[triangle as usize].map(|i| mesh.positions()[i as usize]);
    let normal = (b - a).cross(c - a).normalize_or(-direction);
    if normal.dot(direction) > 0.0 { -normal } else { normal }
}

fn to_lamp(from: Vec3, sampler: &mut Sampler) -> Ray {
    let [corner, along_u, along_v] = LAMP;
    let place = sampler.next_2d();
    Ray::segment(from, corner + place.x * along_u + place.y * along_v)
}

/// Fisher and Yates's shuffle.
fn shuffled(rays: &[Ray], sampler: &mut Sampler) -> Vec<Ray> {
    let mut rays = rays.to_vec();
    for last in (1..rays.len()).rev() {
        let other = (sampler.next_1d() * (last + 1) as f32) as usize;
        rays.swap(last, other.min(last));
    }
    rays
}
