//! The reflectances of metals at normal incidence.

use super::Importer;
use super::fields::Fields;
use super::paint::bands;
use traylib_math::Rgb;

/// Reflectances at normal incidence, as Mitsuba 3.9.1 has them for its materials in three bands
/// (`scalar_rgb`), from measured indices of refraction.
const METALS: [(&str, [f32; 3]); 37] = [
    ("a-C", [0.279_44, 0.194_037, 0.169_086]),
    ("Ag", [0.974_801, 0.957_536, 0.906_259]),
    ("Al", [0.928_045, 0.917_801, 0.918_906]),
    ("AlAs", [0.320_036, 0.278_272, 0.143_018]),
    ("Au", [0.966_679, 0.802_01, 0.324_121]),
    ("Be", [0.597_548, 0.520_603, 0.506_159]),
    ("Cr", [0.687_554, 0.649_068, 0.686_961]),
    ("CsI", [0.132_532, 0.067_545, 0.061_904]),
    ("Cu", [0.952_016, 0.619_787, 0.510_554]),
    ("Cu2O", [0.314_716, 0.245_513, 0.237_917]),
    ("CuO", [0.290_664, 0.198_249, 0.183_445]),
    ("d-C", [0.212_272, 0.157_909, 0.144_851]),
    ("Hg", [0.814_004, 0.770_216, 0.763_054]),
    ("HgTe", [0.469_871, 0.366_494, 0.350_662]),
    ("Ir", [0.742_648, 0.680_169, 0.630_799]),
    ("K", [0.953_925, 0.936_307, 0.920_1]),
    ("Li", [0.924_785, 0.884_434, 0.793_263]),
    ("MgO", [0.124_372, 0.060_265, 0.052_556]),
    ("Mo", [0.618_205, 0.561_808, 0.540_856]),
    ("Na", [0.978_536, 0.959_741, 0.931_527]),
    ("Nb", [0.564_048, 0.489_453, 0.473_065]),
    ("Ni", [0.700_133, 0.594_225, 0.493_568]),
    ("Rh", [0.824_266, 0.754_418, 0.721_626]),
    ("Se", [0.379_347, 0.250_664, 0.241_258]),
    ("SiC", [0.271_079, 0.187_299, 0.180_781]),
    ("SnTe", [0.406_993, 0.108_392, 0.015_232]),
    ("Ta", [0.456_48, 0.341_913, 0.379_942]),
    ("Te", [0.635_04, 0.578_091, 0.561_691]),
    ("ThF4", [0.086_121, 0.032_788, 0.026_359]),
    ("TiC", [0.548_156, 0.439_682, 0.411_572]),
    ("TiN", [0.640_859, 0.452_259, 0.197_557]),
    ("TiO2", [0.303_853, 0.224_604, 0.238_006]),
    ("V", [0.572_691, 0.510_657, 0.536_485]),
    ("VC", [0.529_685, 0.417_942, 0.379_775]),
    ("VN", [0.525_118, 0.392_65, 0.310_593]),
    ("W", [0.574_618, 0.477_757, 0.433_055]),
    ("none", [1.0, 1.0, 1.0]),
];

/// The material of a conductor that names none.
const NONE: &str = "none";
/// The same, in files of versions 0.5 and 0.6.
const NONE_ONCE: &str = "Cu";

impl Importer<'_> {
    /// The reflectance at normal incidence of a conductor, by `material` or by `eta` and `k`.
    pub(super) fn metal(&mut self, fields: &mut Fields<'_>) -> Rgb {
        let own = [fields.value("eta"), fields.value("k")];
        let is_old = fields.object.is_old;
        let outside = fields.number("ext_eta").unwrap_or(1.0);
        let [Some(eta), Some(k)] = own else {
            let usual = if is_old { NONE_ONCE } else { NONE };
            let name = fields.text("material").unwrap_or(usual);
            return named(name).unwrap_or_else(|| {
                let name = crate::suggest::shown(name);
                self.pictures.counter.add(format!("metal `{name}` not known, taken for a mirror"));
                Rgb::WHITE
            });
        };
        fields.ignore(&["material"]);
        let [eta, k] = [eta, k].map(|value| self.reflected(value));
        let [Some(eta), Some(k)] = [eta, k] else {
            self.pictures.counter.add("metal whose index is not read, taken for a mirror");
            return Rgb::WHITE;
        };
        let [eta, k] = [eta, k].map(|index| index.to_array().map(|band| f64::from(band) / outside));
        bands([0, 1, 2].map(|band| straight(eta[band], k[band])))
    }
}

fn named(name: &str) -> Option<Rgb> {
    let name = name.strip_suffix("_palik").unwrap_or(name);
    METALS.iter().find(|(known, _)| *known == name).map(|&(_, bands)| Rgb::from(bands))
}

/// |(n − 1)/(n + 1)|² for n = η + ik.
fn straight(eta: f64, k: f64) -> f64 {
    ((eta - 1.0).powi(2) + k * k) / ((eta + 1.0).powi(2) + k * k)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metals_have_names_and_indices() {
        assert_eq!(named("Au"), named("Au_palik"));
        assert_eq!((named("none"), named("cheese")), (Some(Rgb::WHITE), None));
        assert_eq!(straight(0.0, 1.0), 1.0);
        assert!((straight(1.5, 0.0) - 0.04).abs() < 1e-12);
    }
}
