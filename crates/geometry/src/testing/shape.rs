//! The knowledge that tests have of shapes: forms of each kind to draw from, and what is true of
//! them by plain formulas in double precision. Matches in full, so that a new shape is tested.

use crate::precise::{DVec3, difference};
use crate::{Cone, Disk, Error, Facing, Primitive, Quad, Ray, Sphere, SurfaceSite, Triangle, Vec3};
use traylib_math::glam::DVec2;

/// Directions and sizes at a place, of which shapes are made.
pub(crate) struct Measures {
    pub(crate) centre: Vec3,
    pub(crate) along: Vec3,
    pub(crate) aside: Vec3,
    pub(crate) radius: f32,
    /// In 0..1.
    pub(crate) part: f32,
    pub(crate) facing: Facing,
}

impl Measures {
    /// Makes of every kind one form or more; an error where rounding leaves nothing of it.
    pub(crate) fn forms(&self) -> Vec<Result<Primitive, Error>> {
        let mut forms = Vec::new();
        let mut kind = example_after(None);
        while let Some(example) = kind {
            forms.extend(self.forms_like(&example));
            kind = example_after(Some(&example));
        }
        forms
    }

    /// The forms of one kind.
    fn forms_like(&self, example: &Primitive) -> Vec<Result<Primitive, Error>> {
        let &Self { centre, along, aside, radius, part, facing } = self;
        match example {
            Primitive::Triangle(_) => {
                vec![Triangle::new(centre, centre + along, centre + aside).map(Primitive::Triangle)]
            }
            Primitive::Quad(_) => {
                // The second in a coordinate plane, as walls are.
                let edges = [[along, aside], [along.x * Vec3::X, aside.z * Vec3::Z]];
                edges.map(|[u, v]| Quad::new(centre, u, v).map(Primitive::Quad)).to_vec()
            }
            Primitive::Sphere(_) => {
                vec![Sphere::new(centre, radius, facing).map(Primitive::Sphere)]
            }
            Primitive::Disk(_) => [0.0, part * radius]
                .map(|inner| Disk::ring(centre, along, inner, radius).map(Primitive::Disk))
                .to_vec(),
            Primitive::Cone(_) => {
                // The last with its tip; as a sliver, almost flat.
                let forms = [
                    (along, [radius, radius]),
                    (along, [part * radius, radius]),
                    (aside, [0.5 * part, 0.0]),
                ];
                let cone = |(to, radii)| Cone::new([centre, centre + to], radii, facing);
                forms.map(|form| cone(form).map(Primitive::Cone)).to_vec()
            }
        }
    }
}

/// A shape of the first kind, or of the one after the last; none after the last of all. A
/// new kind has to find its place here.
fn example_after(last: Option<&Primitive>) -> Option<Primitive> {
    let (o, x, y) = (Vec3::ZERO, Vec3::X, Vec3::Y);
    let example = match last {
        None => Triangle::new(o, x, y).map(Primitive::Triangle),
        Some(Primitive::Triangle(_)) => Quad::new(o, x, y).map(Primitive::Quad),
        Some(Primitive::Quad(_)) => Sphere::new(o, 1.0, Facing::Outward).map(Primitive::Sphere),
        Some(Primitive::Sphere(_)) => Disk::new(o, x, 1.0).map(Primitive::Disk),
        Some(Primitive::Disk(_)) => {
            Cone::new([o, x], [1.0, 1.0], Facing::Outward).map(Primitive::Cone)
        }
        Some(Primitive::Cone(_)) => return None,
    };
    Some(example.unwrap())
}

/// The shape this much larger.
pub(crate) fn scaled(shape: &Primitive, scale: f32) -> Primitive {
    match shape {
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners().map(|p| p * scale);
            Primitive::Triangle(Triangle::new(a, b, c).unwrap())
        }
        Primitive::Quad(quad) => {
            let [u, v] = quad.edges().map(|e| e * scale);
            Primitive::Quad(Quad::new(quad.corner() * scale, u, v).unwrap())
        }
        Primitive::Sphere(s) => Primitive::Sphere(
            Sphere::new(s.centre() * scale, s.radius() * scale, s.facing()).unwrap(),
        ),
        Primitive::Disk(d) => {
            let [inner, outer] = [d.inner_radius(), d.radius()].map(|r| r * scale);
            Primitive::Disk(Disk::ring(d.centre() * scale, d.normal(), inner, outer).unwrap())
        }
        Primitive::Cone(c) => {
            let (ends, radii) = (c.ends().map(|p| p * scale), c.radii().map(|r| r * scale));
            Primitive::Cone(Cone::new(ends, radii, c.facing()).unwrap())
        }
    }
}

/// Tells whether a site is within a ten thousandth of an edge or a rim.
pub(crate) fn on_border(shape: &Primitive, site: &SurfaceSite) -> bool {
    let beside = |from: Vec3, along: Vec3| {
        (site.position - from).cross(along).length() < 1e-4 * along.length()
    };
    match shape {
        Primitive::Quad(quad) => {
            let (corner, [u, v]) = (quad.corner(), quad.edges());
            beside(corner, u) || beside(corner, v) || beside(corner + u, v) || beside(corner + v, u)
        }
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners();
            beside(a, b - a) || beside(b, c - b) || beside(c, a - c)
        }
        Primitive::Sphere(_) => false,
        Primitive::Disk(disk) => {
            let away = site.position.distance(disk.centre());
            [disk.radius(), disk.inner_radius()].iter().any(|r| (away - r).abs() < 1e-4)
        }
        // A rim is where its sphere around the end meets the surface.
        Primitive::Cone(cone) => {
            let [one, other] = cone.ends();
            let across = |end: Vec3, to: Vec3| (site.position - end).dot((to - end).normalize());
            across(one, other) < 1e-4 || across(other, one) < 1e-4
        }
    }
}

/// Tells whether a ray that leaves a site into the hemisphere of `normal` must not meet the shape
/// again: all but those into a sphere or a cone.
pub(crate) fn is_final(shape: &Primitive, side: f32) -> bool {
    match shape {
        Primitive::Sphere(sphere) => is_outside(sphere.facing(), side),
        Primitive::Cone(cone) => is_outside(cone.facing(), side),
        Primitive::Triangle(_) | Primitive::Quad(_) | Primitive::Disk(_) => true,
    }
}

fn is_outside(facing: Facing, side: f32) -> bool {
    (facing == Facing::Outward) == side.is_sign_positive()
}

/// From the surface, in double precision.
pub(crate) fn distance(shape: &Primitive, point: Vec3) -> f64 {
    let plane = |origin: Vec3, normal: DVec3| {
        (difference(point, origin).dot(normal) / normal.length()).abs()
    };
    match shape {
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.corners();
            plane(a, difference(b, a).cross(difference(c, a)))
        }
        Primitive::Quad(quad) => {
            let [u, v] = quad.edges().map(Vec3::as_dvec3);
            plane(quad.corner(), u.cross(v))
        }
        Primitive::Disk(disk) => plane(disk.centre(), disk.normal().as_dvec3()),
        Primitive::Sphere(sphere) => {
            let away = difference(point, sphere.centre()).length();
            (away - f64::from(sphere.radius())).abs()
        }
        Primitive::Cone(cone) => distance_to_cone(cone, point),
    }
}

/// From the line that the surface is in a half plane of the axis.
fn distance_to_cone(cone: &Cone, point: Vec3) -> f64 {
    let ([one, other], [first, last]) = (cone.ends(), cone.radii().map(f64::from));
    let axis = difference(other, one);
    let from_one = difference(point, one);
    let aside = from_one.cross(axis).length() / axis.length();
    let side = DVec2::new(axis.length(), last - first);
    let in_plane = DVec2::new(from_one.dot(axis) / axis.length(), aside - first);
    (side.perp_dot(in_plane) / side.length()).abs()
}

/// A ray without end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub(crate) origin: DVec3,
    pub(crate) direction: DVec3,
}

impl Line {
    pub(crate) fn of(ray: &Ray) -> Self {
        Self { origin: ray.origin.as_dvec3(), direction: ray.direction.as_dvec3() }
    }

    /// Returns the line from where it comes near to a point, and how far along that is: of an
    /// f32 ray without rounding.
    pub(crate) fn near(&self, point: DVec3) -> (f64, Self) {
        let along = (point - self.origin).dot(self.direction) / self.direction.length_squared();
        let along = f64::from(along as f32);
        (along, Self { origin: self.origin + along * self.direction, ..*self })
    }
}

/// Returns its thickness where it is thinnest, seen from anywhere but its edge.
pub(crate) fn thickness(shape: &Primitive) -> f64 {
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

/// Returns the crossings of a line with the surface that a shape is a part of: each t, and whether
/// the shape is there.
pub(crate) fn crossings(shape: &Primitive, line: &Line) -> Vec<(f64, bool)> {
    match shape {
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
    }
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

/// Solves a t² + 2 b t + c = 0; not numbers where there are none.
fn roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let sum = -(b + (b * b - a * c).sqrt().copysign(b));
    [sum / a, c / sum]
}
