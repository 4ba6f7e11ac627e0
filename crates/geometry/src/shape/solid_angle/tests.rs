use crate::precise::DVec3;
use crate::testing::Random;
use crate::testing::shape::{distance, scaled};
use crate::{Form, Primitive, Quad, Triangle, Vec2, Vec3};
use std::f64::consts::{PI, TAU};

fn rectangle(corner: Vec3, u: Vec3, v: Vec3) -> Primitive {
    Primitive::Quad(Quad::new(corner, u, v).unwrap())
}

fn triangle(a: Vec3, b: Vec3, c: Vec3) -> Primitive {
    Primitive::Triangle(Triangle::new(a, b, c).unwrap())
}

/// The unit square that faces down at height one, and the triangle that is half of it.
fn square_and_half() -> [Primitive; 2] {
    [
        rectangle(Vec3::Z, Vec3::Y, Vec3::X),
        triangle(Vec3::Z, Vec3::new(0.0, 1.0, 1.0), Vec3::new(1.0, 0.0, 1.0)),
    ]
}

/// One over the density per steradian.
fn solid_angle(shape: &Primitive, from: Vec3) -> f64 {
    let (site, pdf) = shape.sample_toward(from, Vec2::new(0.4, 0.3));
    let back = (from - site.position).as_dvec3();
    let cosine = site.normal.as_dvec3().dot(back) / back.length();
    cosine / back.length_squared() / f64::from(pdf.0)
}

/// Tells whether a point is drawn by solid angle, which is then known to be `expected`.
fn sees(shape: &Primitive, from: Vec3, expected: f64) -> bool {
    (solid_angle(shape, from) / expected - 1.0).abs() < 1e-5
}

/// A side of a cube fills a sixth of all directions from its middle, and a quarter of that from
/// a corner: a half of it each triangle.
#[test]
fn solid_angles_of_a_cube() {
    let [square, half] = square_and_half();
    assert!(sees(&square, Vec3::new(0.5, 0.5, 0.5), 4.0 * PI / 6.0));
    assert!(sees(&square, Vec3::ZERO, PI / 6.0));
    // tan(Ω/2) = V/(1 + Σ cos), V = 1/√(2·2), two cosines 1/√2, one 1/2.
    assert!(sees(&half, Vec3::ZERO, 2.0 * (0.5_f64).atan2(1.5 + 2.0_f64.sqrt())));
}

/// The corners in order around a flat shape, from the viewpoint.
fn corners(shape: &Primitive, from: Vec3) -> Vec<DVec3> {
    let corners = match shape.form() {
        Form::Flat { outline, .. } => outline.corners(),
        Form::Ball(_) | Form::Bent(_) => Vec::new(),
    };
    corners.into_iter().map(|corner| corner.as_dvec3() - from.as_dvec3()).collect()
}

/// The solid angle of the polygon with these corners: the angles at them, less what they were
/// in a plane (Girard).
fn excess(corners: &[DVec3]) -> f64 {
    let n = corners.len();
    let angle = |i: usize| {
        let [before, here, after] = [i + n - 1, i, i + 1].map(|i| corners[i % n]);
        let sides = [before, after].map(|side| here.cross(side));
        sides[0].cross(sides[1]).length().atan2(sides[0].dot(sides[1]))
    };
    (0..n).map(angle).sum::<f64>() - (n - 2) as f64 * PI
}

/// The integral of the unit direction over a polygon: Lambert's formula, ½·Σ θ·n over its
/// sides, θ their angles and n their unit normals inward.
fn mean_direction(corners: &[DVec3]) -> DVec3 {
    let side = |i: usize| {
        let (one, other) = (corners[i], corners[(i + 1) % corners.len()]);
        let across = other.cross(one);
        across.normalize() * across.length().atan2(one.dot(other))
    };
    0.5 * (0..corners.len()).map(side).sum::<DVec3>() / excess(corners)
}

/// Rectangles and triangles, each with a place in front of it, from a millionth of its size
/// away to that: of middling shapes, of slivers, over the middle, an edge and a
/// corner, and beside.
fn views() -> Vec<(Primitive, Vec3)> {
    let mut random = Random::new(11);
    let mut views = Vec::new();
    for i in 0..300 {
        let along = random.direction();
        let slim = if i % 3 == 0 { random.magnitude(1e3) } else { 1.0 };
        let aside = along.cross(random.direction()).normalize() / slim.max(1.0 / slim);
        let skew = aside + 0.8 * random.number() * along;
        let corner = random.point();
        let shapes =
            [rectangle(corner, along, aside), triangle(corner, corner + along, corner + skew)];
        for shape in shapes {
            let normal = shape.normals().axis;
            let at = shape.sample_area(random.square()).position;
            let place = [at, corner, corner + 0.3 * along, at + 1.2 * along][i % 4];
            let height = [1e-6, 1e-4, 1e-2, 0.3, 1.0][i / 4 % 5];
            views.push((shape, place + height * normal));
        }
    }
    views
}

/// The middles of an n × n grid.
fn grid(n: u16) -> impl Iterator<Item = Vec2> {
    let middle = move |i: u16| (f32::from(i) + 0.5) / f32::from(n);
    (0..n * n).map(move |i| Vec2::new(middle(i % n), middle(i / n)))
}

/// The density is one over the solid angle by another formula, and the directions that are
/// drawn have the mean of all.
#[test]
fn directions_are_uniform() {
    let mut by_area = 0;
    for (shape, from) in views() {
        let corners = corners(&shape, from);
        let exact = excess(&corners);
        if shape.sample_toward(from, Vec2::ZERO).1.0 == 1.0 / shape.area() {
            by_area += 1;
            continue;
        }
        let directions = grid(80).map(|u| {
            let (site, pdf) = shape.sample_toward(from, u);
            assert_eq!(pdf, shape.pdf_toward(from, site.position, site.normal));
            let back = (from - site.position).as_dvec3();
            -back.normalize()
        });
        let mean = directions.sum::<DVec3>() / (80.0 * 80.0);
        let off = (mean - mean_direction(&corners)).length();
        // The grid is no finer, and next to the lamp places round by a part of their distance.
        let slack = 2e-3 + 1e-7 / distance(&shape, from);
        assert!(off < slack, "{shape:?} from {from}: {mean}, off by {off}; {exact} sr");
    }
    // Of six hundred views; slivers are further away than they are wide more often.
    assert!(by_area < 150, "{by_area}");
}

/// The part of the square with `u.x` under a number maps to that part of the solid angle: the
/// rectangle behind the point, or the triangle between the first corner, the second and the place
/// where the line from the first through the point leaves.
#[test]
fn the_first_number_parts_the_solid_angle() {
    let mut random = Random::new(12);
    for (shape, from) in views() {
        if shape.sample_toward(from, Vec2::ZERO).1.0 == 1.0 / shape.area() {
            continue;
        }
        let u = random.square();
        let Vec2 { x, y } = shape.coordinates_toward(from, u);
        let part = |corners: &[DVec3], x: f64, y: f64| match *corners {
            [a, b, c] => vec![a, b, b + (c - b) * (y / (x + y))],
            [a, b, c, d] => vec![a, a + (b - a) * x, d + (c - d) * x, d],
            _ => Vec::new(),
        };
        let whole = corners(&shape, from);
        let found = excess(&part(&whole, f64::from(x), f64::from(y))) / excess(&whole);
        let off = (found - f64::from(u.x)).abs();
        // By what the coordinates round.
        let slack = 1e-5 + 1e-7 / distance(&shape, from);
        assert!(off < slack, "{shape:?} from {from} {u}: {found}");
    }
}

/// The light of a point over its density is bounded however near and slanting the view is: by the
/// solid angle, no more than a hemisphere.
#[test]
fn light_over_density_is_the_solid_angle() {
    for (shape, from) in views() {
        if shape.sample_toward(from, Vec2::ZERO).1.0 == 1.0 / shape.area() {
            continue;
        }
        let exact = excess(&corners(&shape, from));
        for u in grid(8) {
            let (site, pdf) = shape.sample_toward(from, u);
            let back = from - site.position;
            let cosine = site.normal.dot(back) / back.length();
            // Rounding can turn a point away that is next to the viewpoint's foot.
            if pdf.0 > 0.0 {
                let found = f64::from(cosine / back.length_squared() / pdf.0);
                // Edges are at right angles up to rounding, which counts next to them.
                let slack = 1e-4 + 2e-7 / distance(&shape, from);
                let off = (found / exact - 1.0).abs();
                assert!(off < slack, "{shape:?} from {from}: {found}, {exact}");
                assert!(found < TAU * 1.0001);
            }
        }
    }
}

/// Behind, in the plane and far away points are drawn by area.
#[test]
fn what_is_not_in_front_and_near_is_sampled_by_area() {
    for shape in square_and_half() {
        let places = [
            Vec3::new(0.2, 0.3, 1.5),
            Vec3::new(0.2, 0.3, 1.0),
            Vec3::new(3.0, 0.3, 1.0),
            Vec3::new(0.2, 0.3, -1e6),
            Vec3::new(0.2, 0.3, -0.9),
        ];
        for from in places {
            assert_eq!(shape.sample_toward(from, Vec2::ZERO).1.0, 1.0 / shape.area(), "{from}");
        }
        let near = shape.sample_toward(Vec3::new(0.2, 0.3, -0.3), Vec2::ZERO);
        assert_ne!(near.1.0, 1.0 / shape.area());
    }
}

/// Scaled by a power of two a view is the same, to the last bit.
#[test]
fn scale_changes_no_bit() {
    let mut random = Random::new(13);
    for (shape, from) in views() {
        let u = random.square();
        let (site, pdf) = shape.sample_toward(from, u);
        for scale in [2_f32.powi(-20), 2_f32.powi(20)] {
            let scaled = scaled(&shape, scale);
            let (other, other_pdf) = scaled.sample_toward(from * scale, u);
            assert_eq!(other.position, site.position * scale);
            assert_eq!(other_pdf.0 * (scale * scale), pdf.0);
        }
    }
}
