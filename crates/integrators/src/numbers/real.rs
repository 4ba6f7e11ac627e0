//! The numbers of a path that are coordinates of a point of Sobol's sequence.

use super::{Purpose, SEQUENCES, VertexNumbers};
use traylib_math::sampler::{fine_unit, hash, mix, unit};
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

/// The coordinates of a point, handed out in pairs and one by one.
///
/// What has two numbers takes a pair, which is as even as two can be: pairs are handed out from
/// the first on, single numbers from the last pair down, until they meet.
///
/// A coordinate is shifted by exclusive or with bits that belong to the seed, the sequence,
/// the path's own number and the coordinate: that leaves the evenness of all points that
/// share the shift, and makes those of different shifts independent.
#[derive(Clone, Debug)]
pub(crate) struct RealNumbers {
    point: [[u32; 2]; sobol::PAIRS],
    key: u64,
    /// Handed out so far.
    pairs: usize,
    /// Handed out so far, beside the pairs.
    singles: usize,
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
        Self { point, key, pairs: 0, singles: 0, purpose: Purpose::Camera, dimensions }
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
        Self { point, key, pairs: 0, singles: 0, purpose: Purpose::Light, dimensions }
    }

    /// Coordinates that are left.
    #[inline]
    fn left(&self) -> usize {
        2 * (sobol::PAIRS - self.pairs) - self.singles
    }

    /// A pair of the point, shifted.
    #[inline]
    fn shifted(&self, pair: usize) -> [u32; 2] {
        let [x, y] = self.point[pair];
        // One hash serves both.
        let step = (pair as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let shifts = mix(self.key.wrapping_add(step));
        [x ^ shifts as u32, y ^ (shifts >> 32) as u32]
    }

    /// Puts the next pair in the place of two numbers, as long as there is one.
    #[inline]
    fn replace_pair(&mut self, numbers: [&mut f32; 2]) {
        if self.left() < 2 {
            return;
        }
        for (number, bits) in numbers.into_iter().zip(self.shifted(self.pairs)) {
            *number = unit(bits);
        }
        self.pairs += 1;
    }

    /// The next single coordinate, as long as there is one.
    #[inline]
    fn single(&mut self) -> Option<u32> {
        if self.left() == 0 {
            return None;
        }
        let pair = self.shifted(sobol::PAIRS - 1 - self.singles / 2);
        self.singles += 1;
        Some(pair[self.singles % 2])
    }

    /// Puts two coordinates in the place of a point of the unit square.
    #[inline]
    pub(crate) fn replace_square(&mut self, Vec2 { x, y }: &mut Vec2) {
        self.replace_pair([x, y]);
    }

    /// Puts coordinates in the place of those numbers that decide most: where on which
    /// light, then in which direction by which lobe.
    #[inline]
    pub(crate) fn replace_vertex(&mut self, numbers: &mut VertexNumbers) {
        if self.left() == 0 {
            return;
        }
        let starts_at_light = self.purpose == Purpose::Light && self.pairs == 0;
        // A light path chooses its light once.
        if self.purpose == Purpose::Camera || starts_at_light {
            if self.dimensions.light_point {
                self.replace_square(&mut numbers.light_point);
            }
            if self.dimensions.light_pick
                && let Some(bits) = self.single()
            {
                numbers.light_pick = fine_unit(bits);
            }
        }
        let [lobe, x, y] = &mut numbers.bsdf;
        self.replace_pair([x, y]);
        if self.dimensions.lobe
            && !starts_at_light
            && let Some(bits) = self.single()
        {
            *lobe = unit(bits);
        }
    }
}
