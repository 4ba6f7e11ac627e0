//! Point lights that shine into a cone.

use crate::Error;
use std::f64::consts::TAU;
use traylib_math::{SolidAnglePdf, Vec2, Vec3, warp};

/// The cone that a spot light shines into: full intensity up to one angle from
/// the axis, none beyond another, and between them a smooth step of the *angle*,
/// t²(3 − 2t) with t = (θ_dark − θ)/(θ_dark − θ_full).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotCone {
    /// Unit vector along the middle of the light.
    pub axis: Vec3,
    /// Cosine of the angle up to which intensity is full.
    pub cos_full: f32,
    /// Cosine of the angle from which on it is dark, at most `cos_full`.
    pub cos_dark: f32,
}

impl SpotCone {
    /// The cone around an axis of any length.
    ///
    /// # Errors
    /// [`Error::Spot`] for an axis without direction, for what is no cosine, and
    /// for a cone that holds no direction or is dark before it stops being full.
    pub fn new(axis: Vec3, cos_full: f32, cos_dark: f32) -> Result<Self, Error> {
        let axis = axis.try_normalize().ok_or(Error::Spot("the axis has no direction"))?;
        if !(-1.0 <= cos_dark && cos_dark <= cos_full && cos_full <= 1.0) {
            return Err(Error::Spot("cosines must obey −1 ≤ cos_dark ≤ cos_full ≤ 1"));
        }
        if cos_dark >= 1.0 {
            return Err(Error::Spot("the cone holds no direction"));
        }
        Ok(Self { axis, cos_full, cos_dark })
    }

    /// The part of the full intensity that goes into the unit `direction`.
    pub fn falloff(&self, direction: Vec3) -> f32 {
        let one_minus_cos = self.one_minus_cos(direction);
        if one_minus_cos <= 1.0 - self.cos_full {
            return 1.0;
        }
        if one_minus_cos >= 1.0 - self.cos_dark {
            return 0.0;
        }
        let dark = angle(1.0 - self.cos_dark);
        let t = (dark - angle(one_minus_cos)) / (dark - angle(1.0 - self.cos_full));
        t * t * (3.0 - 2.0 * t)
    }

    /// A direction of the cone, all of them alike.
    pub(super) fn sample(&self, u: Vec2) -> Vec3 {
        warp::uniform_cone(self.axis, 1.0 - self.cos_dark, u)
    }

    /// Density of [`sample`](Self::sample).
    pub(super) fn pdf(&self, direction: Vec3) -> SolidAnglePdf {
        let width = 1.0 - self.cos_dark;
        let inside = self.one_minus_cos(direction) <= width;
        SolidAnglePdf(if inside { 1.0 / (std::f32::consts::TAU * width) } else { 0.0 })
    }

    /// ∫ falloff dω, in steradians.
    ///
    /// With m the mean and h half the difference of the two angles, integration by
    /// parts gives 2π·(1 − cos m·3·(sin h − h·cos h)/h³).
    pub fn solid_angle(&self) -> f32 {
        let [full, dark] = [self.cos_full, self.cos_dark].map(|cosine| f64::from(cosine).acos());
        let (mean, half) = (0.5 * (full + dark), 0.5 * (dark - full));
        (TAU * (1.0 - mean.cos() * softness(half))) as f32
    }

    /// 1 − cosθ, without cancellation: half the square of the distance between
    /// unit vectors.
    fn one_minus_cos(&self, direction: Vec3) -> f32 {
        0.5 * (direction - self.axis).length_squared()
    }
}

/// θ from 1 − cosθ = 2·sin²(θ/2).
fn angle(one_minus_cos: f32) -> f32 {
    2.0 * (0.5 * one_minus_cos).sqrt().min(1.0).asin()
}

/// 3·(sin h − h·cos h)/h³; near zero, where that cancels, by its series, whose next
/// term is below 10⁻¹⁴.
fn softness(h: f64) -> f64 {
    if h < 0.1 {
        let square = h * h;
        return 1.0 - square / 10.0 * (1.0 - square / 28.0 * (1.0 - square / 54.0));
    }
    3.0 * (h.sin() - h * h.cos()) / h.powi(3)
}

#[cfg(test)]
mod tests;
