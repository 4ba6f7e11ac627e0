//! Any bytes as a few triangles and rays: trees of every kind find what asking each
//! triangle finds.
#![no_main]

use libfuzzer_sys::fuzz_target;
use traylib_geometry::{
    Bvh, Error, Hit, LeafKind, Mesh, Options, Precision, Quality, Ray, Sides, Triangle, Vec3,
};

const QUALITIES: [Quality; 3] = [Quality::Fast, Quality::Balanced, Quality::Best];
const PRECISIONS: [Precision; 2] = [Precision::Watertight, Precision::Fast];

/// Bytes taken one after the other; zeros when there are no more.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let mut taken = [0; N];
        let count = N.min(self.0.len());
        let (front, rest) = self.0.split_at(count);
        taken[..count].copy_from_slice(front);
        self.0 = rest;
        taken
    }

    fn below(&mut self, limit: usize) -> usize {
        let [byte] = self.take();
        usize::from(byte) % limit
    }

    /// A whole number from −4 to 3 in units of `step`, so that corners meet and planes
    /// coincide; one time in four any number, or none.
    fn number(&mut self, step: f32) -> f32 {
        match self.below(32) {
            pick @ 0..24 => step * ((pick % 8) as f32 - 4.0),
            _ => f32::from_le_bytes(self.take()),
        }
    }

    fn vector(&mut self, step: f32) -> Vec3 {
        Vec3::new(self.number(step), self.number(step), self.number(step))
    }

    /// One, or any power of two of which a square is a number still.
    fn step(&mut self) -> f32 {
        let exponent = self.below(256).saturating_sub(128) as i32;
        2.0_f32.powi(if exponent == 0 { 0 } else { exponent - 64 })
    }

    /// Up to 40 triangles, of which one may name a position that there is not.
    fn mesh(&mut self, step: f32) -> Result<Mesh, Error> {
        let positions: Vec<Vec3> = (0..self.below(41)).map(|_| self.vector(step)).collect();
        let names = positions.len() + usize::from(self.below(64) == 63);
        let count = if names == 0 { 0 } else { self.below(41) };
        let mut name = || self.below(names) as u32;
        let triangles = (0..count).map(|_| [name(), name(), name()]).collect();
        Mesh::new(positions, triangles)
    }

    fn corner(&mut self, mesh: &Mesh) -> Option<Vec3> {
        mesh.positions().get(self.below(64)).copied()
    }

    /// The ray and seven beside it, as a camera casts them.
    fn packet(&mut self, first: Ray) -> [Ray; 8] {
        let apart = self.vector(0.01) * first.direction.abs().max_element();
        std::array::from_fn(|i| Ray { direction: first.direction + i as f32 * apart, ..first })
    }

    /// From anywhere, or on the line through two corners, to anywhere or to a corner.
    fn ray(&mut self, mesh: &Mesh, step: f32) -> Ray {
        let kind = self.below(16);
        let step = if kind < 12 { step } else { self.step() };
        let (origin, direction, factor) = (self.vector(step), self.vector(step), self.number(1.0));
        let t_max = if kind & 1 == 0 { f32::INFINITY } else { factor };
        let (to, by) = (self.corner(mesh), self.corner(mesh).filter(|_| kind & 4 == 0));
        let on_line = to.zip(by).map(|(to, by)| to + factor * (by - to));
        let origin = on_line.unwrap_or(origin);
        let to = to.filter(|_| kind & 2 == 0);
        Ray { origin, direction: to.map_or(direction, |to| to - origin), t_max }
    }
}

/// The bits of a hit, which has no coordinates where the edge functions overflow.
type Bits = Option<(f32, u32, u32, u32)>;

fn bits(hit: Option<Hit>) -> Bits {
    hit.map(|Hit { t, primitive, u, v }| (t, primitive, u.to_bits(), v.to_bits()))
}

/// One by one, all, and many at a time: the answers of a tree agree. The nearest hits.
fn answers<C: LeafKind>(bvh: &Bvh<C>, rays: &[Ray]) -> Vec<Bits> {
    let (mut nearest, mut any) = (vec![None; rays.len()], vec![false; rays.len()]);
    bvh.nearest_each(rays, &mut nearest);
    bvh.any_hit_each(rays, &mut any);
    let check = |((ray, &nearest), &any): ((&Ray, &Option<Hit>), &bool)| {
        let hit = bits(bvh.nearest(ray));
        assert_eq!(hit, bits(bvh.all_hits(ray).first().copied()), "{ray:?}");
        assert_eq!(hit, bits(nearest), "{ray:?}");
        assert_eq!((hit.is_some(), hit.is_some()), (bvh.any_hit(ray), any), "{ray:?}");
        assert!(hit.is_none_or(|(t, ..)| 0.0 < t && t < ray.t_max), "{ray:?}");
        hit
    };
    rays.iter().zip(&nearest).zip(&any).map(check).collect()
}

/// The triangles that have an area, with their numbers.
fn triangles(mesh: &Mesh) -> Vec<(u32, Triangle)> {
    let numbered = |i: u32| Some((i, mesh.triangle(i as usize)?));
    (0..mesh.triangle_count() as u32).filter_map(numbered).collect()
}

/// What a tree must find, by asking every triangle: of ties, the first in the list.
fn asked_each(triangles: &[(u32, Triangle)], ray: &Ray) -> Bits {
    let hits = triangles.iter().filter_map(|&(primitive, triangle)| {
        let hit = triangle.intersect(ray, Sides::Both)?;
        Some(Hit { t: hit.t, primitive, u: hit.u, v: hit.v })
    });
    bits(hits.min_by(|a, b| a.t.total_cmp(&b.t)))
}

fuzz_target!(|bytes: &[u8]| {
    let mut bytes = Bytes(bytes);
    let step = bytes.step();
    let Ok(mesh) = bytes.mesh(step) else { return };
    let mut rays: Vec<Ray> = (0..bytes.below(13)).map(|_| bytes.ray(&mesh, step)).collect();
    for i in 0..bytes.below(3).min(rays.len()) {
        // Before the others, since they are taken by eight.
        rays.splice(..0, bytes.packet(rays[i]));
    }
    let triangles = triangles(&mesh);
    let expected: Vec<Bits> = rays.iter().map(|ray| asked_each(&triangles, ray)).collect();
    for precision in PRECISIONS {
        for quality in QUALITIES {
            let bvh = Bvh::build_with(&mesh, Options { quality, precision }).expect("few enough");
            let hits = answers(&bvh, &rays);
            if precision == Precision::Watertight {
                for ((hit, expected), ray) in hits.iter().zip(&expected).zip(&rays) {
                    assert_eq!(hit, expected, "{ray:?} {quality:?}");
                }
            }
        }
    }
    let listed: Vec<Triangle> = triangles.iter().map(|t| t.1).collect();
    let hits = answers(&Bvh::of_shapes(listed).expect("sound triangles"), &rays);
    for ((hit, expected), ray) in hits.iter().zip(&expected).zip(&rays) {
        let numbered = hit.map(|(t, i, u, v)| (t, triangles[i as usize].0, u, v));
        assert_eq!(numbered, *expected, "{ray:?}");
    }
});
