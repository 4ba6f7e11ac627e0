//! Shapes laid out on the unit square, equal areas alike, and places to see them from.

use glam::DVec3;
use std::f64::consts::{PI, TAU};
use traylib_geometry::{Facing, Primitive, Triangle, Vec3};
use traylib_known::frame::frame;
use traylib_known::grid::At;
use traylib_known::stage::{ball, disk_facing_down, hollow_ball, rectangle, tube};

/// A map from the unit square to a surface that keeps ratios of areas.
#[derive(Clone, Copy, Debug)]
pub struct Chart {
    origin: DVec3,
    /// Two vectors in the plane, or axis and two more of a sphere.
    axes: [DVec3; 3],
    normal_sign: f64,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Quad,
    Triangle,
    Disk,
    /// The part of a sphere around the axis in which the cosine of the angle to
    /// it is at least one less this.
    Cap(f64),
    /// Around the axis, with these radii at its start and end.
    Cone([f64; 2]),
}

impl Chart {
    /// The chart of what is seen of a shape from a point: of a sphere that faces outward
    /// the cap whose rim is at the cosine R/d, of everything else all.
    pub fn seen_from(shape: &Primitive, from: Vec3) -> Self {
        match shape {
            Primitive::Quad(quad) => {
                let [u, v] = quad.edges().map(DVec3::from);
                Self::flat(DVec3::from(quad.corner()), [u, v], Kind::Quad)
            }
            Primitive::Triangle(triangle) => {
                let [a, b, c] = triangle.corners().map(DVec3::from);
                Self::flat(a, [b - a, c - a], Kind::Triangle)
            }
            Primitive::Disk(disk) => {
                let [_, u, v] = frame(DVec3::from(disk.normal()));
                let radius = f64::from(disk.radius());
                Self::flat(DVec3::from(disk.centre()), [u * radius, v * radius], Kind::Disk)
            }
            Primitive::Cone(cone) => {
                let [start, end] = cone.ends().map(DVec3::from);
                let [_, u, v] = frame(end - start);
                let normal_sign = if cone.facing() == Facing::Outward { 1.0 } else { -1.0 };
                let kind = Kind::Cone(cone.radii().map(f64::from));
                Self { origin: start, axes: [end - start, u, v], normal_sign, kind }
            }
            Primitive::Sphere(sphere) => {
                let (centre, radius) = (DVec3::from(sphere.centre()), f64::from(sphere.radius()));
                let away = DVec3::from(from) - centre;
                let axis = if away.length() > 0.0 { away } else { DVec3::Z };
                let (extent, normal_sign) = match sphere.facing() {
                    Facing::Outward if away.length() > radius => {
                        (1.0 - radius / away.length(), 1.0)
                    }
                    Facing::Outward => (2.0, 1.0),
                    Facing::Inward => (2.0, -1.0),
                };
                let axes = frame(axis).map(|axis| axis * radius);
                Self { origin: centre, axes, normal_sign, kind: Kind::Cap(extent) }
            }
        }
    }

    /// The chart of all of a shape.
    pub fn whole(shape: &Primitive) -> Self {
        let bounds = shape.bounds();
        // From the middle of a sphere all of it is seen, and of other shapes from anywhere.
        Self::seen_from(shape, 0.5 * (bounds.min + bounds.max))
    }

    fn flat(origin: DVec3, [u, v]: [DVec3; 2], kind: Kind) -> Self {
        Self { origin, axes: [u.cross(v), u, v], normal_sign: 1.0, kind }
    }

    /// The area of the part of the surface that the square covers.
    pub fn area(&self) -> f64 {
        let parallelogram = self.axes[1].cross(self.axes[2]).length();
        match self.kind {
            Kind::Quad => parallelogram,
            Kind::Triangle => 0.5 * parallelogram,
            Kind::Disk => PI * parallelogram,
            Kind::Cap(extent) => TAU * extent * parallelogram,
            Kind::Cone([r, s]) => PI * (r + s) * self.axes[0].length().hypot(s - r),
        }
    }

    /// The point of the surface that belongs to one of the square, with the unit
    /// normal of the front.
    pub fn point(&self, at: At) -> (DVec3, DVec3) {
        let [up, u, v] = self.axes;
        let (sin, cos) = (at[1] * TAU).sin_cos();
        let from_origin = match self.kind {
            Kind::Quad => u * at[0] + v * at[1],
            Kind::Triangle => (u * (1.0 - at[1]) + v * at[1]) * at[0].sqrt(),
            Kind::Disk => (u * cos + v * sin) * at[0].sqrt(),
            Kind::Cap(extent) => {
                let one_minus_cos = at[0] * extent;
                up * (1.0 - one_minus_cos)
                    + (u * cos + v * sin) * (one_minus_cos * (2.0 - one_minus_cos)).sqrt()
            }
            Kind::Cone([r, s]) => {
                // Area grows with the square of the radius, or along the axis.
                let radius = (r * r + at[0] * (s * s - r * r)).sqrt();
                let along = if r == s { at[0] } else { (radius - r) / (s - r) };
                up * along + (u * cos + v * sin) * radius
            }
        };
        let normal = match self.kind {
            Kind::Cap(_) => from_origin,
            Kind::Cone([r, s]) => u * cos + v * sin - up * ((s - r) / up.length_squared()),
            Kind::Quad | Kind::Triangle | Kind::Disk => up,
        };
        (self.origin + from_origin, normal.normalize() * self.normal_sign)
    }

    /// The point of the square that belongs to one of the surface.
    pub fn coordinates(&self, point: Vec3) -> At {
        let [up, u, v] = self.axes;
        let from_origin = DVec3::from(point) - self.origin;
        let turn = |a: f64, b: f64| b.atan2(a).rem_euclid(TAU) / TAU;
        match self.kind {
            Kind::Quad => in_plane(from_origin, u, v),
            Kind::Triangle => {
                let [x, y] = in_plane(from_origin, u, v);
                // At the first corner it is any.
                let aside = if x + y == 0.0 { 0.0 } else { y / (x + y) };
                [(x + y).powi(2), aside]
            }
            Kind::Disk => {
                let [x, y] = in_plane(from_origin, u, v);
                [x * x + y * y, turn(x, y)]
            }
            Kind::Cap(extent) => {
                // 1 − cos of the angle to the axis, without cancellation.
                let one_minus_cos =
                    0.5 * (from_origin.normalize() - up.normalize()).length().powi(2);
                [one_minus_cos / extent, turn(from_origin.dot(u), from_origin.dot(v))]
            }
            Kind::Cone([r, s]) => {
                let along = from_origin.dot(up) / up.length_squared();
                let radius = r + along * (s - r);
                let share =
                    if r == s { along } else { (radius * radius - r * r) / (s * s - r * r) };
                [share, turn(from_origin.dot(u), from_origin.dot(v))]
            }
        }
    }
}

/// The coefficients of a vector in the plane of two others.
fn in_plane(vector: DVec3, u: DVec3, v: DVec3) -> At {
    let across = u.cross(v);
    let share = |a: DVec3, b: DVec3| a.cross(b).dot(across) / across.dot(across);
    [share(vector, v), share(u, vector)]
}

/// A lamp and where it is seen from.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The name of the view.
    pub name: &'static str,
    /// The lamp.
    pub shape: Primitive,
    /// The point from which it is seen.
    pub from: Vec3,
}

/// Lamps of every shape, seen from afar and from near. A name with "from" in it repeats a shape.
///
/// # Panics
/// If a shape cannot be made.
pub fn views() -> Vec<View> {
    let at = Vec3::new;
    let centre = at(0.4, -0.3, 1.2);
    let corners = [at(0.0, 0.0, 1.0), at(0.1, 2.0, 1.5), at(-1.0, 0.2, 2.0)];
    let [a, b, _] = corners;
    let triangle = triangle_of(corners);
    let thin = triangle_of([a, b, a.lerp(b, 0.4) + 0.01 * Vec3::X]);
    // Facing down, of 1 m × 0.6 m.
    let sheet = rectangle(centre, at(0.8, 0.6, 0.0), at(0.36, -0.48, 0.0));
    let beside = |u: f32, v: f32, height: f32| {
        centre + u * at(0.8, 0.6, 0.0) + v * at(0.36, -0.48, 0.0) + height * Vec3::NEG_Z
    };
    let outside = |distance: f32| centre + distance * at(0.48, 0.6, -0.64);
    let view = |name, shape, from| View { name, shape, from };
    vec![
        view("quad", rectangle(centre, at(0.5, 0.2, 0.0), at(-0.3, 0.4, 0.1)), Vec3::ZERO),
        view("rectangle from far", sheet, beside(0.5, 0.5, 2.0)),
        view("rectangle from near", sheet, beside(0.3, 0.6, 0.25)),
        view("rectangle from its corner", sheet, beside(0.0, 0.0, 0.1)),
        view("rectangle from aside", sheet, beside(-0.2, 0.4, 0.1)),
        view("triangle", triangle, Vec3::ZERO),
        view("triangle from near", triangle, at(0.05, 0.72, 1.45)),
        view("thin triangle from near", thin, at(0.2, 0.8, 1.05)),
        view("tube", tube([centre, at(1.0, 0.1, 2.0)], [0.3, 0.3]), Vec3::ZERO),
        view("cone", tube([centre, at(1.0, 0.1, 2.0)], [0.5, 0.1]), Vec3::ZERO),
        view("disk", disk_facing_down(centre, 0.6), at(0.5, 0.0, 1.1)),
        view("ball from far", ball(centre, 0.5), outside(500.0)),
        view("ball", ball(centre, 0.5), outside(1.3)),
        view("ball from near", ball(centre, 0.5), outside(0.51)),
        view("ball from within", ball(centre, 0.5), outside(0.3)),
        view("hollow ball from within", hollow_ball(centre, 0.5), outside(0.4)),
    ]
}

fn triangle_of([a, b, c]: [Vec3; 3]) -> Primitive {
    Primitive::Triangle(Triangle::new(a, b, c).expect("it has area"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// There and back, and small squares have their share of the area.
    #[test]
    fn charts_keep_areas_and_can_be_undone() {
        let centre = Vec3::new(1.0, -2.0, 0.5);
        let corners = [Vec3::ZERO, Vec3::new(2.0, 0.0, 1.0), Vec3::new(0.5, 1.0, 0.0)];
        let [a, b, c] = corners;
        let triangle = Triangle::new(a, b, c).unwrap();
        for shape in [
            rectangle(centre, b, c),
            Primitive::Triangle(triangle),
            disk_facing_down(centre, 0.7),
            ball(centre, 0.3),
            hollow_ball(centre, 2.0),
            tube([centre, b], [0.3, 0.3]),
            tube([centre, c], [0.5, 0.1]),
        ] {
            let chart = Chart::seen_from(&shape, Vec3::new(0.2, 0.1, 1.0));
            for i in 0..100 {
                let at = [i % 10, i / 10].map(|i| (f64::from(i) + 0.5) / 10.0);
                let (point, normal) = chart.point(at);
                let back = chart.coordinates(point.as_vec3());
                assert!(at.iter().zip(back).all(|(a, b)| (a - b).abs() < 1e-5), "{shape:?}");
                let step = 1e-5;
                let moved = |x, y| chart.point([at[0] + x, at[1] + y]).0;
                let x = (moved(step, 0.0) - moved(-step, 0.0)) * (0.5 / step);
                let y = (moved(0.0, step) - moved(0.0, -step)) * (0.5 / step);
                let across = x.cross(y);
                assert!((across.length() / chart.area() - 1.0).abs() < 1e-6, "{shape:?}");
                assert!(across.normalize().dot(normal).abs() > 1.0 - 1e-6, "{shape:?}");
            }
        }
    }

    #[test]
    fn whole_shapes_have_their_own_area() {
        let cone = tube([Vec3::ZERO, Vec3::ONE], [0.2, 0.5]);
        for shape in [disk_facing_down(Vec3::Z, 0.7), hollow_ball(Vec3::Z, 2.0), cone] {
            let area = Chart::seen_from(&shape, Vec3::ZERO).area();
            assert!((area / f64::from(shape.area()) - 1.0).abs() < 1e-6, "{shape:?}");
        }
    }
}
