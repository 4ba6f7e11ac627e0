//! The numbers of a path that are coordinates of a point of Sobol's sequence.

use super::{Purpose, SEQUENCES, VertexNumbers};
use traylib_math::sampler::{hash, mix};
use traylib_math::{Vec2, sobol};
use traylib_scene::{Light, Scene};

/// The numbers of a vertex that a scene uses: an unused one takes no dimension of the sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimensions {
    /// Some light has an area, and a place on it.
    pub light_point: bool,
    /// There is a choice of lights.
    pub light_pick: bool,
    /// Some surface has a choice of lobes.
    pub lobe: bool,
}

impl Dimensions {
    /// Counts the dimensions of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            light_point: scene.lights().iter().any(|light| !Light::is_point(light)),
            light_pick: scene.lights().len() > 1,
            lobe: scene.materials().iter().any(|material| material.model.chooses_lobe()),
        }
    }
}

/// The coordinates of a point, handed out one by one.
///
/// A coordinate is shifted by exclusive or with bits that belong to the seed, the sequence,
/// the path's own number and the dimension: that leaves the evenness of all points that
/// share the shift, and makes those of different shifts independent.
#[derive(Clone, Debug)]
pub(crate) struct RealNumbers {
    point: [u32; sobol::DIMENSIONS],
    key: u64,
    /// One serves two dimensions.
    shifts: u64,
    used: usize,
    purpose: Purpose,
    dimensions: Dimensions,
}

/// The first parts of numbers that shifts are hashed from, beside those of
/// [`Purpose`] and [`Sampler::TESTS`](traylib_math::Sampler::TESTS).
const SHIFTS: u64 = 3;
const ROTATIONS: u64 = 5;

/// The place of a pass: its sequence, and its number in that.
fn place(pass: u64) -> (u64, u64) {
    let sequences = u64::from(SEQUENCES);
    (pass % sequences, pass / sequences)
}

/// Returns the rotation of the `count` light paths of a pass within its run of the sequence.
///
/// A pixel that is always joined with the light path of one number would meet the points at
/// a stride of their count, all in one strip, and never see the others.
pub(crate) fn rotation(seed: u64, pass: u64, count: u32) -> u64 {
    hash(seed, [ROTATIONS, pass, 0]) % u64::from(count.max(1))
}

impl RealNumbers {
    /// Makes the numbers of a pixel: each pass gives all pixels the same point.
    pub(crate) fn of_pixel(seed: u64, pass: u64, pixel: u32, dimensions: Dimensions) -> Self {
        let (sequence, number) = place(pass);
        let point = sobol::point(number);
        let key = hash(seed, [SHIFTS + Purpose::Camera as u64, sequence, u64::from(pixel)]);
        Self { point, key, shifts: 0, used: 0, purpose: Purpose::Camera, dimensions }
    }

    /// Makes the numbers of a light path, one of `count` in a pass that is turned by [`rotation`]:
    /// light paths of all passes number themselves through.
    pub(crate) fn of_light_path(
        seed: u64,
        pass: u64,
        path: u32,
        (rotation, count): (u64, u32),
        dimensions: Dimensions,
    ) -> Self {
        let (sequence, number) = place(pass);
        let count = u64::from(count.max(1));
        let point = sobol::point(number * count + (u64::from(path) + rotation) % count);
        let key = hash(seed, [SHIFTS + Purpose::Light as u64, sequence, 0]);
        Self { point, key, shifts: 0, used: 0, purpose: Purpose::Light, dimensions }
    }

    /// The next coordinate, as long as there are any.
    #[inline]
    fn next(&mut self) -> Option<u32> {
        let coordinate = *self.point.get(self.used)?;
        if self.used.is_multiple_of(2) {
            self.key = self.key.wrapping_add(0x9e37_79b9_7f4a_7c15);
            self.shifts = mix(self.key);
        } else {
            self.shifts >>= 32;
        }
        self.used += 1;
        Some(coordinate ^ self.shifts as u32)
    }

    #[inline]
    fn replace(&mut self, number: &mut f32) {
        if let Some(bits) = self.next() {
            *number = (bits >> 8) as f32 * (1.0 / (1 << 24) as f32);
        }
    }

    /// Puts two coordinates in the place of a point of the unit square.
    #[inline]
    pub(crate) fn replace_square(&mut self, square: &mut Vec2) {
        self.replace(&mut square.x);
        self.replace(&mut square.y);
    }

    /// Puts coordinates in the place of those numbers that decide most: where on which
    /// light, then in which direction by which lobe.
    #[inline]
    pub(crate) fn replace_vertex(&mut self, numbers: &mut VertexNumbers) {
        if self.used == sobol::DIMENSIONS {
            return;
        }
        let starts_at_light = self.purpose == Purpose::Light && self.used == 0;
        // A light path chooses its light once.
        if self.purpose == Purpose::Camera || starts_at_light {
            if self.dimensions.light_point {
                self.replace_square(&mut numbers.light_point);
            }
            if self.dimensions.light_pick
                && let Some(bits) = self.next()
            {
                numbers.light_pick = f64::from(bits) * (1.0 / (1_u64 << 32) as f64);
            }
        }
        let [lobe, x, y] = &mut numbers.bsdf;
        self.replace(x);
        self.replace(y);
        if self.dimensions.lobe && !starts_at_light {
            self.replace(lobe);
        }
    }
}
