//! Materials while they are described.

use super::colour::Colour;
use super::keyword::Keyword;
use super::words::{exactly, number, numbers, within};
use super::{Cause, Material, Part};
use std::sync::Arc;
use traylib_math::Rgb;

/// A material while it is described: amounts with the colours current then.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MaterialBuilder {
    two_sided: bool,
    rd: (f64, Colour),
    td: (f64, Colour),
    rs: (f64, Colour),
    ts: (f64, Colour),
    ed: (f64, Colour),
    rs_roughness: f64,
    ts_roughness: f64,
    ir: [f64; 2],
}

impl Default for MaterialBuilder {
    fn default() -> Self {
        let none = (0.0, Colour::default());
        Self {
            two_sided: true,
            rd: none,
            td: none,
            rs: none,
            ts: none,
            ed: none,
            rs_roughness: 0.0,
            ts_roughness: 0.0,
            ir: [1.0, 0.0],
        }
    }
}

/// Largest number that fits single precision.
const MOST: f64 = f32::MAX as f64;

/// The repairs that made a material usable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Repairs {
    pub(super) scaled_down: bool,
    pub(super) without_luminance: bool,
}

impl MaterialBuilder {
    /// Carries out an entity that describes a material.
    #[expect(
        clippy::wildcard_enum_match_arm,
        reason = "none but what describes a material comes here"
    )]
    pub(super) fn set(
        &mut self,
        keyword: Keyword,
        words: &[&str],
        colour: Colour,
    ) -> Result<(), Cause> {
        match keyword {
            Keyword::Sides => self.two_sided = sides(words)?,
            Keyword::DiffuseReflectance => self.rd = (fraction(words)?, colour),
            Keyword::DiffuseTransmittance => self.td = (fraction(words)?, colour),
            Keyword::SpecularReflectance => {
                let (amount, roughness) = specular(words)?;
                (self.rs, self.rs_roughness) = ((amount, colour), roughness);
            }
            Keyword::SpecularTransmittance => {
                let (amount, roughness) = specular(words)?;
                (self.ts, self.ts_roughness) = ((amount, colour), roughness);
            }
            Keyword::Emittance => self.ed = (emittance(words)?, colour),
            Keyword::Refraction => self.ir = refraction(words)?,
            _ => {}
        }
        Ok(())
    }

    /// The material, without its name, with colours in bands and no brighter than
    /// light is.
    pub(super) fn finish(&self) -> (Material, Repairs) {
        let sum = self.rd.0 + self.td.0 + self.rs.0 + self.ts.0;
        // Decimal fractions may round to a little over one.
        let scaled_down = sum > 1.0 + 1e-6;
        let scale = if sum > 1.0 { 1.0 / sum } else { 1.0 };
        let mut without_luminance = false;
        let mut part = |(amount, colour): (f64, Colour), scale: f64| {
            let rgb = colour.rgb();
            without_luminance |= amount > 0.0 && rgb.is_none();
            Part { amount: (amount * scale) as f32, colour: rgb.unwrap_or(Rgb::BLACK) }
        };
        let material = Material {
            name: Arc::from(""),
            two_sided: self.two_sided,
            rd: part(self.rd, scale),
            td: part(self.td, scale),
            rs: part(self.rs, scale),
            rs_roughness: self.rs_roughness as f32,
            ts: part(self.ts, scale),
            ts_roughness: self.ts_roughness as f32,
            ed: part(self.ed, 1.0),
            ir: self.ir.map(|value| value as f32),
        };
        (material, Repairs { scaled_down, without_luminance })
    }
}

fn sides(words: &[&str]) -> Result<bool, Cause> {
    match *exactly::<1>(words, "1 or 2")? {
        ["1"] => Ok(false),
        ["2"] => Ok(true),
        [word] => within(false, number(word)?, "the number of sides", "1 or 2").map(|_| true),
    }
}

fn fraction(words: &[&str]) -> Result<f64, Cause> {
    let [value] = numbers(words, "a fraction")?;
    within((0.0..=1.0).contains(&value), value, "the fraction", "from 0 to 1")
}

fn specular(words: &[&str]) -> Result<(f64, f64), Cause> {
    let [amount, roughness] = numbers(words, "a fraction and a roughness")?;
    let amount = within((0.0..=1.0).contains(&amount), amount, "the fraction", "from 0 to 1")?;
    let fine = (0.0..=MOST).contains(&roughness);
    Ok((amount, within(fine, roughness, "the roughness", "0 or more")?))
}

fn emittance(words: &[&str]) -> Result<f64, Cause> {
    let [value] = numbers(words, "an emittance")?;
    within((0.0..=MOST).contains(&value), value, "the emittance", "0 or more, in single precision")
}

fn refraction(words: &[&str]) -> Result<[f64; 2], Cause> {
    let [n, k] = numbers(words, "a real and an imaginary index")?;
    let n = within(n > 0.0 && n <= MOST, n, "the index", "over 0")?;
    Ok([n, within(k.abs() <= MOST, k, "the imaginary index", "finite in single precision")?])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn builder(lines: &[&str]) -> MaterialBuilder {
        let mut builder = MaterialBuilder::default();
        for line in lines {
            let words: Vec<&str> = line.split(' ').collect();
            let keyword = Keyword::of(words[0]).unwrap();
            builder.set(keyword, &words[1..], Colour::default()).unwrap();
        }
        builder
    }

    #[test]
    fn the_default_is_a_black_absorber() {
        let (material, repairs) = builder(&[]).finish();
        assert!(material.two_sided && !material.emits());
        assert_eq!((material.rd.rgb(), material.ir), (Rgb::BLACK, [1.0, 0.0]));
        assert_eq!(repairs, Repairs::default());
    }

    #[test]
    fn every_entity_sets_its_numbers() {
        let lines =
            ["sides 1", "rd .25", "td .125", "rs .5 .0625", "ts .125 .5", "ed 9", "ir 1.5 -2"];
        let (material, repairs) = builder(&lines).finish();
        let amounts = [material.rd, material.td, material.rs, material.ts, material.ed];
        assert_eq!(amounts.map(|part| part.amount), [0.25, 0.125, 0.5, 0.125, 9.0]);
        assert_eq!((material.rs_roughness, material.ts_roughness), (0.0625, 0.5));
        assert_eq!((material.ir, material.two_sided), ([1.5, -2.0], false));
        assert_eq!((material.emits(), repairs.scaled_down), (true, false));
    }

    #[test]
    fn what_scatters_too_much_is_scaled_down() {
        let (material, repairs) = builder(&["rd .9", "rs .6 0", "ed 3"]).finish();
        assert!(repairs.scaled_down);
        assert!((material.rd.amount - 0.6).abs() < 1e-6 && (material.rs.amount - 0.4).abs() < 1e-6);
        assert_eq!(material.ed.amount, 3.0);
        assert!(!builder(&["rd .7", "rs .3 0"]).finish().1.scaled_down);
    }

    #[test]
    fn a_colour_without_luminance_is_black_and_told_of_where_it_matters() {
        let mut builder = MaterialBuilder::default();
        let dark = Colour { x: 0.5, y: 0.0 };
        builder.set(Keyword::DiffuseReflectance, &["0"], dark).unwrap();
        assert!(!builder.finish().1.without_luminance);
        builder.set(Keyword::DiffuseReflectance, &["1"], dark).unwrap();
        let (material, repairs) = builder.finish();
        assert!(repairs.without_luminance && material.rd.rgb() == Rgb::BLACK);
    }

    #[test]
    fn values_outside_of_their_range_are_refused() {
        for line in [
            "sides 3",
            "sides x",
            "rd 1.1",
            "rd -1",
            "td 2",
            "rs 2 0",
            "rs 1 -1",
            "ts -1 0",
            "ed -1",
            "ed 1e39",
            "ir 0 1",
            "ir 1 1e39",
            "rd",
            "rs 1",
            "ed 1 2",
            "ir 1",
        ] {
            let words: Vec<&str> = line.split(' ').collect();
            let keyword = Keyword::of(words[0]).unwrap();
            let mut builder = MaterialBuilder::default();
            assert!(builder.set(keyword, &words[1..], Colour::default()).is_err(), "{line}");
            assert_eq!(builder, MaterialBuilder::default(), "{line}");
        }
    }
}
