//! The eye: CIE 1931 standard observer, 2 degrees.

use std::sync::LazyLock;

/// First and last wavelength, in nm.
pub(super) const FIRST: u32 = 380;
pub(super) const LAST: u32 = 780;
const STEP: u32 = 10;

/// Each curve in steps of 10 nm, times 10⁴.
const X: [u16; 41] = [
    14, 42, 143, 435, 1344, 2839, 3483, 3362, 2908, 1954, 956, 320, 49, 93, 633, 1655, 2904, 4334,
    5945, 7621, 9163, 10263, 10622, 10026, 8544, 6424, 4479, 2835, 1649, 874, 468, 227, 114, 58,
    29, 14, 7, 3, 2, 1, 0,
];
const Y: [u16; 41] = [
    0, 1, 4, 12, 40, 116, 230, 380, 600, 910, 1390, 2080, 3230, 5030, 7100, 8620, 9540, 9950, 9950,
    9520, 8700, 7570, 6310, 5030, 3810, 2650, 1750, 1070, 610, 320, 170, 82, 41, 21, 10, 5, 2, 1,
    1, 0, 0,
];
const Z: [u16; 41] = [
    65, 201, 679, 2074, 6456, 13856, 17471, 17721, 16692, 12876, 8130, 4652, 2720, 1582, 782, 422,
    203, 87, 39, 21, 17, 11, 8, 3, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
];

/// X, Y and Z of a spectrum, given by its power at each wavelength in nm; a
/// flat one of 1 has X = Y = Z = 1.
pub(super) fn xyz(power: impl Fn(f64) -> f64) -> [f64; 3] {
    let (mut sums, mut flat) = ([0.0; 3], [0.0; 3]);
    for (wavelength, responses) in (FIRST..=LAST).zip(&*RESPONSES) {
        let power = power(f64::from(wavelength));
        for (axis, response) in responses.iter().enumerate() {
            sums[axis] += power * response;
            flat[axis] += response;
        }
    }
    std::array::from_fn(|axis| sums[axis] / flat[axis])
}

/// The three curves at each wavelength.
static RESPONSES: LazyLock<Vec<[f64; 3]>> = LazyLock::new(|| {
    (FIRST..=LAST).map(|at| [&X, &Y, &Z].map(|curve| response(curve, at))).collect()
});

fn response(curve: &[u16; 41], wavelength: u32) -> f64 {
    let (index, beyond) = ((wavelength - FIRST) / STEP, (wavelength - FIRST) % STEP);
    let at = |index: u32| f64::from(curve[(index as usize).min(curve.len() - 1)]);
    let part = f64::from(beyond) / f64::from(STEP);
    at(index) * (1.0 - part) + at(index + 1) * part
}
