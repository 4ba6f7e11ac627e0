//! Rectangles.

use super::{LEAST, is_far};
use crate::precise::difference;
use crate::shape::even_pdf;
use crate::{Quad, SurfaceSite, Vec2, Vec3};
use std::f64::consts::TAU;
use traylib_math::AreaPdf;

/// A rectangle seen from a point in front of it: its sides are arcs of great circles.
///
/// Ureña, Fajardo and King, *An Area-Preserving Parametrization for Spherical Rectangles*,
/// 2013, with the angles at the corners as complex numbers of any length, so that one
/// arc tangent does for four arc cosines.
pub(crate) struct SphericalRectangle {
    /// The two ends of the first edge, with the viewpoint in the origin.
    x: [f64; 2],
    /// The two numbers of the second edge.
    y: [f64; 2],
    /// From the viewpoint to the plane.
    height: f64,
    /// The angles at the two corners where the first edge begins, added up, as a complex
    /// number.
    at_start: Complex,
    /// In steradians.
    solid_angle: f64,
}

/// Real and imaginary part.
type Complex = [f64; 2];

fn product([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

impl SphericalRectangle {
    /// Returns the front as `from` sees it; `None` of what is not a rectangle, where the view is
    /// too narrow to be parted evenly, and where sampling by area is as good.
    #[inline]
    pub(crate) fn seen(quad: &Quad, from: Vec3) -> Option<Self> {
        let [along, aside] = quad.edges();
        let squares = along.length_squared() + aside.length_squared();
        let centre = (quad.corner() - from) + 0.5 * (along + aside);
        if is_far(squares, centre) { None } else { Self::seen_near(quad, from) }
    }

    /// Makes it of what is near: apart, so that the question costs little.
    #[inline(never)]
    fn seen_near(quad: &Quad, from: Vec3) -> Option<Self> {
        let corner = difference(quad.corner(), from);
        let [along, aside] = quad.edges().map(Vec3::as_dvec3);
        let height = -corner.dot(quad.across());
        if height <= 0.0 {
            return None;
        }
        let [length, breadth] = quad.rectangle_lengths()?;
        let (x, y) = (corner.dot(along) / length, corner.dot(aside) / breadth);
        Self::new([x, x + length], [y, y + breadth], height / (length * breadth))
    }

    fn new(x: [f64; 2], y: [f64; 2], height: f64) -> Option<Self> {
        // The cosine of an angle is minus the product of the normals of its sides, the sine
        // the length of their cross product; both times the same.
        let square = height * height;
        let sine = |i: usize, j: usize| height * (x[i] * x[i] + y[j] * y[j] + square).sqrt();
        let at_start = product([x[0] * y[1], sine(0, 1)], [-x[0] * y[0], sine(0, 0)]);
        let at_end = product([x[1] * y[0], sine(1, 0)], [-x[1] * y[1], sine(1, 1)]);
        // Their sum is more than a full turn by the solid angle.
        let [cosine, sine] = product(at_start, at_end);
        let excess = sine.atan2(cosine);
        // Where it is nearly nothing it may be nearly a full turn as well.
        if excess.abs() < LEAST || excess.is_nan() {
            return None;
        }
        let solid_angle = if excess < 0.0 { excess + TAU } else { excess };
        Some(Self { x, y, height, at_start, solid_angle })
    }

    /// A point of what `from` sees, uniform in solid angle, and its density; `None` where
    /// a parallelogram is not sampled so.
    pub(crate) fn sample_site(quad: &Quad, from: Vec3, u: Vec2) -> Option<(SurfaceSite, AreaPdf)> {
        let seen = Self::seen(quad, from)?;
        let at = seen.sample(u);
        let site = quad.site(at.x, at.y);
        Some((site, even_pdf(seen.solid_angle(), from, site.position, site.normal)))
    }

    /// In steradians.
    pub(crate) fn solid_angle(&self) -> f32 {
        self.solid_angle as f32
    }

    /// Coordinates along the edges of a point that is uniform in solid angle.
    pub(crate) fn sample(&self, u: Vec2) -> Vec2 {
        let along = self.first(f64::from(u.x));
        let aside = self.second(along, f64::from(u.y));
        let part = |value: f64, [start, end]: [f64; 2]| ((value - start) / (end - start)) as f32;
        Vec2::new(part(along, self.x), part(aside, self.y)).clamp(Vec2::ZERO, Vec2::ONE)
    }

    /// Returns the place on the first edge that has this part of the solid angle behind it.
    fn first(&self, part: f64) -> f64 {
        let Self { x: [start, end], y: [y0, y1], height, at_start, .. } = *self;
        // The two angles at a rectangle's other end that ends there.
        let (sine, cosine) = (part * self.solid_angle).sin_cos();
        let [cosine, sine] = product([cosine, sine], [at_start[0], -at_start[1]]);
        // Their f_u, as a fraction.
        let square = height * height;
        let over = -(cosine * y0 + (start * start + square) * (y0 * y0 + square) * y1);
        let below = (over * over - square * sine * sine).max(0.0);
        let at = height * sine * ((y0 * y0 + square) / below).sqrt();
        // Rounding leads to beyond the ends, and divides zero by zero there.
        (at * over.signum()).max(start).min(end)
    }

    /// Returns the place across, this far along, that has this part of the arc behind it.
    fn second(&self, along: f64, part: f64) -> f64 {
        let [start, end] = self.y;
        let square = along * along + self.height * self.height;
        let sine = |y: f64| y / (y * y + square).sqrt();
        let sine = sine(start) + part * (sine(end) - sine(start));
        let at = sine * (square / (1.0 - sine * sine).max(0.0)).sqrt();
        at.max(start).min(end)
    }
}
