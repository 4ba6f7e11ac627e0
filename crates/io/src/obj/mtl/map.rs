//! Maps of a material, with the options that say how they lie.

use crate::obj::WarningKind;
use crate::warning_counts::WarningCounts;
use traylib_math::Vec2;

/// The property that a map is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MapKind {
    /// `map_Kd`.
    Diffuse,
    /// `map_Ks`.
    Specular,
    /// `map_d`.
    Dissolve,
    /// `map_Bump` or `bump`.
    Bump,
    /// `map_Ke`.
    Emission,
    /// `norm`, normals.
    Normal,
    /// `map_Ns`.
    Exponent,
    /// `disp`, which moves the surface.
    Displacement,
    /// `decal`.
    Decal,
    /// `refl`.
    Reflection,
}

/// A picture, and how it lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Its file as it stands there.
    pub file: String,
    /// `-s`: how often it fits along u and v.
    pub scale: Vec2,
    /// `-o`: what is added to u and v after that.
    pub offset: Vec2,
    /// `-clamp on`: it is there once.
    pub clamp: bool,
    /// `-bm`: factor on a bump map.
    pub height: f32,
    /// `-imfchan`: which channel of the picture.
    pub channel: Option<char>,
}

impl MapKind {
    /// The kind that a statement is about.
    pub(super) fn of(keyword: &[u8]) -> Option<Self> {
        Some(match keyword.to_ascii_lowercase().as_slice() {
            b"map_kd" => Self::Diffuse,
            b"map_ks" => Self::Specular,
            b"map_d" => Self::Dissolve,
            b"map_bump" | b"bump" => Self::Bump,
            b"map_ke" => Self::Emission,
            b"norm" | b"map_kn" => Self::Normal,
            b"map_ns" => Self::Exponent,
            b"disp" | b"map_disp" => Self::Displacement,
            b"decal" => Self::Decal,
            b"refl" | b"map_refl" => Self::Reflection,
            _ => return None,
        })
    }
}

impl Map {
    /// Reads options, and then the rest of the line as a name of a file; `None` without one.
    pub(super) fn read(text: &str, warnings: &mut WarningCounts<WarningKind>) -> Option<Self> {
        let mut map = Self {
            file: String::new(),
            scale: Vec2::ONE,
            offset: Vec2::ZERO,
            clamp: false,
            height: 1.0,
            channel: None,
        };
        let mut rest = Rest(text);
        while let Some(option) = rest.option() {
            map.option(option, &mut rest, warnings);
        }
        map.file = rest.0.trim().to_string();
        (!map.file.is_empty()).then_some(map)
    }

    /// Reads what follows an option.
    fn option(
        &mut self,
        option: &str,
        rest: &mut Rest<'_>,
        warnings: &mut WarningCounts<WarningKind>,
    ) {
        match option {
            "-s" => self.scale = rest.up_to_three(self.scale),
            "-o" => self.offset = rest.up_to_three(self.offset),
            "-clamp" => self.clamp = rest.word() == "on",
            "-bm" => self.height = rest.number().unwrap_or(self.height),
            "-imfchan" => self.channel = rest.word().chars().next(),
            // How pictures are filtered: nothing of it changes what they show from near.
            "-blendu" | "-blendv" | "-cc" | "-texres" | "-boost" => _ = rest.word(),
            "-mm" => {
                let (base, gain) = (rest.number(), rest.number());
                if (base, gain) != (Some(0.0), Some(1.0)) {
                    warnings.add(WarningKind::option(option));
                }
            }
            "-t" => {
                _ = rest.up_to_three(Vec2::ZERO);
                warnings.add(WarningKind::option(option));
            }
            other => {
                _ = rest.word();
                warnings.add(WarningKind::option(other));
            }
        }
    }
}

/// The rest of a line.
struct Rest<'a>(&'a str);

impl<'a> Rest<'a> {
    /// Takes the next word.
    fn word(&mut self) -> &'a str {
        let text = self.0.trim_start();
        let end = text.find(|c: char| c.is_ascii_whitespace()).unwrap_or(text.len());
        self.0 = &text[end..];
        &text[..end]
    }

    /// Takes the next word if it is an option.
    fn option(&mut self) -> Option<&'a str> {
        let is_option = |text: &str| {
            let mut signs = text.chars();
            signs.next() == Some('-') && signs.next().is_some_and(char::is_alphabetic)
        };
        is_option(self.0.trim_start()).then(|| self.word())
    }

    /// Takes the next word if it is a finite number.
    fn number(&mut self) -> Option<f32> {
        let before = self.0;
        let number = self.word().parse().ok().filter(|value: &f32| value.is_finite());
        if number.is_none() {
            self.0 = before;
        }
        number
    }

    /// Takes one number for u, or one more for v, or a third that is for solid textures.
    fn up_to_three(&mut self, usual: Vec2) -> Vec2 {
        let u = self.number().unwrap_or(usual.x);
        let v = self.number().unwrap_or(usual.y);
        _ = self.number();
        Vec2::new(u, v)
    }
}
