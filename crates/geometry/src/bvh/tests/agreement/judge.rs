//! Where a line meets a shape, by the formulas of a textbook in double precision, and
//! whether that is certain.

use crate::{Cone, Disk, Primitive, Ray, Sphere, Vec3};
use traylib_math::glam::DVec3;

/// A ray without end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) origin: DVec3,
    pub(super) direction: DVec3,
}

impl Line {
    pub(super) fn of(ray: &Ray) -> Self {
        Self { origin: ray.origin.as_dvec3(), direction: ray.direction.as_dvec3() }
    }

    /// The same line from where it comes near to a point, and how far along that is: of an
    /// f32 ray without rounding.
    fn near(&self, point: DVec3) -> (f64, Self) {
        let along = (point - self.origin).dot(self.direction) / self.direction.length_squared();
        let along = f64::from(along as f32);
        (along, Self { origin: self.origin + along * self.direction, ..*self })
    }
}

/// What is certain of a line and a shape.
#[derive(Clone, Copy, Debug)]
pub(super) enum Verdict {
    /// They meet at t, give or take.
    Hit { t: f64, within: f64 },
    /// They do not.
    Miss,
    /// Rounding may decide.
    Unsure,
}

/// Certain is what all lines have in common around one: as far away as `noise`, and as what
/// double precision may round by, and as a thousandth of the shape's thickness.
pub(super) fn verdict(shape: &Primitive, line: &Line, noise: f64) -> Verdict {
    let bounds = shape.bounds();
    let (size, thickness) = (f64::from(bounds.extent().length()), thickness(shape));
    let (ahead, line) = line.near(bounds.centre().as_dvec3());
    let speed = line.direction.length();
    let distance = ahead.abs() * speed + line.origin.length();
    let f32_filter = noise + 16.0 * f64::EPSILON * distance;
    let aside = f32_filter + 1e-3 * thickness + 16.0 * f64::from(f32::EPSILON) * reach(shape);
    if aside > 0.2 * thickness {
        return Verdict::Unsure;
    }
    let found: Vec<Option<f64>> =
        beams(&line, aside).iter().map(|beam| first(shape, beam, -ahead)).collect();
    let hits: Vec<f64> = found.iter().flatten().copied().collect();
    if hits.is_empty() {
        // A shape that is not behind the line's start may just so be.
        let behind = beams(&line, aside).iter().any(|beam| first(shape, beam, f64::MIN).is_some());
        return if behind { Verdict::Unsure } else { Verdict::Miss };
    }
    let (least, most) = hits.iter().fold((f64::MAX, f64::MIN), |(a, b), t| (a.min(*t), b.max(*t)));
    let spread = most - least;
    let t = ahead + f64::midpoint(least, most);
    let within = spread + 4.0 * f64::from(f32::EPSILON) * t.abs() + 4.0 * f32_filter / speed;
    let lost = hits.len() < found.len();
    if lost || spread * speed > 0.1 * size || t < 4.0 * within {
        return Verdict::Unsure;
    }
    Verdict::Hit { t, within }
}

/// A line and eight around it.
fn beams(line: &Line, aside: f64) -> Vec<Line> {
    let x = line.direction.any_orthogonal_vector().normalize() * aside;
    let y = line.direction.normalize().cross(x);
    let turns = (0..8).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_4);
    let offsets = turns.map(|turn| turn.cos() * x + turn.sin() * y);
    let moved = |offset| Line { origin: line.origin + offset, ..*line };
    [DVec3::ZERO].into_iter().chain(offsets).map(moved).collect()
}

/// The largest coordinate.
fn reach(shape: &Primitive) -> f64 {
    let bounds = shape.bounds();
    f64::from(bounds.min.abs().max(bounds.max.abs()).max_element())
}

/// How thick it is where it is thinnest, seen from anywhere but its edge.
fn thickness(shape: &Primitive) -> f64 {
    let height = |u: Vec3, v: Vec3| {
        let (u, v) = (u.as_dvec3(), v.as_dvec3());
        u.cross(v).length() / u.length().max(v.length()).max((u - v).length())
    };
    match shape {
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners();
            height(b - a, c - a)
        }
        Primitive::Quad(quad) => height(quad.edges()[0], quad.edges()[1]),
        Primitive::Sphere(ball) => f64::from(ball.radius()),
        Primitive::Disk(disk) => f64::from(disk.radius() - disk.inner_radius()),
        Primitive::Cone(cone) => {
            let length = f64::from(cone.ends()[0].distance(cone.ends()[1]));
            let [one, other] = cone.radii().map(f64::from);
            length.hypot(one - other).min(one.max(other))
        }
    }
}

/// The first t above `from` at which a line meets a shape.
fn first(shape: &Primitive, line: &Line, from: f64) -> Option<f64> {
    let all = match shape {
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners().map(Vec3::as_dvec3);
            let [t, u, v] = flat(line, a, b - a, c - a);
            vec![(t, u >= 0.0 && v >= 0.0 && u + v <= 1.0)]
        }
        Primitive::Quad(quad) => {
            let [u, v] = quad.edges().map(Vec3::as_dvec3);
            let [t, u, v] = flat(line, quad.corner().as_dvec3(), u, v);
            vec![(t, (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v))]
        }
        Primitive::Sphere(ball) => sphere(line, ball),
        Primitive::Disk(disk) => disk_at(line, disk),
        Primitive::Cone(cone) => cone_at(line, cone),
    };
    all.into_iter().filter(|&(t, is_there)| is_there && t > from).map(|(t, _)| t).reduce(f64::min)
}

/// t and the coordinates along two edges, by Cramer's rule.
fn flat(line: &Line, corner: DVec3, u: DVec3, v: DVec3) -> [f64; 3] {
    let (normal, from_corner) = (u.cross(v), line.origin - corner);
    let t = -from_corner.dot(normal) / line.direction.dot(normal);
    let place = from_corner + t * line.direction;
    let square = normal.length_squared();
    [t, place.cross(v).dot(normal) / square, u.cross(place).dot(normal) / square]
}

fn sphere(line: &Line, ball: &Sphere) -> Vec<(f64, bool)> {
    let from_centre = line.origin - ball.centre().as_dvec3();
    let radius = f64::from(ball.radius());
    roots(
        line.direction.length_squared(),
        from_centre.dot(line.direction),
        from_centre.length_squared() - radius * radius,
    )
    .map(|t| (t, true))
    .to_vec()
}

fn disk_at(line: &Line, disk: &Disk) -> Vec<(f64, bool)> {
    let (normal, from_centre) = (disk.normal().as_dvec3(), line.origin - disk.centre().as_dvec3());
    let t = -from_centre.dot(normal) / line.direction.dot(normal);
    let distance = (from_centre + t * line.direction).length();
    let radii = f64::from(disk.inner_radius())..=f64::from(disk.radius());
    vec![(t, radii.contains(&distance))]
}

fn cone_at(line: &Line, cone: &Cone) -> Vec<(f64, bool)> {
    let [start, end] = cone.ends().map(Vec3::as_dvec3);
    let [first, last] = cone.radii().map(f64::from);
    let axis = end - start;
    let height = |v: DVec3| v.dot(axis) / axis.length_squared();
    let from_start = line.origin - start;
    let (p, q) =
        (from_start - height(from_start) * axis, line.direction - height(line.direction) * axis);
    let radius = first + height(from_start) * (last - first);
    let growth = height(line.direction) * (last - first);
    let at = |t: f64| (t, (0.0..=1.0).contains(&height(from_start + t * line.direction)));
    roots(
        q.length_squared() - growth * growth,
        p.dot(q) - radius * growth,
        p.length_squared() - radius * radius,
    )
    .map(at)
    .to_vec()
}

/// Of a t² + 2 b t + c; not numbers where there are none.
fn roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let sum = -(b + (b * b - a * c).sqrt().copysign(b));
    [sum / a, c / sum]
}
