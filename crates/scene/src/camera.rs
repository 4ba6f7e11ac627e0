//! The pinhole camera.

use crate::Error;
use traylib_geometry::Ray;
use traylib_math::{SolidAnglePdf, Vec2, Vec3};

/// What describes a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSettings {
    /// The pinhole, in metres.
    pub position: Vec3,
    /// A point in the middle of the picture.
    pub target: Vec3,
    /// A direction that is upward in the picture; need be neither unit nor
    /// perpendicular to the view.
    pub up: Vec3,
    /// Horizontal field of view in degrees.
    pub fov_degrees: f32,
    /// Columns of pixels.
    pub width: u32,
    /// Rows of pixels.
    pub height: u32,
}

/// A pinhole camera with square pixels and a box filter one pixel wide.
///
/// A film point is measured in pixels from the top left corner of the picture;
/// pixel (x, y) holds the film points [x, x+1) × [y, y+1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    position: Vec3,
    forward: Vec3,
    /// One pixel to the right and one down, on the plane at distance one.
    right: Vec3,
    down: Vec3,
    width: u32,
    height: u32,
    pixels_per_unit: f32,
}

/// Where a point in the scene appears on the film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Column of the pixel.
    pub x: u32,
    /// Row of the pixel.
    pub y: u32,
    /// Unit direction from the point to the camera.
    pub to_camera: Vec3,
    /// Squared distance from the camera, in m².
    pub distance_squared: f32,
    /// Density of the direction from the camera to the point among the rays
    /// through this pixel.
    pub pdf: SolidAnglePdf,
}

impl Camera {
    /// A camera; see [`CameraSettings`].
    ///
    /// # Errors
    /// [`Error::Camera`] for a view without direction, upward along the view,
    /// an angle outside (0°, 180°), or no pixels.
    pub fn new(settings: CameraSettings) -> Result<Self, Error> {
        let CameraSettings { position, target, up, fov_degrees, width, height } = settings;
        if !(position.is_finite() && target.is_finite() && up.is_finite()) {
            return Err(Error::Camera("position, target and up must be finite"));
        }
        let forward = (target - position)
            .try_normalize()
            .ok_or(Error::Camera("position and target are the same point"))?;
        let right = up
            .try_normalize()
            .and_then(|up| forward.cross(up).try_normalize())
            .ok_or(Error::Camera("up points along the view"))?;
        if !(fov_degrees > 0.0 && fov_degrees < 180.0) {
            return Err(Error::Camera("the field of view must lie between 0 and 180 degrees"));
        }
        if width == 0 || height == 0 {
            return Err(Error::Camera("the picture has no pixels"));
        }
        let pixel = 2.0 * (0.5 * fov_degrees.to_radians()).tan() / width as f32;
        Ok(Self {
            position,
            forward,
            right: right * pixel,
            down: forward.cross(right) * pixel,
            width,
            height,
            pixels_per_unit: 1.0 / pixel,
        })
    }

    /// The pinhole.
    pub fn position(&self) -> Vec3 {
        self.position
    }

    /// Columns of pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows of pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The ray through a film point, its direction unit.
    pub fn ray(&self, film_point: Vec2) -> Ray {
        let offset = film_point - self.middle();
        let direction = self.forward + offset.x * self.right + offset.y * self.down;
        Ray::new(self.position, direction.normalize())
    }

    /// Density of a unit `direction` from the camera among the rays through its
    /// pixel: 1/(A c³), with A the pixel's area at distance one and c the cosine
    /// of the angle to the view.
    pub fn pdf(&self, direction: Vec3) -> SolidAnglePdf {
        let cosine = self.forward.dot(direction);
        SolidAnglePdf(self.pixels_per_unit * self.pixels_per_unit / (cosine * cosine * cosine))
    }

    /// Where `point` appears, if it lies before the camera and inside the
    /// picture. The inverse of [`ray`](Self::ray).
    pub fn project(&self, point: Vec3) -> Option<Projection> {
        let offset = point - self.position;
        let depth = offset.dot(self.forward);
        if depth <= 0.0 {
            return None;
        }
        let scale = self.pixels_per_unit * self.pixels_per_unit / depth;
        let on_film = Vec2::new(offset.dot(self.right), offset.dot(self.down)) * scale;
        let Vec2 { x, y } = on_film + self.middle();
        let inside = x >= 0.0 && y >= 0.0 && x < self.width as f32 && y < self.height as f32;
        let distance_squared = offset.length_squared();
        let direction = offset.try_normalize()?;
        inside.then(|| Projection {
            x: x as u32,
            y: y as u32,
            to_camera: -direction,
            distance_squared,
            pdf: self.pdf(direction),
        })
    }

    fn middle(&self) -> Vec2 {
        0.5 * Vec2::new(self.width as f32, self.height as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::{Purpose, Sampler};

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
        let mut sampler = Sampler::new(0, Purpose::Test, 0, 0);
        for _ in 0..10_000 {
            let film_point = sampler.next_2d() * Vec2::new(31.0, 20.0);
            let ray = camera.ray(film_point);
            let found = camera.project(ray.at(0.1 + 100.0 * sampler.next_1d())).unwrap();
            let centre = Vec2::new(found.x as f32 + 0.5, found.y as f32 + 0.5);
            assert!((film_point - centre).abs().max_element() < 0.501);
            assert!((found.to_camera + ray.direction).length() < 1e-5);
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
            CameraSettings { fov_degrees: 180.0, ..settings() },
            CameraSettings { fov_degrees: f32::NAN, ..settings() },
            CameraSettings { width: 0, ..settings() },
            CameraSettings { position: Vec3::new(f32::NAN, 0.0, 0.0), ..settings() },
        ] {
            assert!(matches!(Camera::new(bad), Err(Error::Camera(_))), "{bad:?}");
        }
    }
}
