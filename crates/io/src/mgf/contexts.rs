//! The contexts: the colour, the material and the vertex that are current.

use super::colour::Colour;
use super::keyword::Keyword;
use super::material_builder::MaterialBuilder;
use super::names::Names;
use super::words::{exactly, number, numbers};
use super::{Cause, Vertex};
use traylib_math::glam::DVec3;

/// The three contexts, each kind with names of its own.
pub(super) struct Contexts {
    pub(super) colours: Names<Colour>,
    pub(super) materials: Names<MaterialBuilder>,
    pub(super) vertices: Names<Vertex>,
}

impl Contexts {
    pub(super) fn new() -> Self {
        Self {
            colours: Names::new("colour"),
            materials: Names::new("material"),
            vertices: Names::new("vertex"),
        }
    }

    /// Returns the memory that names take, in bytes.
    pub(super) fn kept(&self) -> u64 {
        self.colours.kept + self.materials.kept + self.vertices.kept
    }

    /// Carries out an entity that names or describes a context.
    #[expect(clippy::wildcard_enum_match_arm, reason = "the others describe the material")]
    pub(super) fn set(&mut self, keyword: Keyword, words: &[&str]) -> Result<(), Cause> {
        match keyword {
            Keyword::Colour => self.colours.select(words)?,
            Keyword::Material => self.materials.select(words)?,
            Keyword::Vertex => self.vertices.select(words)?,
            Keyword::Chromaticity | Keyword::Spectrum | Keyword::Temperature | Keyword::Mix => {
                *self.colours.current_mut() = self.colour(keyword, words)?;
            }
            Keyword::Point => {
                self.vertices.current_mut().position = numbers(words, "3 numbers")?.into();
            }
            Keyword::Normal => {
                self.vertices.current_mut().normal = unit(numbers(words, "3 numbers")?.into());
            }
            _ => {
                let colour = *self.colours.current().2;
                self.materials.current_mut().set(keyword, words, colour)?;
            }
        }
        Ok(())
    }

    #[expect(
        clippy::wildcard_enum_match_arm,
        reason = "only colours come here, and this is the last of them"
    )]
    fn colour(&self, keyword: Keyword, words: &[&str]) -> Result<Colour, Cause> {
        match keyword {
            Keyword::Spectrum => spectrum(words),
            Keyword::Temperature => {
                let [kelvin] = numbers(words, "a temperature")?;
                Colour::temperature(kelvin)
            }
            Keyword::Mix => self.mixture(words),
            _ => Colour::chromaticity(numbers(words, "x and y")?),
        }
    }

    fn mixture(&self, words: &[&str]) -> Result<Colour, Cause> {
        let (pairs, rest) = words.as_chunks::<2>();
        if pairs.len() < 2 || !rest.is_empty() {
            let expected = "2 or more pairs of a weight and a colour";
            return Err(Cause::Arguments { expected, found: words.len() });
        }
        let part = |[weight, name]: &[&str; 2]| Ok((number(weight)?, *self.colours.get(name)?));
        Ok(Colour::mixture(&pairs.iter().map(part).collect::<Result<Vec<_>, Cause>>()?))
    }
}

fn spectrum(words: &[&str]) -> Result<Colour, Cause> {
    let Some((range, samples)) = words.split_at_checked(2).filter(|(_, rest)| rest.len() >= 2)
    else {
        let expected = "2 wavelengths and 2 samples or more";
        return Err(Cause::Arguments { expected, found: words.len() });
    };
    let [first, last] = exactly(range, "2 wavelengths")?;
    let samples: Vec<f64> = samples.iter().map(|word| number(word)).collect::<Result<_, _>>()?;
    Colour::spectrum([number(first)?, number(last)?], &samples)
}

/// With length one; `None` for zero.
fn unit(vector: DVec3) -> Option<DVec3> {
    // Scaled first, so that squares neither vanish nor overflow.
    (vector / vector.abs().max_element()).try_normalize()
}
