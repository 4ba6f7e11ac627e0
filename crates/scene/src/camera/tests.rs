use super::*;
use traylib_math::Sampler;

fn settings() -> CameraSettings {
    CameraSettings {
        position: Vec3::new(1.0, 2.0, 3.0),
        target: Vec3::new(0.0, 1.0, -2.0),
        up: Vec3::Y,
        fov_degrees: 70.0,
        width: 31,
        height: 20,
    }
}

#[test]
fn a_projected_point_is_where_its_ray_went() {
    let camera = Camera::new(settings()).unwrap();
    let mut sampler = Sampler::numbered(0, 0);
    for _ in 0..10_000 {
        let film_point = sampler.next_2d() * Vec2::new(31.0, 20.0);
        let ray = camera.ray(film_point);
        let found = camera.project(ray.at(0.1 + 100.0 * sampler.next_1d())).unwrap();
        let centre = Vec2::new(found.x as f32 + 0.5, found.y as f32 + 0.5);
        assert!((film_point - centre).abs().max_element() < 0.501);
        assert!((found.to_camera + ray.direction).length() < 1e-5);
    }
}

/// The same rays and the same places, counted from the window's corner.
#[test]
fn a_window_shows_what_the_frame_does() {
    let frame = Camera::new(settings()).unwrap();
    let window = FilmWindow { x: 7, y: 3, width: 11, height: 17 };
    let cropped = frame.cropped(window).unwrap();
    assert_eq!((cropped.width(), cropped.height()), (11, 17));
    let corner = Vec2::new(7.0, 3.0);
    let mut sampler = Sampler::numbered(2, 0);
    let mut inside = 0;
    for _ in 0..10_000 {
        let film_point = sampler.next_2d() * Vec2::new(31.0, 20.0);
        let ray = frame.ray(film_point);
        // Corners are whole numbers, but a film point next to one may be rounded.
        assert!((cropped.ray(film_point - corner).direction - ray.direction).length() < 1e-6);
        let seen = frame.project(ray.at(1.0)).unwrap();
        let in_window = (7..18).contains(&seen.x) && (3..20).contains(&seen.y);
        let expected = in_window.then(|| Projection { x: seen.x - 7, y: seen.y - 3, ..seen });
        if let Some(found) = cropped.project(ray.at(1.0)) {
            assert_eq!(Some(found), expected);
            inside += 1;
        } else {
            assert_eq!(expected, None);
        }
    }
    assert!(inside > 1000, "{inside}");
}

#[test]
fn a_window_is_inside_the_frame() {
    let camera = Camera::new(settings()).unwrap();
    let window = |x, y, width, height| camera.cropped(FilmWindow { x, y, width, height });
    assert_eq!(window(0, 0, 31, 20), Ok(camera));
    for (x, y, width, height) in
        [(0, 0, 0, 20), (0, 0, 31, 0), (1, 0, 31, 20), (0, 19, 1, 2), (u32::MAX, 0, 2, 2)]
    {
        assert!(matches!(window(x, y, width, height), Err(Error::Camera(_))), "{x} {y}");
    }
}

#[test]
fn the_picture_is_upright_and_not_mirrored() {
    let camera = Camera::new(CameraSettings {
        position: Vec3::ZERO,
        target: Vec3::NEG_Z,
        fov_degrees: 90.0,
        width: 10,
        height: 10,
        ..settings()
    })
    .unwrap();
    let place = |x, y| camera.project(Vec3::new(x, y, -1.0)).map(|p| (p.x, p.y));
    assert_eq!(place(-0.95, 0.95), Some((0, 0)));
    assert_eq!(place(0.95, 0.95), Some((9, 0)));
    assert_eq!(place(-0.95, -0.95), Some((0, 9)));
    // On the edges: the left and upper ones belong to the picture.
    assert_eq!(place(-1.0, 1.0), Some((0, 0)));
    assert_eq!(place(1.0, 0.0), None);
    assert_eq!(place(0.0, -1.0), None);
    assert_eq!(camera.project(Vec3::Z), None);
}

/// The density of all rays, 1/(pixels) of each pixel's, integrates to one
/// over the cone that the camera sees.
#[test]
fn density_is_that_of_the_rays() {
    let camera = Camera::new(settings()).unwrap();
    let steps = 400;
    let mut solid_angle = 0.0;
    for i in 0..steps * steps {
        let u = Vec2::new((i % steps) as f32 + 0.5, (i / steps) as f32 + 0.5) / steps as f32;
        let direction = camera.ray(u * Vec2::new(31.0, 20.0)).direction;
        solid_angle += 31.0 * 20.0 / f64::from(camera.pdf(direction).0);
    }
    solid_angle /= f64::from(steps * steps);
    // A rectangle a × b at distance one fills 4·asin(ab/√((1+a²)(1+b²)))
    // with its half sides.
    let a = 35.0_f64.to_radians().tan();
    let b = a * 20.0 / 31.0;
    let exact = 4.0 * (a * b / ((1.0 + a * a) * (1.0 + b * b)).sqrt()).asin();
    assert!((solid_angle / exact - 1.0).abs() < 1e-4, "{solid_angle} {exact}");
}

#[test]
fn impossible_cameras_are_refused() {
    for bad in [
        CameraSettings { target: Vec3::new(1.0, 2.0, 3.0), ..settings() },
        CameraSettings { up: Vec3::new(1.0, 1.0, 5.0), ..settings() },
        CameraSettings { up: Vec3::ZERO, ..settings() },
        CameraSettings { fov_degrees: 180.0, ..settings() },
        CameraSettings { fov_degrees: f32::NAN, ..settings() },
        CameraSettings { width: 0, ..settings() },
        CameraSettings { position: Vec3::new(f32::NAN, 0.0, 0.0), ..settings() },
    ] {
        assert!(matches!(Camera::new(bad), Err(Error::Camera(_))), "{bad:?}");
    }
}

/// A number of one to three decimals below 20, as people write them.
fn decimal(sampler: &mut Sampler) -> f64 {
    let digits = 10_f64.powi(1 + (3.0 * sampler.next_fine()) as i32);
    ((2.0 * sampler.next_fine() - 1.0) * 20.0 * digits).round() / digits
}

fn decimals(sampler: &mut Sampler) -> DVec3 {
    DVec3::from_array([(); 3].map(|()| decimal(sampler)))
}

/// Rounding makes no frame: neither that of a product in single precision, nor that of
/// decimal fractions which are multiples of one another.
#[test]
fn up_along_a_slanted_view_is_refused() {
    let mut sampler = Sampler::numbered(1, 0);
    let mut tried = 0;
    while tried < 20_000 {
        let (position, view, k) =
            (decimals(&mut sampler), decimals(&mut sampler), decimal(&mut sampler));
        if view.length() == 0.0 || k == 0.0 {
            continue;
        }
        tried += 1;
        let (near, far) = (position.as_vec3(), (position + view).as_vec3());
        for up in [(view * k).as_vec3(), (far - near) * k as f32] {
            let bad = CameraSettings { position: near, target: far, up, ..settings() };
            let refused = Err(Error::Camera("up points along the view"));
            assert_eq!(Camera::new(bad), refused, "{bad:?}");
        }
    }
}

/// To a few roundings, also where `up` is hardly off the view.
#[test]
fn pictures_have_right_angles() {
    let mut sampler = Sampler::numbered(2, 0);
    for _ in 0..20_000 {
        let [position, view, aside] = [(); 3].map(|()| decimals(&mut sampler).as_vec3());
        let off = 1e-5_f32.powf(sampler.next_1d());
        let sound = CameraSettings {
            position,
            target: position + view,
            up: view + off * aside,
            ..settings()
        };
        // What chance made parallel, or nothing of.
        let Ok(camera) = Camera::new(sound) else {
            assert!(view.cross(aside).length() * off < 1e-4 * view.length_squared(), "{sound:?}");
            continue;
        };
        let [right, down] = [camera.right, camera.down].map(|v| v * camera.pixels_per_unit);
        let forward = camera.forward;
        for unit in [right, down, forward] {
            assert!((unit.length() - 1.0).abs() < 1e-6, "{sound:?}");
        }
        for dot in [right.dot(down), down.dot(forward), forward.dot(right)] {
            assert!(dot.abs() < 1e-6, "{sound:?}");
        }
        assert!(right.dot(sound.up).abs() < 1e-5 * sound.up.length(), "{sound:?}");
        assert!(down.dot(sound.up) < 0.0, "{sound:?}");
        assert!(right.cross(down).dot(forward) > 0.0, "{sound:?}");
    }
}
