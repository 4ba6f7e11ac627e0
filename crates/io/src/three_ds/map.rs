//! Pictures that a material is covered with.

use super::Warnings;
use super::chunk::{Reader, set};
use super::colour;
use traylib_materials::Tiling;
use traylib_math::glam::Affine2;
use traylib_math::{Rgb, Vec2};

/// The property that a map changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MapKind {
    /// Diffuse colour.
    Texture1,
    /// Diffuse colour, over the first.
    Texture2,
    /// The share of the surface that shows.
    Opacity,
    /// Height.
    Bump,
    /// Colour of the highlight.
    Specular,
    /// Glossiness.
    Shininess,
    /// The light that it emits by itself.
    SelfIllumination,
    /// The surroundings that it mirrors.
    Reflection,
}

/// The chunk of each map and that of its mask.
const CHUNKS: [(MapKind, u16, u16); 8] = [
    (MapKind::Texture1, 0xa200, 0xa33e),
    (MapKind::Texture2, 0xa33a, 0xa340),
    (MapKind::Opacity, 0xa210, 0xa342),
    (MapKind::Bump, 0xa230, 0xa344),
    (MapKind::Specular, 0xa204, 0xa348),
    (MapKind::Shininess, 0xa33c, 0xa346),
    (MapKind::SelfIllumination, 0xa33d, 0xa34a),
    (MapKind::Reflection, 0xa220, 0xa34c),
];

impl MapKind {
    /// Returns the kind of map that a chunk is for, and whether the chunk is the mask of that map.
    pub(super) fn of(chunk: u16) -> Option<(Self, bool)> {
        let (kind, _, mask) =
            CHUNKS.iter().find(|(_, map, mask)| [*map, *mask].contains(&chunk))?;
        Some((*kind, *mask == chunk))
    }
}

/// A picture and how it lies on a surface, as stored.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Name of the picture's file, often in capitals, 8.3, or with the folder of
    /// a machine long gone.
    pub file: String,
    /// Share of the map in 0..1; 1 if the file does not say.
    pub strength: f32,
    /// The flags of [`Map`]'s constants.
    pub flags: u16,
    /// Blur, as stored.
    pub blur: f32,
    /// The number of times that the map fits into 0..1 of u and v; not 0.
    pub scale: Vec2,
    /// The middle of the map, from the middle of 0..1.
    pub offset: Vec2,
    /// Turn about the middle, in degrees.
    pub rotation_degrees: f32,
    /// Colours for the luminance of the map (black and white), and for its red,
    /// green and blue.
    pub tints: [Option<Rgb>; 5],
}

impl Default for Map {
    fn default() -> Self {
        Self {
            file: String::new(),
            strength: 1.0,
            flags: 0,
            blur: 0.0,
            scale: Vec2::ONE,
            offset: Vec2::ZERO,
            rotation_degrees: 0.0,
            tints: [None; 5],
        }
    }
}

impl Map {
    /// The map is a decal.
    pub const DECAL: u16 = 0x01;
    /// Every other tile is mirrored.
    pub const MIRROR: u16 = 0x02;
    /// The picture is used as a negative.
    pub const NEGATIVE: u16 = 0x08;
    /// The map does not repeat.
    pub const NO_TILING: u16 = 0x10;
    /// Filtered by a table of summed areas.
    pub const SUMMED_AREA: u16 = 0x20;
    /// The alpha of the picture is what is used.
    pub const ALPHA_SOURCE: u16 = 0x40;
    /// Tinted by its luminance.
    pub const TINT: u16 = 0x80;
    /// The alpha of the picture is not used.
    pub const IGNORE_ALPHA: u16 = 0x100;
    /// Each of red, green and blue is tinted.
    pub const RGB_TINT: u16 = 0x200;

    /// Tells whether all these flags are set.
    pub fn has(&self, flags: u16) -> bool {
        self.flags & flags == flags
    }

    /// Returns what is beyond the edges.
    pub fn tiling(&self) -> Tiling {
        if self.has(Self::NO_TILING) {
            Tiling::Once
        } else if self.has(Self::MIRROR) {
            Tiling::Mirror
        } else {
            Tiling::Repeat
        }
    }

    /// The file's name without folders, be they written with `/` or `\`.
    pub fn file_name(&self) -> &str {
        self.file.rsplit(['/', '\\']).next().unwrap_or_default()
    }

    /// From texture coordinates of the surface to those of the picture, v upward
    /// and 0..1 over it.
    ///
    /// 3D Studio moves, turns and scales about the middle of the map, in this
    /// order. Programs disagree on the sign of the offset.
    pub fn placement(&self) -> Affine2 {
        let middle = Vec2::splat(0.5);
        let turn = Affine2::from_angle(self.rotation_degrees.to_radians());
        Affine2::from_translation(middle)
            * Affine2::from_scale(self.scale)
            * turn
            * Affine2::from_translation(-middle - self.offset)
    }
}

/// Reads a map.
pub(super) fn decode(mut reader: Reader<'_>, warnings: &mut Warnings) -> Map {
    let mut map = Map::default();
    while let Some((id, mut body)) = reader.next_chunk(warnings) {
        match id {
            0x0030 | 0x0031 => set(&mut map.strength, colour::fraction_of(id, body)),
            0xa300 => map.file = body.string(),
            0xa351 => set(&mut map.flags, body.u16()),
            0xa353 => set(&mut map.blur, body.number(warnings)),
            0xa354 => set(&mut map.scale.x, scale(body, warnings)),
            0xa356 => set(&mut map.scale.y, scale(body, warnings)),
            0xa358 => set(&mut map.offset.x, body.number(warnings)),
            0xa35a => set(&mut map.offset.y, body.number(warnings)),
            0xa35c => set(&mut map.rotation_degrees, body.number(warnings)),
            0xa360 | 0xa362 | 0xa364 | 0xa366 | 0xa368 => {
                map.tints[usize::from(id - 0xa360) / 2] = tint(body, warnings);
            }
            _ => {}
        }
    }
    map
}

/// A scale of 0 would show one point everywhere; it stands for none.
fn scale(mut body: Reader<'_>, warnings: &mut Warnings) -> Option<f32> {
    body.number(warnings).filter(|&scale| scale != 0.0)
}

/// Three bytes, unlike all other colours; one as all others is understood too.
fn tint(mut body: Reader<'_>, warnings: &mut Warnings) -> Option<Rgb> {
    if body.len() == 3 { colour::bytes(&mut body) } else { colour::colour(body, warnings) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(map: &Map, u: f32, v: f32) -> [f32; 2] {
        map.placement().transform_point2(Vec2::new(u, v)).to_array()
    }

    #[test]
    fn every_chunk_is_one_map_or_one_mask() {
        for (kind, map, mask) in CHUNKS {
            assert_eq!(MapKind::of(map), Some((kind, false)));
            assert_eq!(MapKind::of(mask), Some((kind, true)));
        }
        assert_eq!(MapKind::of(0xa300), None);
    }

    #[test]
    fn a_plain_map_repeats() {
        let tiling = |flags| Map { flags, ..Map::default() }.tiling();
        assert_eq!(placed(&Map::default(), 0.25, 1.0), [0.25, 1.0]);
        assert_eq!([tiling(0), tiling(Map::MIRROR)], [Tiling::Repeat, Tiling::Mirror]);
        assert_eq!(tiling(Map::NO_TILING | Map::DECAL), Tiling::Once);
    }

    #[test]
    fn scale_offset_and_turn_are_about_the_middle() {
        let small = Map { scale: Vec2::splat(2.0), ..Map::default() };
        assert_eq!(placed(&small, 0.75, 0.5), [1.0, 0.5]);
        let moved = Map { offset: Vec2::new(0.25, 0.0), ..Map::default() };
        assert_eq!(placed(&moved, 0.75, 0.5), [0.5, 0.5]);
        let turned = Map { rotation_degrees: 90.0, ..Map::default() };
        let [u, v] = placed(&turned, 1.0, 0.5);
        assert!((u - 0.5).abs() < 1e-6 && (v - 1.0).abs() < 1e-6, "{u} {v}");
    }

    #[test]
    fn folders_are_no_part_of_a_name() {
        for (file, name) in [("A.TGA", "A.TGA"), ("c:\\maps\\a.gif", "a.gif"), ("x/y\\z", "z")] {
            assert_eq!(Map { file: file.to_string(), ..Map::default() }.file_name(), name);
        }
    }
}
