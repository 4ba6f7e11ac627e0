//! A glossy lobe in coordinates of its own.
//!
//! Around the mirror direction R, with α the angle to it and φ the azimuth from
//! the plane of R and the normal N, a lobe of exponent n has the density
//! (n+1)/(2π)·cosⁿα per steradian. With u = cosⁿ⁺¹α, du = (n+1)·cosⁿα·d(cosα), so
//! that is the density 1/(2π) in (u, φ): uniform at any exponent, where a grid in
//! ordinary angles would see the lobe in a single cell.
//!
//! A direction of the lobe has N·w = cosθ·cosα + sinθ·sinα·cosφ. It lies above the
//! horizon for |φ| < φₘ, cosφₘ = −cosθ·cosα/(sinθ·sinα), so integrals over φ have
//! closed forms, and integrals over u or cosα are left to the midpoint rule.

use crate::grid::{At, SIDE};
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use traylib_geometry::Vec3;

/// Steps of the midpoint rule across a row of cells.
const FINE: usize = 256;

/// A lobe of one exponent above the surface z = 0, for one direction `wo`.
#[derive(Clone, Copy, Debug)]
pub struct Lobe {
    exponent: f64,
    /// R, then the axis of φ = 0 and of a quarter turn.
    axes: [DVec3; 3],
    /// The cosine of the angle between R and the normal.
    cos: f64,
    sin: f64,
}

/// The azimuths of one α that are above the horizon, and the terms of N·w there.
struct Ring {
    half: f64,
    constant: f64,
    amplitude: f64,
}

impl Lobe {
    /// Makes the lobe of light that leaves toward `wo`, above the surface z = 0.
    pub fn new(exponent: f32, wo: Vec3) -> Self {
        let wo = DVec3::from(wo).normalize();
        let mirrored = DVec3::new(-wo.x, -wo.y, wo.z);
        let sin = wo.x.hypot(wo.y);
        let up = DVec3::Z - mirrored * mirrored.z;
        let first = if sin > 0.0 { up.normalize() } else { DVec3::X };
        let axes = [mirrored, first, mirrored.cross(first)];
        Self { exponent: f64::from(exponent), axes, cos: wo.z, sin }
    }

    /// (u, φ) of a direction in the unit square, φ = 0 in the middle; `None` a
    /// right angle or more from R.
    pub fn coordinates(&self, w: Vec3) -> Option<At> {
        let [mirrored, first, second] = self.axes;
        let w = DVec3::from(w).normalize();
        // 1 − cosα without cancellation.
        let one_minus_cos = 0.5 * (w - mirrored).length().powi(2);
        (one_minus_cos < 1.0).then(|| {
            let u = ((self.exponent + 1.0) * f64::ln_1p(-one_minus_cos)).exp();
            let azimuth = w.dot(second).atan2(w.dot(first));
            [azimuth / TAU + 0.5, u]
        })
    }

    /// For each cell of the square of [`coordinates`](Self::coordinates) the
    /// part of the lobe there that is above the horizon.
    pub fn visible(&self) -> Vec<f64> {
        self.rows(|u0, u1| crowded(u1, u0, 1.0 / TAU), |u| self.one_minus_cos(u), Ring::length)
    }

    /// For each cell what a diffuse surface, cosθ/π, scatters there.
    pub fn diffuse(&self) -> Vec<f64> {
        self.rows(
            |u0, u1| crowded(self.one_minus_cos(u1), self.one_minus_cos(u0), 1.0 / PI),
            |one_minus_cos| one_minus_cos,
            Ring::cosine,
        )
    }

    /// The part of the lobe below the horizon. The lobe reaches it at a right angle to the
    /// normal; all u above that are visible, and where these are nearly all, what is left
    /// would be lost in a difference from one.
    pub fn hidden(&self) -> f64 {
        const STEPS: usize = 64 * FINE;
        let reached = self.sin.powf(self.exponent + 1.0);
        let step = reached / STEPS as f64;
        let rings = (0..STEPS).map(|i| self.ring(self.one_minus_cos((i as f64 + 0.5) * step)));
        rings.map(|ring| step * (1.0 - ring.half / PI)).sum()
    }

    /// The share of light that a modified Phong lobe with ks = 1 reflects:
    /// ∫ (n+2)/(2π)·cosⁿα·N·w dω, whose density in (u, φ) is (n+2)/(n+1)/(2π).
    pub fn phong_albedo(&self) -> f64 {
        (self.exponent + 2.0) / (self.exponent + 1.0) * self.mean(64 * FINE, Ring::cosine)
    }

    /// Computes the albedo of a Max-Phong lobe: its density in (u, φ) is 1/(2π) times
    /// N·w/max(N·w, cosθ).
    pub fn max_phong_albedo(&self) -> f64 {
        const STEPS: usize = 512;
        self.mean(4 * FINE, |ring, from, to| {
            let step = (to - from) / STEPS as f64;
            let azimuths = (0..STEPS).map(|i| from + (i as f64 + 0.5) * step);
            azimuths.map(|phi| step * (ring.at(phi) / self.cos).clamp(0.0, 1.0)).sum()
        })
    }

    /// The mean of `over` all azimuths, with the lobe's density, from so many u.
    fn mean(&self, steps: usize, over: impl Fn(&Ring, f64, f64) -> f64) -> f64 {
        let rings =
            (0..steps).map(|i| self.ring(self.one_minus_cos((i as f64 + 0.5) / steps as f64)));
        rings.map(|ring| over(&ring, -PI, PI)).sum::<f64>() / (TAU * steps as f64)
    }

    /// Cell by cell, the sum over some points across a row of `over` the
    /// azimuths of a cell. `points` has values, from which `one_minus_cos` makes 1 − cosα,
    /// and weights.
    fn rows(
        &self,
        points: impl Fn(f64, f64) -> Vec<(f64, f64)>,
        one_minus_cos: impl Fn(f64) -> f64,
        over: impl Fn(&Ring, f64, f64) -> f64,
    ) -> Vec<f64> {
        let edge = |i: usize| i as f64 / SIDE as f64;
        let azimuth = |i: usize| (edge(i) - 0.5) * TAU;
        let mut cells = vec![0.0; SIDE * SIDE];
        for (row, cells) in cells.chunks_exact_mut(SIDE).enumerate() {
            for (point, weight) in points(edge(row), edge(row + 1)) {
                let ring = self.ring(one_minus_cos(point));
                for (column, cell) in cells.iter_mut().enumerate() {
                    *cell += weight * over(&ring, azimuth(column), azimuth(column + 1));
                }
            }
        }
        cells
    }

    /// 1 − cosα at this u; one for u = 0.
    fn one_minus_cos(&self, u: f64) -> f64 {
        -(u.ln() / (self.exponent + 1.0)).exp_m1()
    }

    fn ring(&self, one_minus_cos: f64) -> Ring {
        let sin_alpha = (one_minus_cos * (2.0 - one_minus_cos)).sqrt();
        let (constant, amplitude) = (self.cos * (1.0 - one_minus_cos), self.sin * sin_alpha);
        // All azimuths, where the amplitude is too small to reach the horizon.
        let half = (-constant / amplitude.max(f64::MIN_POSITIVE)).clamp(-1.0, 1.0).acos();
        Ring { half, constant, amplitude }
    }
}

impl Ring {
    /// N·w.
    fn at(&self, phi: f64) -> f64 {
        self.constant + self.amplitude * phi.cos()
    }

    fn clamp(&self, from: f64, to: f64) -> [f64; 2] {
        [from, to].map(|phi| phi.clamp(-self.half, self.half))
    }

    /// Returns how much of these azimuths is above the horizon.
    fn length(&self, from: f64, to: f64) -> f64 {
        let [from, to] = self.clamp(from, to);
        to - from
    }

    /// ∫ max(0, N·w) dφ.
    fn cosine(&self, from: f64, to: f64) -> f64 {
        let [from, to] = self.clamp(from, to);
        self.constant * (to - from) + self.amplitude * (to.sin() - from.sin())
    }
}

/// Points from `near` to `far` and their weights for the midpoint rule, `scale`
/// for the whole of a unit length.
///
/// They crowd at the near end as squares do: the nearer to R, the more azimuths
/// are above the horizon, so a cell that the horizon hardly leaves a corner has
/// it there.
fn crowded(near: f64, far: f64, scale: f64) -> Vec<(f64, f64)> {
    let step = 1.0 / FINE as f64;
    let middles = (0..FINE).map(|i| (i as f64 + 0.5) * step);
    let weight = 2.0 * step * scale * (far - near).abs();
    middles.map(|x| (near + (far - near) * x * x, weight * x)).collect()
}

#[cfg(test)]
mod tests;
