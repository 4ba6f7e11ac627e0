//! Options of which part of the picture is rendered.

use crate::outcome::Failure;
use clap::Args;
use std::str::FromStr;
use traylib_io::PictureFrame;
use traylib_scene::{Camera, CameraSettings, FilmWindow, Scene};

/// The part of the picture that is rendered: a rectangle of its pixels.
#[derive(Args, Clone, Debug, Default)]
pub struct WindowOptions {
    /// Render a part of the picture alone, in parts of its width and height from the top left
    /// corner: 0.25,0.75,0,0.5 is the upper half of the middle. An .exr keeps the place of the
    /// part in the whole
    #[arg(long, value_name = "X0,X1,Y0,Y1", visible_alias = "cropwindow")]
    pub crop: Option<Crop>,

    /// The same in pixels, the last of which are left out: 0,320,0,240
    #[arg(long, value_name = "X0,X1,Y0,Y1", conflicts_with = "crop")]
    pub pixelbounds: Option<PixelBounds>,
}

/// A part of a picture's width and height; see [`WindowOptions`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crop([f32; 4]);

/// Columns and rows of a picture, each from the first to the one after the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelBounds([u32; 4]);

impl WindowOptions {
    /// The scene as these options want it seen.
    ///
    /// # Errors
    /// The picture has no such pixels.
    pub(crate) fn applied_to(&self, scene: Scene) -> Result<Scene, Failure> {
        let settings = scene.camera().settings();
        let (width, height) = (settings.width, settings.height);
        let bounds = match (self.crop, self.pixelbounds) {
            (None, None) => return Ok(scene),
            (Some(crop), _) => crop.pixels(width, height),
            (None, Some(bounds)) => bounds,
        };
        // From its description: the scene sees to it anew that the pinhole is free.
        let camera = Camera::new(settings).and_then(|camera| camera.cropped(bounds.window()));
        let camera = camera.map_err(|_| {
            Failure::usage(format_args!(
                "--pixelbounds {bounds}: no pixels of a picture of {width}x{height}"
            ))
        })?;
        Ok(scene.seen_by(camera))
    }
}

impl Crop {
    /// Returns the pixels whose left upper corner is inside: of parts that meet, each pixel is in
    /// one.
    fn pixels(self, width: u32, height: u32) -> PixelBounds {
        let [x0, x1, y0, y1] = self.0;
        let at = |part: f32, count: u32| (f64::from(part) * f64::from(count)).ceil() as u32;
        PixelBounds([at(x0, width), at(x1, width), at(y0, height), at(y1, height)])
    }
}

impl PixelBounds {
    /// The bounds of a window.
    pub(crate) fn of(window: FilmWindow) -> Self {
        let FilmWindow { x, y, width, height } = window;
        Self([x, x + width, y, y + height])
    }

    fn window(self) -> FilmWindow {
        let [x0, x1, y0, y1] = self.0;
        FilmWindow { x: x0, y: y0, width: x1.saturating_sub(x0), height: y1.saturating_sub(y0) }
    }
}

impl std::fmt::Display for PixelBounds {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [x0, x1, y0, y1] = self.0;
        write!(f, "{x0},{x1},{y0},{y1}")
    }
}

impl FromStr for Crop {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let parts = four(text).filter(|&[x0, x1, y0, y1]: &[f32; 4]| {
            let is_range = |from: f32, to: f32| 0.0 <= from && from < to && to <= 1.0;
            is_range(x0, x1) && is_range(y0, y1)
        });
        parts.map(Self).ok_or("wanted as 0.25,0.75,0,0.5: from less to more, from 0 to 1")
    }
}

impl FromStr for PixelBounds {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let bounds = four(text).filter(|&[x0, x1, y0, y1]: &[u32; 4]| x0 < x1 && y0 < y1);
        bounds.map(Self).ok_or("wanted as 0,320,0,240: from less to more")
    }
}

/// The frame of a camera's picture, if that is a part of it.
pub(crate) fn frame(camera: &Camera) -> Option<PictureFrame> {
    let CameraSettings { width, height, .. } = camera.settings();
    let window = camera.window();
    let is_whole = window == FilmWindow::whole(width, height);
    let frame = PictureFrame { size: (width, height), corner: (window.x, window.y) };
    (!is_whole).then_some(frame)
}

/// Four numbers with commas between them.
fn four<T: FromStr>(text: &str) -> Option<[T; 4]> {
    let numbers: Result<Vec<T>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    numbers.ok()?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_that_meet_share_no_pixel_and_leave_none() {
        let halves = ["0,0.5,0,1", "0.5,1,0,1"].map(|text| text.parse::<Crop>().unwrap());
        for width in 1..50 {
            let [left, right] = halves.map(|half| half.pixels(width, 7));
            assert_eq!((left.0[1], right.0), (right.0[0], [left.0[1], width, 0, 7]), "{width}");
            assert_eq!(left.0[0], 0);
        }
    }

    #[test]
    fn rectangles_have_four_sides_in_their_order() {
        assert_eq!("1, 5,2,3".parse(), Ok(PixelBounds([1, 5, 2, 3])));
        for bad in ["", "1,5,2", "1,5,2,3,4", "5,1,2,3", "1,5,3,3", "-1,5,2,3", "0.5,5,2,3"] {
            assert!(bad.parse::<PixelBounds>().is_err(), "{bad}");
        }
        for bad in ["0,1,0,1.5", "-0.1,1,0,1", "0.5,0.5,0,1", "NaN,1,0,1", "0,inf,0,1"] {
            assert!(bad.parse::<Crop>().is_err(), "{bad}");
        }
    }
}
