//! The pinhole camera.

use crate::Error;
use traylib_geometry::{Ray, SurfaceSite};
use traylib_math::glam::DVec3;
use traylib_math::{SolidAnglePdf, Vec2, Vec3};

mod window;

pub use window::FilmWindow;

/// The description of a camera, from which one is built.
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
/// pixel (x, y) holds the film points [x, x+1) × [y, y+1). The picture is the whole frame of
/// the settings or a [window](Self::cropped) of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    settings: CameraSettings,
    window: FilmWindow,
    /// The position of the settings, or one beside it.
    position: Vec3,
    forward: Vec3,
    /// One pixel to the right and one down, on the plane at distance one.
    right: Vec3,
    down: Vec3,
    pixels_per_unit: f32,
}

/// The place of a point of the scene in the picture.
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
    /// [`Error::Camera`] for a view without direction, upward along the view (with a
    /// sine below 10⁻⁶ to it, more where both ends of the view are far from the origin),
    /// an angle outside (0°, 180°), or no pixels.
    pub fn new(settings: CameraSettings) -> Result<Self, Error> {
        let CameraSettings { position, target, up, fov_degrees, width, height } = settings;
        if !(position.is_finite() && target.is_finite() && up.is_finite()) {
            return Err(Error::Camera("position, target and up must be finite"));
        }
        let [right, down, forward] = axes(position, target, up)?;
        if !(fov_degrees > 0.0 && fov_degrees < 180.0) {
            return Err(Error::Camera("the field of view must lie between 0 and 180 degrees"));
        }
        if width == 0 || height == 0 {
            return Err(Error::Camera("the picture has no pixels"));
        }
        let pixel = 2.0 * (0.5 * fov_degrees.to_radians()).tan() / width as f32;
        Ok(Self {
            settings,
            window: FilmWindow::whole(width, height),
            position,
            forward: forward.as_vec3(),
            right: (right * f64::from(pixel)).as_vec3(),
            down: (down * f64::from(pixel)).as_vec3(),
            pixels_per_unit: 1.0 / pixel,
        })
    }

    /// Returns the camera with its pinhole off a surface in which it lies, on the side into
    /// which it looks: what is there would be met or not by rounding.
    pub(crate) fn lifted(self, site: &SurfaceSite) -> Self {
        let at = SurfaceSite { position: self.position, ..*site };
        Self { position: at.ray_origin(self.forward), ..self }
    }

    /// Returns the camera of a part of the frame: its picture has the pixels of the window alone,
    /// each as it was in the frame.
    ///
    /// # Errors
    /// [`Error::Camera`] if the window has no pixel or is not inside the frame.
    pub fn cropped(self, window: FilmWindow) -> Result<Self, Error> {
        let CameraSettings { width, height, .. } = self.settings;
        if window.is_inside(width, height) {
            Ok(Self { window, ..self })
        } else {
            Err(Error::Camera("the window has no pixels, or some outside the frame"))
        }
    }

    /// Returns the description that it was built from, which is that of the frame.
    pub fn settings(&self) -> CameraSettings {
        self.settings
    }

    /// The part of the frame that the picture shows.
    pub fn window(&self) -> FilmWindow {
        self.window
    }

    /// The pinhole: where the settings have it, or beside that if a surface is there.
    pub fn position(&self) -> Vec3 {
        self.position
    }

    /// Columns of pixels of the picture.
    pub fn width(&self) -> u32 {
        self.window.width
    }

    /// Rows of pixels of the picture.
    pub fn height(&self) -> u32 {
        self.window.height
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

    /// Returns the place of `point` in the picture, if it lies before the camera and inside the
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
        let inside = x >= 0.0 && y >= 0.0 && x < self.width() as f32 && y < self.height() as f32;
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

    /// The film point at which the camera looks.
    fn middle(&self) -> Vec2 {
        let CameraSettings { width, height, .. } = self.settings;
        let [x, y] = [self.window.x, self.window.y].map(|corner| corner as f32);
        0.5 * Vec2::new(width as f32, height as f32) - Vec2::new(x, y)
    }
}

/// Unit vectors to the right, down and forward.
///
/// In double precision, in which `up` keeps its digits however nearly it points along
/// the view; a frame is refused where nothing but rounding would turn it.
fn axes(position: Vec3, target: Vec3, up: Vec3) -> Result<[DVec3; 3], Error> {
    let [position, target, up] = [position, target, up].map(Vec3::as_dvec3);
    let view = target - position;
    let forward =
        view.try_normalize().ok_or(Error::Camera("position and target are the same point"))?;
    let up = up.try_normalize().ok_or(Error::Camera("up has no direction"))?;
    let across = forward.cross(up);
    // Each end of the view was rounded to single precision.
    let of_ends = (position.length() + target.length()) / view.length();
    let error_bound = ALONG + 0.5 * f64::from(f32::EPSILON) * of_ends;
    if across.length() <= error_bound {
        return Err(Error::Camera("up points along the view"));
    }
    let right = across.normalize();
    Ok([right, forward.cross(right), forward])
}

/// The sine of an angle that counts as none: some roundings to single precision of the
/// numbers that `up` is made of, by which a multiple of the view may miss it.
const ALONG: f64 = 1e-6;

#[cfg(test)]
mod tests;
