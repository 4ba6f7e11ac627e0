//! The cones against the mirrors themselves: what is reflected onto the lamp is inside.

use super::light_ball::LightBall;
use super::mirror::Mirror;
use super::*;
use crate::PointLight;
use traylib_geometry::{
    Disk, Facing, Form, Outline, Primitive, Quad, Ray, Sides, Sphere, Triangle,
};
use traylib_math::{Rgb, Sampler};

fn quad(corner: [f32; 3], u: [f32; 3], v: [f32; 3]) -> Primitive {
    Primitive::Quad(Quad::new(corner.into(), u.into(), v.into()).unwrap())
}

fn ball(centre: [f32; 3], radius: f32) -> Primitive {
    Primitive::Sphere(Sphere::new(centre.into(), radius, Facing::Outward).unwrap())
}

fn area_light(primitive: Primitive) -> Light {
    Light::Area { primitive, radiance: Rgb::WHITE }
}

/// A lamp of each kind above the plane y = 0, shining down.
fn lamps() -> [Primitive; 4] {
    let triangle =
        Triangle::new(Vec3::new(0.4, 2.0, 0.0), Vec3::new(0.6, 2.0, 0.0), Vec3::new(0.4, 2.0, 0.3));
    [
        quad([0.4, 2.0, 0.0], [0.2, 0.0, 0.0], [0.0, 0.0, 0.2]),
        Primitive::Triangle(triangle.unwrap()),
        Primitive::Disk(Disk::new(Vec3::new(0.5, 2.0, 0.1), -Vec3::Y, 0.1).unwrap()),
        ball([0.5, 2.0, 0.1], 0.1),
    ]
}

/// Mirrors that show these lamps to [`EYES`].
fn mirrors() -> [Primitive; 4] {
    let triangle =
        Triangle::new(Vec3::new(-3.0, 0.0, 3.0), Vec3::new(3.0, 0.0, 3.0), -3.0 * Vec3::Z);
    [
        quad([-2.0, 0.0, -2.0], [0.0, 0.0, 4.0], [4.0, 0.0, 0.0]),
        Primitive::Triangle(triangle.unwrap()),
        Primitive::Disk(Disk::new(Vec3::ZERO, Vec3::Y, 2.0).unwrap()),
        ball([0.0, -0.5, 0.0], 0.5),
    ]
}

const EYES: [Vec3; 3] =
    [Vec3::new(-1.0, 1.5, 0.2), Vec3::new(0.9, 0.3, -0.6), Vec3::new(0.1, 1.0, 0.1)];

/// Returns the ray after an ideal mirror; `None` if it misses.
fn reflected(mirror: &Primitive, ray: &Ray) -> Option<Ray> {
    let hit = mirror.intersect(ray, Sides::Both)?;
    let hit = traylib_geometry::Hit { t: hit.t, u: hit.u, v: hit.v, primitive: 0 };
    let site = mirror.site(ray, &hit);
    let direction = ray.direction - 2.0 * site.normal.dot(ray.direction) * site.normal;
    Some(Ray::new(site.ray_origin(direction), direction))
}

fn image(mirror: &Primitive, lamp: &Primitive, eye: Vec3) -> Option<ImageCone> {
    let lamp = LightBall::of(&area_light(*lamp)).unwrap();
    Mirror::new(mirror, Sides::Both, f32::INFINITY).unwrap().image(&lamp, eye)
}

/// Of directions around the cone, up to twice as wide, all that come to the lamp are in the
/// cone, but for one in a hundred of a ball, whose images are not round; and of directions in
/// the cone a good part comes to the lamp. `goes_on` is where a ray from the eye comes after all
/// mirrors.
fn holds_the_image_and_not_much_else(
    (cone, lamp, eye): (ImageCone, &Primitive, Vec3),
    sampler: &mut Sampler,
    goes_on: impl Fn(&Ray) -> Option<Ray>,
    case: &str,
) {
    let (mut shown, mut outside, mut inside) = (0, 0, 0);
    for _ in 0..20_000 {
        let wide = (4.0 * cone.one_minus_cos).min(2.0);
        let w = warp::uniform_cone(cone.axis, wide, sampler.next_2d());
        let in_cone = cone.pdf(w) > 0.0;
        inside += u32::from(in_cone);
        let Some(ray) = goes_on(&Ray::new(eye, w)) else { continue };
        if lamp.intersect(&ray, Sides::Front).is_some() {
            shown += 1;
            outside += u32::from(!in_cone);
        }
    }
    assert!(outside * 100 <= shown, "{case}: {shown} {outside} {inside}");
    assert!(shown * 8 >= inside, "{case}: {shown} {outside} {inside}");
}

#[test]
fn cones_hold_the_image_and_not_much_else() {
    let mut sampler = Sampler::numbered(1, 0);
    for mirror in mirrors() {
        for lamp in lamps() {
            for eye in EYES {
                let cone = image(&mirror, &lamp, eye).unwrap();
                let case = format!("{mirror:?} {lamp:?} {eye}");
                let goes_on = |ray: &Ray| reflected(&mirror, ray);
                holds_the_image_and_not_much_else((cone, &lamp, eye), &mut sampler, goes_on, &case);
            }
        }
    }
}

/// The mirror y = 3, in which [`EYES`] see [`mirrors`].
fn ceiling() -> Primitive {
    quad([-4.0, 3.0, -4.0], [0.0, 0.0, 8.0], [8.0, 0.0, 0.0])
}

/// Cones hold the image in another mirror as well.
#[test]
fn cones_hold_images_of_images() {
    let mut sampler = Sampler::numbered(3, 0);
    let seen_in = Mirror::new(&ceiling(), Sides::Both, f32::INFINITY).unwrap();
    for mirror in mirrors() {
        for lamp in lamps() {
            for eye in EYES {
                let pair = {
                    let mirror = Mirror::new(&mirror, Sides::Both, f32::INFINITY).unwrap();
                    Pair::new(&mirror, &LightBall::of(&area_light(lamp)).unwrap()).unwrap()
                };
                let case = format!("{mirror:?} {lamp:?} {eye}");
                let cone = pair.seen_in(&seen_in).unwrap().image(eye).expect(&case);
                let goes_on = |ray: &Ray| reflected(&mirror, &reflected(&ceiling(), ray)?);
                holds_the_image_and_not_much_else((cone, &lamp, eye), &mut sampler, goes_on, &case);
            }
        }
    }
}

/// Pieces of one plane show nothing of one another, nor do mirrors that turn their backs.
#[test]
fn mirrors_show_those_before_them() {
    let mirror = |shape: &Primitive, sides| Mirror::new(shape, sides, f32::INFINITY).unwrap();
    let [floor, triangle, disk, globe] = mirrors();
    for sides in [Sides::Both, Sides::Front] {
        // The front of both is toward y.
        let [floor, ceiling] = [floor, ceiling()].map(|shape| mirror(&shape, sides));
        let are_shown = sides == Sides::Both;
        assert_eq!(floor.may_show_mirror(&ceiling), are_shown);
        assert_eq!(ceiling.may_show_mirror(&floor), are_shown);
        for flat in [&triangle, &disk] {
            assert!(!floor.may_show_mirror(&mirror(flat, sides)));
        }
        // Balls show mirrors nowhere in particular.
        assert!(!mirror(&globe, sides).may_show_mirror(&floor));
    }

    assert!(mirror(&ceiling(), Sides::Both).may_show_mirror(&mirror(&globe, Sides::Front)));
}

/// The sides of a pyramid may show one another from within alone, where nobody is: to look for
/// that took half as long again as a whole picture by `directlight`.
#[test]
fn sides_of_one_body_are_no_row() {
    let apex = Vec3::new(0.0, 0.7, -0.1);
    let corners = [[0.5, 0.0, 0.0], [-0.1, 0.0, 0.4], [-0.5, 0.0, -0.2]].map(Vec3::from);
    let side = |a: Vec3, b: Vec3| {
        let triangle = Triangle::new(a, b, apex).unwrap();
        Mirror::new(&Primitive::Triangle(triangle), Sides::Both, f32::INFINITY).unwrap()
    };
    let sides = [side(corners[1], corners[0]), side(corners[2], corners[1])];
    assert!(sides[0].may_show_mirror(&sides[1]) && sides[0].touches(&sides[1]));
    let lamp = LightBall::of(&area_light(lamps()[0])).unwrap();
    let pairs: Vec<Pair> = sides.iter().filter_map(|side| Pair::new(side, &lamp)).collect();
    assert!(in_rows(&pairs, &sides).is_empty());
    // Others far from them are.
    let ceiling = Mirror::new(&ceiling(), Sides::Both, f32::INFINITY).unwrap();
    assert!(!sides[0].touches(&ceiling));
}

#[test]
fn nothing_is_aimed_at_that_cannot_show() {
    let [square, ..] = lamps();
    let [floor, .., globe] = mirrors();
    // From below the mirror, from inside the ball, and where the lamp shows its back.
    assert_eq!(image(&floor, &square, -Vec3::Y), None);
    assert_eq!(image(&globe, &square, Vec3::new(0.0, -0.4, 0.0)), None);
    let upward = quad([0.4, 2.0, 0.0], [0.0, 0.0, 0.2], [0.2, 0.0, 0.0]);
    for mirror in [floor, globe] {
        assert_eq!(image(&mirror, &upward, EYES[0]), None);
    }
    // In a mirror that ends before the image comes into view.
    let far = quad([5.0, 0.0, 5.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    assert_eq!(image(&far, &square, EYES[0]), None);
    // The back of a mirror that has only a front.
    let front = Mirror::new(&floor, Sides::Front, f32::INFINITY).unwrap();
    let lamp = LightBall::of(&area_light(ball([0.0, -2.0, 0.0], 0.1))).unwrap();
    assert_eq!(front.image(&lamp, Vec3::new(0.5, -1.0, 0.0)), None);
}

/// A mirror that is much smaller than the image in it shows a part of it, though neither
/// its middle nor its corners.
#[test]
fn small_mirrors_show_parts_of_large_lamps() {
    let small = quad([0.48, 0.0, 0.49], [0.0, 0.0, 0.01], [0.01, 0.0, 0.0]);
    let large = quad([-0.5, 10.0, -0.5], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    assert!(image(&small, &large, Vec3::new(0.5, 1.0, 0.5)).is_some());
}

/// A lobe smears a point into what can be aimed at.
#[test]
fn lobes_blur_points() {
    let light = Light::Point(PointLight {
        position: Vec3::new(0.5, 2.0, 0.1),
        intensity: Rgb::WHITE,
        cone: None,
    });
    let lamp = LightBall::of(&light).unwrap();
    for mirror in mirrors() {
        for (exponent, eye) in [(1e3, EYES[0]), (1e5, EYES[2])] {
            let mirror = Mirror::new(&mirror, Sides::Both, exponent).unwrap();
            let cone = mirror.image(&lamp, eye).unwrap();
            // No wider than the lobe itself.
            assert!(cone.one_minus_cos > 10.0 * NARROWEST);
            assert!(cone.one_minus_cos < 7.0 / exponent, "{cone:?}");
        }
    }
}

#[test]
fn directions_are_drawn_by_their_density() {
    let images = ImageDirections {
        count: 3,
        part: 1.0,
        cones: [
            ImageCone::around(Vec3::X, 0.045),
            ImageCone::around(Vec3::new(0.96, 0.28, 0.0), 0.02),
            ImageCone::around(-Vec3::Z, 5e-5),
            ImageCone::EMPTY,
        ],
    };
    // ∫ dω over the union of the cones, from samples: the first two overlap.
    let mut sampler = Sampler::numbered(2, 0);
    let n = 200_000;
    let mut measured = 0.0;
    let (mut both, mut on_z) = (0, 0);
    for _ in 0..n {
        let u = [sampler.next_1d(), sampler.next_1d(), sampler.next_1d()];
        let w = images.sample(u);
        let pdf = images.pdf(w).0;
        assert!(pdf > 0.0);
        measured += 1.0 / f64::from(pdf) / f64::from(n);
        both += u32::from(images.cones[..2].iter().all(|cone| cone.pdf(w) > 0.0));
        on_z += u32::from(w.z < -0.9);
    }
    // The union, by counting among uniform directions of the half-space around x and z.
    let mut inside = 0;
    for _ in 0..n {
        let w = warp::uniform_cone(Vec3::X, 0.2, sampler.next_2d());
        inside += u32::from(images.cones[..2].iter().any(|cone| cone.pdf(w) > 0.0));
    }
    let narrow = f64::from(TAU * images.cones[2].one_minus_cos);
    let expected = f64::from(TAU) * 0.2 * f64::from(inside) / f64::from(n) + narrow;
    // Standard errors: 0.05 % of the one, 0.4 % of the other.
    assert!((measured / expected - 1.0).abs() < 0.02, "{measured} {expected}");
    assert!(both > 10_000);
    // A third of all, σ = 211.
    assert!((f64::from(on_z) - f64::from(n) / 3.0).abs() < 900.0, "{on_z}");
}

/// Sizes are no business of directions: the same bits at any power of two.
#[test]
fn scale_does_not_matter() {
    for mirror in mirrors() {
        for exponent in [1e3, f32::INFINITY] {
            for eye in EYES {
                let at = |scale: f32| {
                    let scaled = |primitive: &Primitive| match primitive.form() {
                        Form::Ball(s) => ball((scale * s.centre()).to_array(), scale * s.radius()),
                        Form::Flat {
                            outline: Outline::Parallelogram { corner, edges }, ..
                        } => {
                            let [u, v] = edges.map(|edge| (scale * edge).to_array());
                            quad((scale * corner).to_array(), u, v)
                        }
                        Form::Flat { .. } | Form::Bent(_) => *primitive,
                    };
                    let lamp = LightBall::of(&area_light(scaled(&lamps()[0]))).unwrap();
                    let mirror = Mirror::new(&scaled(&mirror), Sides::Both, exponent).unwrap();
                    mirror.image(&lamp, scale * eye)
                };
                if matches!(mirror, Primitive::Sphere(_) | Primitive::Quad(_)) {
                    let cone = at(1.0).unwrap();
                    for scale in [1.0 / 1024.0, 4096.0] {
                        assert_eq!(at(scale), Some(cone));
                    }
                }
            }
        }
    }
}

/// Of many pairs those are kept by which most light comes.
#[test]
fn the_greatest_are_kept_in_order() {
    let mut list: Vec<(f32, u32)> = vec![(1.0, 0), (3.0, 1), (2.0, 2), (3.0, 3), (0.5, 4)];
    keep_greatest(&mut list, 3, |item| item.0);
    assert_eq!(list, [(3.0, 1), (3.0, 3), (2.0, 2)]);
}
