//! The red, green, blue and white that the numbers of a picture mean.
//!
//! Light is turned into the bands of Rec. 709 by way of CIE XYZ. Where the whites
//! differ they are taken for each other, by Bradford's scaling of cones: a surface
//! that is white in its file shall be white here.

use traylib_math::glam::{DMat3, DVec3};

/// CIE x and y of the primaries and of white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Chromaticities {
    pub(crate) red: [f64; 2],
    pub(crate) green: [f64; 2],
    pub(crate) blue: [f64; 2],
    pub(crate) white: [f64; 2],
}

/// ITU-R BT.709, which the bands of [`Rgb`](traylib_math::Rgb) are.
const REC_709: Chromaticities = Chromaticities {
    red: [0.64, 0.33],
    green: [0.30, 0.60],
    blue: [0.15, 0.06],
    white: [0.3127, 0.3290],
};

/// The primaries and the white of Radiance pictures that say nothing of them. Nobody tells these
/// from Rec. 709, other programs that write the format least.
const RADIANCE: Chromaticities = Chromaticities {
    red: [0.640, 0.330],
    green: [0.290, 0.600],
    blue: [0.150, 0.060],
    white: [0.333, 0.333],
};

/// Coordinates are written with three or four digits.
const SAME: f64 = 1.5e-3;

/// The conversion from the bands of a picture to ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Conversion {
    /// They are ours.
    None,
    /// They are changed by this matrix.
    Matrix(DMat3),
}

impl Chromaticities {
    /// In the order in which files list them.
    pub(crate) fn from_list([rx, ry, gx, gy, bx, by, wx, wy]: [f64; 8]) -> Self {
        Self { red: [rx, ry], green: [gx, gy], blue: [bx, by], white: [wx, wy] }
    }

    /// `None` if no light can be meant.
    pub(crate) fn conversion(&self) -> Option<Conversion> {
        if self.is_near(&REC_709) || self.is_near(&RADIANCE) {
            return Some(Conversion::None);
        }
        let adapted = adaptation(self.white_xyz(), REC_709.white_xyz());
        let matrix = REC_709.to_xyz().inverse() * adapted * self.to_xyz();
        matrix.is_finite().then_some(Conversion::Matrix(matrix))
    }

    fn list(&self) -> [f64; 8] {
        let [[rx, ry], [gx, gy], [bx, by], [wx, wy]] =
            [self.red, self.green, self.blue, self.white];
        [rx, ry, gx, gy, bx, by, wx, wy]
    }

    fn is_near(&self, other: &Self) -> bool {
        self.list().iter().zip(other.list()).all(|(a, b)| (a - b).abs() <= SAME)
    }

    fn white_xyz(&self) -> DVec3 {
        xyz(self.white)
    }

    /// XYZ of the bands; white has Y = 1.
    fn to_xyz(self) -> DMat3 {
        let primaries = DMat3::from_cols(xyz(self.red), xyz(self.green), xyz(self.blue));
        primaries * DMat3::from_diagonal(primaries.inverse() * self.white_xyz())
    }
}

/// The colour of Y = 1 at these coordinates.
fn xyz([x, y]: [f64; 2]) -> DVec3 {
    DVec3::new(x / y, 1.0, (1.0 - x - y) / y)
}

/// Returns the matrix that adapts one white to another, in CIE XYZ.
///
/// Source: Lam, *Metamerism and Colour Constancy*, 1985; the numbers are those of
/// ICC.1:2022, annex E.
fn adaptation(from: DVec3, to: DVec3) -> DMat3 {
    let cones = DMat3::from_cols(
        DVec3::new(0.8951, -0.7502, 0.0389),
        DVec3::new(0.2664, 1.7135, -0.0685),
        DVec3::new(-0.1614, 0.0367, 1.0296),
    );
    cones.inverse() * DMat3::from_diagonal((cones * to) / (cones * from)) * cones
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(list: [f64; 8]) -> DMat3 {
        match Chromaticities::from_list(list).conversion() {
            Some(Conversion::Matrix(matrix)) => matrix,
            other => panic!("{other:?}"),
        }
    }

    const REC_2020: [f64; 8] = [0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290];

    #[test]
    fn rec_2020_is_converted_by_its_known_matrix() {
        // ITU-R BT.2087, equation for the inverse of its table.
        let rows =
            [[1.6605, -0.5876, -0.0728], [-0.1246, 1.1329, -0.0083], [-0.0182, -0.1006, 1.1187]];
        let found = matrix(REC_2020).transpose().to_cols_array_2d();
        for (row, expected) in found.iter().zip(rows) {
            for (a, b) in row.iter().zip(expected) {
                assert!((a - b).abs() < 1e-4, "{found:?}");
            }
        }
    }

    #[test]
    fn white_stays_white() {
        // ACES, whose white is that of about 6000 K.
        let aces = [0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.077, 0.32168, 0.33767];
        for list in [REC_2020, aces] {
            assert!((matrix(list) * DVec3::ONE - DVec3::ONE).length() < 1e-12);
        }
    }

    #[test]
    fn what_is_ours_stays_and_nonsense_is_none() {
        for same in [REC_709, RADIANCE] {
            assert_eq!(same.conversion(), Some(Conversion::None));
        }
        for list in [[0.3; 8], [0.0; 8], [f64::NAN; 8]] {
            assert_eq!(Chromaticities::from_list(list).conversion(), None);
        }
    }
}
