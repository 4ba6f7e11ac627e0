//! Shapes that meet: no ray passes between them.

use super::*;

/// A decimal number, as files have them.
fn decimal(random: &mut Random) -> f32 {
    (200.0 * random.number()).round() * 0.05 - 5.0
}

/// The six sides of a box, each from its own corner and edges as somebody writes them:
/// the far corners are sums that round.
fn sides_of_box(min: Vec3, max: Vec3) -> Vec<Primitive> {
    let size = max - min;
    let [x, y, z] = Vec3::AXES.map(|axis| axis * size);
    let far = |axis: Vec3| min + axis * (max - min);
    [
        (min, y, z),
        (Vec3::new(max.x, min.y, min.z), y, z),
        (min, x, z),
        (Vec3::new(max.x, max.y, min.z), -x, z),
        (min, x, y),
        (far(Vec3::Z), x, y),
    ]
    .map(|(corner, u, v)| Primitive::Quad(Quad::new(corner, u, v).unwrap()))
    .to_vec()
}

/// The side of a can and its two ends.
fn can(from: Vec3, to: Vec3, radius: f32) -> Vec<Primitive> {
    let axis = to - from;
    let side = Cone::new([from, to], [radius; 2], Facing::Outward).map(Primitive::Cone);
    let end = |at, normal| Disk::new(at, normal, radius).map(Primitive::Disk);
    [side, end(from, -axis), end(to, axis)].map(Result::unwrap).to_vec()
}

/// A point of an edge or a corner of a box.
fn on_an_edge(min: Vec3, max: Vec3, random: &mut Random) -> Vec3 {
    let along = (4.0 * random.number()) as usize;
    let mut end = || if random.number() < 0.5 { 0.0 } else { 1.0 };
    let mut share = Vec3::new(end(), end(), end());
    if along < 3 {
        share[along] = random.number();
    }
    min + share * (max - min)
}

/// Tells whether a ray passes through the box, up to a ten millionth of its size: judged by where
/// it is between the planes of each axis, in double precision.
fn passes(ray: &Ray, min: Vec3, max: Vec3) -> bool {
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let smaller = (max - min).as_dvec3() * 1e-7;
    let one = (min.as_dvec3() + smaller - origin) / direction;
    let other = (max.as_dvec3() - smaller - origin) / direction;
    let (enter, leave) = (one.min(other).max_element(), one.max(other).min_element());
    enter < leave && enter > 0.0
}

fn is_met(shapes: &[Primitive], ray: &Ray) -> bool {
    shapes.iter().any(|shape| shape.intersect(ray, Sides::Both).is_some())
}

#[test]
fn boxes_are_closed() {
    let mut random = Random::new(31);
    let mut passed = 0;
    for _ in 0..100_000 {
        let [a, b] = [(); 2].map(|()| Vec3::from_array([(); 3].map(|()| decimal(&mut random))));
        let (min, max) = (a.min(b), a.max(b));
        if (max - min).min_element() < 0.1 {
            continue;
        }
        let shapes = sides_of_box(min, max);
        let edge = on_an_edge(min, max, &mut random);
        // Beside an edge, from far and near and along the sides.
        let from = edge + random.magnitude(1e3) * random.direction();
        let ray = Ray::new(from, edge - from);
        if passes(&ray, min, max) {
            passed += 1;
            assert!(is_met(&shapes, &ray), "from outside: {min} {max} {ray:?}");
        }
        let inside = min + (max - min) * (0.5 + 0.49 * random.point());
        let ray = Ray::new(inside, edge - inside);
        assert!(is_met(&shapes, &ray), "from inside: {min} {max} {ray:?}");
    }
    assert!(passed > 10_000, "{passed}");
}

#[test]
fn cans_are_closed() {
    let mut random = Random::new(32);
    for _ in 0..100_000 {
        let (from, axis) = (5.0 * random.point(), random.direction());
        let (length, radius) = (0.5 + random.number(), 0.1 + random.number());
        let to = from + length * axis;
        let shapes = can(from, to, radius);
        let aside = axis.cross(random.direction()).normalize();
        let inside = from.lerp(to, 0.1 + 0.8 * random.number());
        let ray = Ray::new(inside, from + radius * aside - inside);
        assert!(is_met(&shapes, &ray), "{from} {to} {radius} {ray:?}");
    }
}

/// A row of tiles as somebody writes it: corners and edges are decimal numbers, and the
/// end of one is not to the bit the beginning of the next.
#[test]
fn tiles_leave_no_gap() {
    let mut random = Random::new(33);
    for edge in [0.1_f32, 0.3, 0.7] {
        let corner = |i: u16| Vec3::X * (f64::from(i) * f64::from(edge) * 1e6).round() as f32 / 1e6;
        let tile = |i: u16| Quad::new(corner(i), edge * Vec3::X, Vec3::Y).map(Primitive::Quad);
        for i in 0..60 {
            let tiles = [tile(i).unwrap(), tile(i + 1).unwrap()];
            for _ in 0..2000 {
                let from = corner(i + 1) + Vec3::new(random.number(), random.number(), 1.0);
                let to = corner(i + 1) + 0.5 * Vec3::Y;
                // Rounded, so that it passes beside the corner.
                let ray = Ray::new(from, (0.5 + random.number()) * (to - from));
                assert!(is_met(&tiles, &ray), "{edge} {i} {ray:?}");
            }
        }
    }
}
