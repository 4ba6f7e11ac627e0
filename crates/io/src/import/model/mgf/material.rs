//! From MGF's materials to models.
//!
//! | material | model |
//! |---|---|
//! | rd | Lambert |
//! | rs of roughness a ≥ 0.005 | Phong with n = 1/(2a²), at least 1 |
//! | rs smoother than that | mirror, with rd as its diffuse part |
//! | td, or ts of roughness ≥ 0.005 | sheet; a mirror's part of it is a lobe of n = 10⁶ |
//! | ts smoother than that | passes straight through |
//! | ts smooth, one-sided, index n > 1 and k = 0 | solid clear glass of index n |
//! | ed | radiance ed/(π·179), after Radiance's 179 lm/W |
//!
//! MGF's lobe is Gaussian in the slope of facets, exp(−tan²θ/a²) for the half
//! vector at θ: about its middle that of cosⁿ with n = 2/a², and for the mirror
//! direction, which turns by twice the angle, n = 1/(2a²).

use crate::import::counter::Counter;
use crate::import::imported_material::ImportedMaterial;
use crate::mgf::{self, Part};
use std::f32::consts::PI;
use traylib_geometry::Sides;
use traylib_materials::{Dielectric, Error, Lambert, Material, Mirror, Phong, Sheet, SurfaceModel};
use traylib_math::Rgb;

/// Less rough than this is smooth: a lobe of n = 20,000 is a degree wide.
const SMOOTH: f32 = 0.005;
/// The sharpest lobe there is.
const SHARPEST: f32 = 1e6;
/// Lumens a watt that Radiance takes for light of equal energy.
const LUMENS_PER_WATT: f32 = 179.0;

/// A material as it can be rendered.
pub(super) fn imported(
    material: &mgf::Material,
    counter: &mut Counter,
) -> Result<ImportedMaterial, Error> {
    let emission = positive(material.ed.rgb()) / (PI * LUMENS_PER_WATT);
    let name = material.name.to_string();
    if let Some(glass) = solid_glass(material, counter) {
        let material = SurfaceModel::Dielectric(glass).into();
        return Ok(ImportedMaterial { name, surface: material, sides: Sides::Both, emission });
    }
    let fractions = fractions(material, counter);
    let roughness = [material.rs_roughness, material.ts_roughness];
    let sides = if material.two_sided { Sides::Both } else { Sides::Front };
    Ok(ImportedMaterial { name, surface: scattering(fractions, roughness)?, sides, emission })
}

/// The boundary of a solid. What glass absorbs is not rendered.
fn solid_glass(material: &mgf::Material, counter: &mut Counter) -> Option<Dielectric> {
    let [n, k] = material.ir;
    let clear = material.ts.amount > 0.0 && material.ts_roughness < SMOOTH;
    if material.two_sided || !clear || k != 0.0 || n <= 1.0 {
        return None;
    }
    let glass = Dielectric::new(n).ok()?;
    counter
        .add(format!("material `{}` taken for clear glass, with its index alone", material.name));
    Some(glass)
}

/// rd, td, rs and ts, in each band no more than arrives.
fn fractions(material: &mgf::Material, counter: &mut Counter) -> [Rgb; 4] {
    let parts = [material.rd, material.td, material.rs, material.ts].map(Part::rgb).map(positive);
    let sum: Rgb = parts.into_iter().sum();
    if sum.max_band() > 1.0 + 1e-6 {
        counter
            .add("material whose colour scatters more than arrives in a band, scaled down there");
    }
    let scale = Rgb::from(sum.to_array().map(|band| band.max(1.0).recip()));
    parts.map(|part| (part * scale).saturated())
}

fn positive(light: Rgb) -> Rgb {
    Rgb::from(light.to_array().map(|band| band.max(0.0)))
}

fn scattering([rd, td, rs, ts]: [Rgb; 4], [a, b]: [f32; 2]) -> Result<Material, Error> {
    let (through, hazy) = if b < SMOOTH { (ts, Rgb::BLACK) } else { (Rgb::BLACK, ts) };
    let model = if td.is_black() && hazy.is_black() {
        reflection(rd, rs, a)?
    } else {
        let reflection = Phong::new(rd, rs, exponent(a))?;
        SurfaceModel::Sheet(Sheet::new(reflection, Phong::new(td, hazy, exponent(b))?)?)
    };
    Ok(Material { through, ..Material::from(model) })
}

fn reflection(rd: Rgb, rs: Rgb, roughness: f32) -> Result<SurfaceModel, Error> {
    Ok(if rs.is_black() {
        SurfaceModel::Lambert(Lambert::new(rd)?)
    } else if roughness < SMOOTH {
        SurfaceModel::Mirror(Mirror::new(rs, rd)?)
    } else {
        SurfaceModel::Phong(Phong::new(rd, rs, exponent(roughness))?)
    })
}

fn exponent(roughness: f32) -> f32 {
    (0.5 / (roughness * roughness)).clamp(1.0, SHARPEST)
}

#[cfg(test)]
mod tests;
