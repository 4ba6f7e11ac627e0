//! A thin sheet through which light is scattered.

use super::phong::Phong;
use crate::error::{Error, check_energy};
use crate::scattering::Scattering;
use traylib_math::{Rgb, SolidAnglePdf, Vec3};

/// A sheet without thickness that reflects like one Phong surface and passes
/// light like another, whose lobe is about the straight direction: frosted
/// glass, paper, leaves.
///
/// The light that passes with the direction wi is that which the second would reflect into the
/// mirror image of wi in the sheet, f(wo, wi) = f₂(wo, wi − 2(wi·n)n), so that the sheet is
/// reciprocal as Phong's model is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    reflection: Phong,
    transmission: Phong,
    /// Chance to sample the transmission.
    through_chance: f32,
}

impl Sheet {
    /// A sheet with these parts.
    ///
    /// # Errors
    /// [`Error::Energy`] if they pass on more than arrives.
    pub fn new(reflection: Phong, transmission: Phong) -> Result<Self, Error> {
        let parts = [reflection.albedo_bound(), transmission.albedo_bound()];
        check_energy(("reflection", parts[0]), ("transmission", parts[1]))?;
        let [reflected, passed] = parts.map(Rgb::luminance);
        let sum = reflected + passed;
        let through_chance = if sum > 0.0 { passed / sum } else { 0.0 };
        Ok(Self { reflection, transmission, through_chance })
    }

    /// The part that throws light back.
    pub fn reflection(&self) -> Phong {
        self.reflection
    }

    /// The part that lets light through.
    pub fn transmission(&self) -> Phong {
        self.transmission
    }

    #[inline]
    pub(crate) fn evaluate(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Scattering {
        let (part, chance) = if normal.dot(wi) < 0.0 {
            (self.transmission.evaluate_through(normal, wo, wi), self.through_chance)
        } else {
            (self.reflection.evaluate(normal, wo, wi), 1.0 - self.through_chance)
        };
        let Scattering { f, pdf, pdf_reverse } = part;
        let [pdf, pdf_reverse] = [pdf, pdf_reverse].map(|pdf| SolidAnglePdf(chance * pdf.0));
        Scattering { f, pdf, pdf_reverse }
    }

    /// A direction from one of the parts; `None` where its lobe dipped through
    /// the surface. One number chooses the part and its lobe.
    #[inline]
    pub(crate) fn direction(&self, normal: Vec3, wo: Vec3, u: [f32; 3]) -> Option<Vec3> {
        let chance = self.through_chance;
        let through = u[0] < chance;
        let (part, lobe) = if through {
            (&self.transmission, u[0] / chance)
        } else {
            (&self.reflection, (u[0] - chance) / (1.0 - chance))
        };
        let wi = part.direction(normal, wo, [lobe, u[1], u[2]]);
        let wi = if through { mirrored(normal, wi) } else { wi };
        (through == (normal.dot(wi) < 0.0)).then_some(wi)
    }
}

/// The mirror image of a direction in the sheet.
fn mirrored(normal: Vec3, wi: Vec3) -> Vec3 {
    wi - 2.0 * normal.dot(wi) * normal
}
