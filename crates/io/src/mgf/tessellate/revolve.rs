//! Surfaces of revolution as bands of quads.

use crate::mgf::Vertex;
use std::f64::consts::TAU;
use traylib_math::glam::DVec3;

/// The axis that a profile turns about.
pub(super) struct Axis {
    /// The point at which heights begin.
    pub(super) base: DVec3,
    /// The direction of the axis, of length one.
    pub(super) direction: DVec3,
    /// True if fronts and normals are turned inside out.
    pub(super) inward: bool,
}

/// A circle of a surface of revolution.
#[derive(Clone, Copy)]
pub(super) struct Rim {
    pub(super) radius: f64,
    pub(super) height: f64,
    /// The normal there, away from the axis and along it.
    pub(super) normal: [f64; 2],
}

impl Axis {
    /// Bands between each rim and the next. The surface's outside is to the
    /// right of a profile that goes up.
    pub(super) fn revolve(&self, profile: &[Rim], divisions: u32) -> Vec<Vec<Vertex>> {
        let sides = 4 * divisions;
        let directions: Vec<DVec3> = (0..2 * sides).map(|half| self.around(half, sides)).collect();
        let bands = profile.iter().zip(profile.iter().skip(1));
        let quad = |(low, high), side: u32| {
            let at = |half: u32| directions[(half % (2 * sides)) as usize];
            self.quad(low, high, [at(2 * side), at(2 * side + 1), at(2 * side + 2)])
        };
        bands
            .flat_map(|band| (0..sides).map(move |side| (band, side)))
            .map(|(b, s)| quad(b, s))
            .collect()
    }

    /// A direction away from the axis, counted in halves of a side.
    fn around(&self, half: u32, sides: u32) -> DVec3 {
        let u = perpendicular(self.direction);
        let v = self.direction.cross(u);
        let (sin, cos) = (TAU * f64::from(half) / f64::from(2 * sides)).sin_cos();
        u * cos + v * sin
    }

    /// Between two rims and two directions; a triangle where a rim is a point,
    /// with the normal halfway there.
    fn quad(&self, low: &Rim, high: &Rim, [from, middle, to]: [DVec3; 3]) -> Vec<Vertex> {
        let mut corners = Vec::with_capacity(4);
        for (rim, pair) in [(low, [from, to]), (high, [to, from])] {
            if rim.radius == 0.0 {
                corners.push(self.vertex(rim, middle));
            } else {
                corners.extend(pair.map(|away| self.vertex(rim, away)));
            }
        }
        if self.inward {
            corners.reverse();
        }
        corners
    }

    fn vertex(&self, rim: &Rim, away: DVec3) -> Vertex {
        let place = away * rim.radius + self.direction * rim.height;
        let normal = (away * rim.normal[0] + self.direction * rim.normal[1]).normalize_or_zero();
        let normal = if self.inward { -normal } else { normal };
        Vertex { position: self.base + place, normal: Some(normal) }
    }
}

/// A direction across another one, in the plane of two coordinates.
fn perpendicular(direction: DVec3) -> DVec3 {
    let small = direction.to_array().into_iter().position(|part| part.abs() < 0.6);
    let mut axis = DVec3::ZERO;
    axis[small.unwrap_or(0)] = 1.0;
    axis.cross(direction).normalize_or_zero()
}
