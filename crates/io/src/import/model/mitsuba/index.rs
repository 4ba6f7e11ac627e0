//! Indices of refraction, and what boundaries of clear solids reflect.

use super::fields::Fields;
use crate::mitsuba::Value;

/// Indices by the names that scenes use.
const NAMED: [(&str, f64); 23] = [
    ("vacuum", 1.0),
    ("helium", 1.000_036),
    ("hydrogen", 1.000_132),
    ("air", 1.000_277),
    ("carbon dioxide", 1.000_45),
    ("water", 1.333),
    ("acetone", 1.36),
    ("ethanol", 1.361),
    ("carbon tetrachloride", 1.461),
    ("glycerol", 1.4729),
    ("benzene", 1.501),
    ("silicone oil", 1.520_45),
    ("bromine", 1.661),
    ("water ice", 1.31),
    ("fused quartz", 1.458),
    ("pyrex", 1.47),
    ("acrylic glass", 1.49),
    ("polypropylene", 1.49),
    ("bk7", 1.5046),
    ("sodium chloride", 1.544),
    ("amber", 1.55),
    ("pet", 1.575),
    ("diamond", 2.419),
];

/// The index of the inside over that of the outside, by `int_ior` and `ext_ior`, which are numbers
/// or names; the usual inside is a name.
pub(super) fn relative(fields: &mut Fields<'_>, inside: &str) -> f64 {
    let mut index = |name, usual| {
        let given = fields
            .of_kind(name, |value| if let Value::Text(text) = value { named(text) } else { None });
        let given = given.or_else(|| fields.number(name));
        given.or_else(|| named(usual)).unwrap_or(1.0)
    };
    index("int_ior", inside) / index("ext_ior", "air")
}

fn named(name: &str) -> Option<f64> {
    NAMED.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|&(_, index)| index)
}

/// Returns the reflectance at normal incidence.
pub(super) fn straight(index: f64) -> f64 {
    ((index - 1.0) / (index + 1.0)).powi(2)
}

/// Returns the part that a boundary reflects inward of light that comes from all directions alike.
///
/// ∫ F(cos θ) 2 cos θ d(cos θ), by the middles of steps; F is that of unpolarised light.
pub(super) fn back_inside(index: f64) -> f64 {
    const STEPS: u32 = 1000;
    let relative = index.recip();
    let reflected = |step: u32| {
        let cosine = (f64::from(step) + 0.5) / f64::from(STEPS);
        2.0 * cosine * fresnel(cosine, relative)
    };
    (0..STEPS).map(reflected).sum::<f64>() / f64::from(STEPS)
}

fn fresnel(cosine: f64, index: f64) -> f64 {
    let square = (1.0 - cosine * cosine) / (index * index);
    if square >= 1.0 {
        return 1.0;
    }
    let beyond = (1.0 - square).sqrt();
    let parallel = (index * cosine - beyond) / (index * cosine + beyond);
    let across = (cosine - index * beyond) / (cosine + index * beyond);
    0.5 * (parallel * parallel + across * across)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value is that which Mitsuba 3.9.1 prints for `plastic`: `fdr_int` for the relative index
    /// 1.48959.
    #[test]
    fn light_is_kept_inside_as_in_mitsuba() {
        assert!((back_inside(1.49 / 1.000_277) - 0.590_479).abs() < 1e-3);
        assert!((straight(1.5) - 0.04).abs() < 1e-12);
        assert_eq!(
            [named("BK7"), named("polypropylene"), named("cheese")],
            [Some(1.5046), Some(1.49), None]
        );
    }
}
