//! The materials of surfaces that are drawn.

use traylib_math::{Vec2, Vec3};

/// A material, which every object has for itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The way it scatters light where no picture says otherwise.
    pub base: Base,
    /// Picture of the diffuse part.
    pub diffuse: Option<Map>,
    /// Picture of the specular part.
    pub specular: Option<Map>,
    /// Picture of how much is there.
    pub opacity: Option<Map>,
    /// Picture of height.
    pub bump: Option<BumpMap>,
}

/// The models of scene files.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Base {
    /// Ideal diffuse.
    Lambert(Vec3),
    /// Modified Phong.
    Phong(Lobes),
    /// A metal of this colour and exponent.
    MaxPhong(Vec3, f32),
    /// The reflectances: the mirrored part, and the diffuse one beside it.
    Mirror(Vec3, Vec3),
    /// The lobes of reflection and of transmission.
    Sheet(Lobes, Lobes),
    /// Clear solid glass of this index.
    Glass(f32),
    /// Thin clear glass: what is mirrored, and what goes straight on.
    Pane(Vec3, Vec3),
}

/// A diffuse part and a lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobes {
    /// kd.
    pub diffuse: Vec3,
    /// ks.
    pub specular: Vec3,
    /// n.
    pub exponent: f32,
}

/// A picture on a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// The picture.
    pub picture: Picture,
    /// The values beyond its edges.
    pub tiling: Tiling,
    /// The number of times that it fits along u and v.
    pub scale: Vec2,
    /// Share over the base.
    pub strength: f32,
}

/// A picture whose luminance is height.
#[derive(Clone, Debug, PartialEq)]
pub struct BumpMap {
    /// The picture, at full strength.
    pub map: Map,
    /// Height of white over black in lengths of a unit of u.
    pub height: f32,
}

/// The values beyond the edges of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tiling {
    /// The picture again.
    Repeat,
    /// The picture again, every other time mirrored.
    Mirror,
    /// Nothing.
    Once,
}

/// A picture as it goes into a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Picture {
    /// A few pixels.
    Texels {
        /// Columns.
        width: usize,
        /// Row by row from the top; in 256ths.
        texels: Vec<[u8; 3]>,
        /// The file that it becomes.
        coding: Coding,
    },
    /// A file from elsewhere.
    File {
        /// The ending of its name, which says what it is.
        ending: String,
        /// All of it.
        content: Vec<u8>,
    },
}

/// Kinds of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coding {
    /// Radiance: linear light, in 256ths.
    Hdr,
    /// TGA: 8 bits, coded as screens have it.
    Tga,
}

impl Material {
    /// Without pictures.
    pub fn plain(base: Base) -> Self {
        Self { base, diffuse: None, specular: None, opacity: None, bump: None }
    }

    /// Ideal diffuse, grey.
    pub fn grey(reflectance: f32) -> Self {
        Self::plain(Base::Lambert(Vec3::splat(reflectance)))
    }

    /// Tells whether there are pictures on it.
    pub fn has_maps(&self) -> bool {
        self.diffuse.is_some()
            || self.specular.is_some()
            || self.opacity.is_some()
            || self.bump.is_some()
    }
}

impl Lobes {
    /// Nothing.
    pub const NONE: Self = Self { diffuse: Vec3::ZERO, specular: Vec3::ZERO, exponent: 1.0 };

    /// No lobe.
    pub fn diffuse(part: Vec3) -> Self {
        Self { diffuse: part, ..Self::NONE }
    }
}

impl Map {
    /// Makes a map of full strength, once along either side.
    pub fn of(picture: Picture) -> Self {
        Self { picture, tiling: Tiling::Repeat, scale: Vec2::ONE, strength: 1.0 }
    }
}
