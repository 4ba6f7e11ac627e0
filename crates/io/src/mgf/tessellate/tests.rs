use super::*;
use std::f64::consts::PI;
use traylib_math::glam::{DMat3, EulerRot};

fn vertex(x: f64, y: f64) -> Vertex {
    Vertex { position: DVec3::new(x, y, 0.0), normal: None }
}

fn face(outline: &[[f64; 2]], holes: &[&[[f64; 2]]]) -> Shape {
    let ring = |points: &[[f64; 2]]| points.iter().map(|&[x, y]| vertex(x, y)).collect();
    Shape::Face { outline: ring(outline), holes: holes.iter().map(|hole| ring(hole)).collect() }
}

/// Turned so that no axis is left out of it.
fn tilted(shape: &Shape) -> Shape {
    let Shape::Face { outline, holes } = shape else { panic!() };
    let turn = DMat3::from_euler(EulerRot::YXZ, 0.5, 2.5, -1.0);
    let turned = |ring: &Vec<Vertex>| {
        let turned = |v: &Vertex| Vertex { position: turn * v.position + DVec3::splat(9.0), ..*v };
        ring.iter().map(turned).collect::<Vec<_>>()
    };
    Shape::Face { outline: turned(outline), holes: holes.iter().map(turned).collect() }
}

fn area(triangles: &[[Vertex; 3]]) -> f64 {
    triangles.iter().map(|corners| newell(corners).length() / 2.0).sum()
}

/// Sums what triangles cover without sign: more than the polygon if any overlap.
fn covers(shape: &Shape, expected: f64, count: usize) {
    for shape in [shape, &tilted(shape)] {
        let triangles = triangles(shape, 5);
        assert!((area(&triangles) - expected).abs() < 1e-9, "{} {expected}", area(&triangles));
        assert_eq!(triangles.len(), count, "{shape:?}");
        let front = newell(&polygons(shape, 5)[0]);
        assert!(triangles.iter().all(|corners| newell(corners).dot(front) > 0.0));
    }
}

#[test]
fn concave_polygons_are_cut_without_overlap() {
    covers(&face(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], &[]), 1.0, 2);
    let dart = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
    covers(&face(&dart, &[]), 4.0, 2);
    let comb: Vec<[f64; 2]> = (0..40)
        .map(|i| [f64::from(i), if i % 2 == 0 { 1.0 } else { 9.0 }])
        .rev()
        .chain([[0.0, 0.0], [39.0, 0.0]])
        .collect();
    // 39 trapezoids of mean height 5.
    covers(&face(&comb, &[]), 195.0, 40);
}

#[test]
fn spirals_are_cut_without_overlap() {
    let turn = |i: i32, radius: f64| {
        let (sin, cos) = (f64::from(i) * 0.3).sin_cos();
        [radius * cos, radius * sin]
    };
    let outer = (0..80).map(|i| turn(i, 2.0 + 0.1 * f64::from(i)));
    let inner = (0..80).rev().map(|i| turn(i, 1.5 + 0.1 * f64::from(i)));
    let spiral: Vec<[f64; 2]> = outer.chain(inner).collect();
    let shape = face(&spiral, &[]);
    let expected = newell(&polygons(&shape, 1)[0]).length() / 2.0;
    covers(&shape, expected, 158);
}

#[test]
fn straight_and_repeated_corners_cost_nothing() {
    let straight = [
        [0.0, 0.0],
        [0.5, 0.0],
        [1.0, 0.0],
        [1.0, 0.5],
        [1.0, 1.0],
        [0.5, 1.0],
        [0.0, 1.0],
        [0.0, 0.5],
    ];
    covers(&face(&straight, &[]), 1.0, 6);
    let repeated = [[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 1.0], [0.0, 1.0]];
    covers(&face(&repeated, &[]), 1.0, 2);
    // Out and back again.
    let spike = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    covers(&face(&spike, &[]), 1.0, 2);
}

#[test]
fn seams_walked_both_ways_leave_a_hole() {
    let keyhole = [
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 4.0],
        [0.0, 4.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [1.0, 3.0],
        [3.0, 3.0],
        [3.0, 1.0],
        [1.0, 1.0],
    ];
    covers(&face(&keyhole, &[]), 12.0, 8);
    // Two holes on seams to the same corner.
    let double = [
        [0.0, 0.0],
        [9.0, 0.0],
        [9.0, 4.0],
        [0.0, 4.0],
        [0.0, 0.0],
        [1.0, 2.0],
        [1.0, 3.0],
        [2.0, 3.0],
        [2.0, 2.0],
        [1.0, 2.0],
        [0.0, 0.0],
        [5.0, 1.0],
        [5.0, 2.0],
        [6.0, 2.0],
        [6.0, 1.0],
        [5.0, 1.0],
    ];
    covers(&face(&double, &[]), 34.0, 14);
}

#[test]
fn holes_are_joined_whatever_their_sense_and_order() {
    let outline = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    let hole = |x: f64, y: f64| [[x, y], [x, y + 1.0], [x + 1.0, y + 1.0], [x + 1.0, y]];
    let mut backward = hole(4.0, 4.0);
    backward.reverse();
    let holes = [hole(1.0, 1.0), backward, hole(7.0, 4.0), hole(1.0, 4.0), hole(5.5, 4.0)];
    let holes: Vec<&[[f64; 2]]> = holes.iter().map(|hole| &hole[..]).collect();
    // Each hole adds its corners and the two of a seam.
    covers(&face(&outline, &holes), 76.0, 4 + 5 * 6 - 2);
    let concave = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [6.0, 2.0], [5.0, 9.0], [0.0, 9.0]];
    let expected = newell(&polygons(&face(&concave, &[]), 1)[0]).length() / 2.0;
    covers(&face(&concave, &[&hole(1.0, 1.0), &hole(3.0, 5.0)]), expected - 2.0, 6 + 12 - 2);
}

#[test]
fn polygons_that_cross_themselves_end_too() {
    let bow = face(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [0.3, 2.0]], &[]);
    assert!(triangles(&bow, 5).len() <= 3);
    let nothing = face(&[[0.0, 0.0], [1.0, 0.0], [0.5, 0.0]], &[]);
    assert!(triangles(&nothing, 5).is_empty());
    let far =
        face(&[[0.0, 0.0], [f64::INFINITY, 0.0], [f64::NAN, 1.0], [0.0, 1.0]], &[&[[0.1, 0.1]]]);
    assert!(triangles(&far, 5).len() <= 8);
    let outside =
        face(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &[&[[5.0, 5.0], [5.5, 5.0], [5.0, 5.5]]]);
    assert!(!triangles(&outside, 5).is_empty());
}

#[test]
fn missing_normals_are_those_of_the_plane_and_wrong_ones_are_turned() {
    let mut outline = vec![vertex(0.0, 0.0), vertex(1.0, 0.0), vertex(0.0, 1.0)];
    let slanted = DVec3::new(0.6, 0.0, 0.8);
    outline[0].normal = Some(slanted);
    outline[1].normal = Some(-slanted);
    let triangles = triangles(&Shape::Face { outline, holes: vec![] }, 5);
    let normals: Vec<_> = triangles[0].iter().map(|corner| corner.normal.unwrap()).collect();
    assert_eq!(normals.iter().filter(|&&n| n == slanted).count(), 2);
    assert_eq!(normals.iter().filter(|&&n| n == DVec3::Z).count(), 1);
}

/// Round shapes: counts, area and box near the exact ones, and normals.
fn round(shape: &Shape, polygon_count: usize, triangle_count: usize, exact: f64, outward: f64) {
    let polygons = polygons(shape, 5);
    let corners: usize = polygons.iter().map(|polygon| polygon.len() - 2).sum();
    assert_eq!((polygons.len(), corners), (polygon_count, triangle_count), "{shape:?}");
    let triangles = triangles(shape, 64);
    assert!((area(&triangles) / exact - 1.0).abs() < 1e-3, "{} {exact}", area(&triangles));
    for corners in &triangles {
        let front = newell(corners).normalize();
        assert!(corners.iter().all(|corner| corner.normal.unwrap().dot(front) > 0.9), "{shape:?}");
    }
    // The flux of the position through a closed surface is thrice its volume.
    let through = |corners: &[Vertex; 3]| newell(corners).dot(corners[0].position) / 2.0;
    let flux: f64 = triangles.iter().map(through).sum();
    assert!(flux * outward >= 0.0, "{shape:?}");
}

#[test]
fn round_shapes_are_cut_as_radiance_does() {
    let centre = DVec3::ZERO;
    let sphere = |inward| Shape::Sphere { centre, radius: 2.0, inward };
    round(&sphere(false), 200, 360, 16.0 * PI, 1.0);
    round(&sphere(true), 200, 360, 16.0 * PI, -1.0);
    let ends = [DVec3::ZERO, DVec3::new(0.0, 3.0, 4.0)];
    let tube = |inward| Shape::Cylinder { ends, radius: 1.0, inward };
    round(&tube(false), 20, 40, 10.0 * PI, 1.0);
    round(&tube(true), 20, 40, 10.0 * PI, -1.0);
    let cone = |radii, inward| Shape::Cone { ends, radii, inward };
    round(&cone([0.0, 1.0], false), 20, 20, PI * 26_f64.sqrt(), 0.0);
    round(&cone([1.0, 0.0], true), 20, 20, PI * 26_f64.sqrt(), -1.0);
    round(&cone([2.0, 1.0], false), 20, 40, 3.0 * PI * 26_f64.sqrt(), 1.0);
    let normal = DVec3::new(0.0, 0.6, 0.8);
    let ring = |inner| Shape::Ring { centre: normal, normal, radii: [inner, 2.0] };
    round(&ring(0.0), 20, 20, 4.0 * PI, 1.0);
    round(&ring(1.0), 20, 40, 3.0 * PI, 1.0);
    let torus = |inward| Shape::Torus { centre, normal, radius: 3.0, tube_radius: 1.0, inward };
    round(&torus(false), 400, 800, 12.0 * PI * PI, 1.0);
    round(&torus(true), 400, 800, 12.0 * PI * PI, -1.0);
}

#[test]
fn absurd_divisions_are_bounded() {
    let ends = [DVec3::ZERO, DVec3::X];
    let tube = Shape::Cylinder { ends, radius: 1.0, inward: false };
    assert_eq!((polygons(&tube, 0).len(), polygons(&tube, u32::MAX).len()), (4, 1024));
}

#[test]
fn prisms_are_closed_and_face_their_side() {
    let outline = vec![vertex(0.0, 0.0), vertex(2.0, 0.0), vertex(1.0, 0.5), vertex(0.0, 3.0)];
    for (offset, inward, sense) in [(-2.0, false, 1.0), (2.0, true, -1.0)] {
        let offset = DVec3::new(0.0, 0.0, offset);
        let prism = Shape::Prism { outline: outline.clone(), offset, inward };
        assert_eq!(polygons(&prism, 5).len(), 6);
        let triangles = triangles(&prism, 5);
        assert_eq!(triangles.len(), 12);
        let closed: DVec3 = triangles.iter().map(|corners| newell(corners)).sum();
        assert!(closed.length() < 1e-12);
        let through = |corners: &[Vertex; 3]| newell(corners).dot(corners[0].position) / 2.0;
        let volume = triangles.iter().map(through).sum::<f64>() / 3.0;
        let base = newell(&outline).length() / 2.0;
        assert!((volume - sense * 2.0 * base).abs() < 1e-12, "{volume}");
    }
}

#[test]
fn many_corners_take_time_with_their_square_only() {
    let corners = 4000;
    let star: Vec<[f64; 2]> = (0..corners)
        .map(|i| {
            let (sin, cos) = (TAU * f64::from(i) / f64::from(corners)).sin_cos();
            let radius = if i % 2 == 0 { 1.0 } else { 2.0 };
            [radius * cos, radius * sin]
        })
        .collect();
    assert_eq!(triangles(&face(&star, &[]), 5).len(), corners as usize - 2);
}
