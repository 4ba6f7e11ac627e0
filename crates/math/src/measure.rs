//! Densities and the measures they belong to.
//!
//! A direction is drawn with a density per steradian, a point on a surface with
//! a density per square metre. The two differ by [`solid_angle_per_area`], which
//! is written here and nowhere else.

/// A probability density per steradian.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct SolidAnglePdf(pub f32);

/// A probability density per unit of area (square metre, unless the caller
/// states a unit of its own).
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct AreaPdf(pub f32);

/// Steradians that a unit of area fills, seen from `distance_squared` away at an
/// angle with cosine `cosine` to its normal: dω/dA = cosθ/d².
///
/// The paper's equation 5. The sign of the cosine does not matter.
pub fn solid_angle_per_area(cosine: f32, distance_squared: f32) -> f32 {
    cosine.abs() / distance_squared
}

impl SolidAnglePdf {
    /// The density per area of the point that such a direction meets, with
    /// `conversion` from [`solid_angle_per_area`].
    ///
    /// The paper's equation 6 turns a density for one viewpoint into that for
    /// another; its last member drops the density itself. The way through the
    /// area measure, here and in [`AreaPdf::to_solid_angle`], is the whole of it.
    pub fn to_area(self, conversion: f32) -> AreaPdf {
        AreaPdf(self.0 * conversion)
    }
}

impl AreaPdf {
    /// The density per steradian of the direction toward such a point, with
    /// `conversion` from [`solid_angle_per_area`].
    pub fn to_solid_angle(self, conversion: f32) -> SolidAnglePdf {
        SolidAnglePdf(self.0 / conversion)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_small_patch_fills_its_share_of_the_sphere() {
        // A patch of side 0.01 at distance 2, tilted by 60 degrees.
        let steradians = solid_angle_per_area(0.5, 4.0) * 1e-4;
        assert!((steradians - 1.25e-5).abs() < 1e-11);
    }

    #[test]
    fn conversion_there_and_back() {
        let conversion = solid_angle_per_area(-0.25, 9.0);
        let back = SolidAnglePdf(0.7).to_area(conversion).to_solid_angle(conversion);
        assert!((back.0 - 0.7).abs() < 1e-6);
    }
}
