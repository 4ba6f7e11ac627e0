//! The keywords.

/// An entity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Keyword {
    Comment,
    Colour,
    Chromaticity,
    Spectrum,
    Temperature,
    Mix,
    Material,
    Sides,
    DiffuseReflectance,
    DiffuseTransmittance,
    SpecularReflectance,
    SpecularTransmittance,
    Emittance,
    Refraction,
    Vertex,
    Point,
    Normal,
    Face,
    FaceWithHoles,
    Sphere,
    Cylinder,
    Cone,
    Ring,
    Torus,
    Prism,
    Object,
    Transform,
    Include,
    Luminaire,
}

use Keyword as K;

const TABLE: [(&str, Keyword); 29] = [
    ("#", K::Comment),
    ("c", K::Colour),
    ("cxy", K::Chromaticity),
    ("cspec", K::Spectrum),
    ("cct", K::Temperature),
    ("cmix", K::Mix),
    ("m", K::Material),
    ("sides", K::Sides),
    ("rd", K::DiffuseReflectance),
    ("td", K::DiffuseTransmittance),
    ("rs", K::SpecularReflectance),
    ("ts", K::SpecularTransmittance),
    ("ed", K::Emittance),
    ("ir", K::Refraction),
    ("v", K::Vertex),
    ("p", K::Point),
    ("n", K::Normal),
    ("f", K::Face),
    ("fh", K::FaceWithHoles),
    ("sph", K::Sphere),
    ("cyl", K::Cylinder),
    ("cone", K::Cone),
    ("ring", K::Ring),
    ("torus", K::Torus),
    ("prism", K::Prism),
    ("o", K::Object),
    ("xf", K::Transform),
    ("i", K::Include),
    ("ies", K::Luminaire),
];

impl Keyword {
    /// The number of keywords.
    pub(super) const COUNT: usize = TABLE.len();

    /// The entity of a word.
    pub(super) fn of(word: &str) -> Option<Self> {
        TABLE.iter().find(|(name, _)| *name == word).map(|&(_, keyword)| keyword)
    }

    /// All of them.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        TABLE.into_iter().map(|(_, keyword)| keyword)
    }

    /// The word of the entity.
    pub(super) fn name(self) -> &'static str {
        // The table has the order of the enum, which its test holds it to.
        TABLE[self as usize].0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_keywords_are_each_others_inverse() {
        for (name, keyword) in TABLE {
            assert_eq!((Keyword::of(name), keyword.name()), (Some(keyword), name));
        }
        assert_eq!(Keyword::of("V"), None);
    }
}
