//! The pace of a method, and how coarse a preview must be to come at once.

use std::time::Duration;
use traylib_scene::Camera;

/// Time for a pixel, once it is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Pace {
    seconds_per_pixel: Option<f64>,
}

/// The seconds beyond which a picture needs a preview. Some 25 pictures in a second are motion.
const AT_ONCE: f64 = 0.04;

/// The preview of a method of which nothing is known: 64 pixels as one.
const UNKNOWN: u32 = 8;

/// Coarser nobody knows what it is.
const COARSEST: u32 = 16;

impl Pace {
    /// Returns how many pixels are to be drawn as one in each direction, for a preview of a picture
    /// of so many columns and rows: one if the picture itself comes at once.
    pub(crate) fn coarseness(self, width: u32, height: u32) -> u32 {
        let Some(seconds) = self.seconds_per_pixel else { return UNKNOWN };
        let whole = seconds * f64::from(width) * f64::from(height);
        ((whole / AT_ONCE).sqrt().ceil() as u32).clamp(1, COARSEST)
    }

    /// A pass over a picture has taken so long.
    pub(crate) fn measure(&mut self, camera: &Camera, time: Duration) {
        let pixels = f64::from(camera.width()) * f64::from(camera.height());
        self.seconds_per_pixel = Some(time.as_secs_f64() / pixels);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_takes_long_gets_a_preview_that_does_not() {
        let of = |seconds_per_pixel: f64| {
            Pace { seconds_per_pixel: Some(seconds_per_pixel) }.coarseness(1000, 1000)
        };
        assert_eq!([3.9e-8, 1.5e-7, 3.5e-7, 1.0].map(of), [1, 2, 3, COARSEST]);
        assert_eq!(Pace::default().coarseness(1000, 1000), UNKNOWN);
    }
}
