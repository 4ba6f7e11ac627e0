//! Chooses the channels of an EXR file that are the picture.
//!
//! Every renderer has its own names. A *group* is a set of channels of one layer
//! whose names begin alike: `R`, `G`, `B` or `ViewLayer.Combined.R` and so on. Its
//! name is the last word before the band's, or the layer's where there is none.
//! A channel `A` of the group is opacity.

use super::read::{ExrChannel, ExrFile, ExrLayer, open_exr, open_within};
use crate::Error;
use crate::chromaticities::{Chromaticities, Conversion};
use std::path::Path;
use traylib_math::{Grid, Rgb, Vec3};

/// The names by which programs call the whole picture, in lower case.
const WHOLE: [&str; 7] = ["", "combined", "beauty", "rgba", "rgb", "color", "image"];

/// Reads the light of an EXR file, in the size of its display window: black where
/// a layer does not reach, cut where it goes beyond.
///
/// It is the first group with R, G and B, or with Y alone, that has no name or one
/// that says the whole picture, as `beauty`; else the first layer that has them
/// without a prefix; else the only group that has them. Light of other primaries than
/// those of Rec. 709, which the attribute `chromaticities` names, is converted.
///
/// # Errors
/// [`Error::ReadPicture`] if the file cannot be read, [`Error::NoLight`] if there
/// is no such group.
pub fn load_exr(path: &Path) -> Result<Grid<Rgb>, Error> {
    Ok(light(path, &open_exr(path)?)?.pixels)
}

/// The light of an EXR file, and its opacity where it has one, as stored.
pub(crate) struct ExrPicture {
    pub(crate) pixels: Grid<Rgb>,
    pub(crate) alpha: Option<Grid<f32>>,
}

/// [`load_exr`] of a file that has four values for each of so many pixels at most.
pub(crate) fn load_exr_within(path: &Path, pixels: u64) -> Result<ExrPicture, Error> {
    light(path, &open_within(path, pixels, pixels.saturating_mul(4))?)
}

fn light(path: &Path, file: &ExrFile) -> Result<ExrPicture, Error> {
    let unknown = || Error::NoLight { file: path.to_path_buf(), channels: channel_names(file) };
    let group = choose(groups(file)).ok_or_else(unknown)?;
    let mut pixels =
        spread(file, group.layer, Rgb::BLACK, |n| Rgb::from(group.bands.map(|b| b.values[n])));
    if let Conversion::Matrix(matrix) = conversion(path, file)? {
        let convert = |light: &Rgb| matrix * Vec3::from(light.to_array()).as_dvec3();
        pixels = pixels.map(|light| Rgb::from(convert(light).as_vec3().to_array()));
    }
    let alpha = group.alpha.map(|alpha| spread(file, group.layer, 0.0, |n| alpha.values[n]));
    Ok(ExrPicture { pixels, alpha })
}

/// From the primaries of a file to ours.
fn conversion(path: &Path, file: &ExrFile) -> Result<Conversion, Error> {
    let Some(list) = file.chromaticities else { return Ok(Conversion::None) };
    let found = Chromaticities::from_list(list.map(f64::from)).conversion();
    found.ok_or_else(|| Error::ReadPicture {
        file: path.to_path_buf(),
        cause: "the chromaticities are not x and y of red, green, blue and white".into(),
    })
}

/// The bands of a picture.
struct Group<'a> {
    layer: &'a ExrLayer,
    /// The text before the bands in the names of its channels.
    prefix: &'a str,
    bands: [&'a ExrChannel; 3],
    alpha: Option<&'a ExrChannel>,
}

impl Group<'_> {
    fn is_whole(&self) -> bool {
        let name =
            if self.prefix.is_empty() { self.layer.name.as_deref() } else { Some(self.prefix) };
        let name = name.unwrap_or_default();
        let last = name.rsplit('.').next().unwrap_or_default();
        WHOLE.contains(&last.to_ascii_lowercase().as_str())
    }
}

fn choose(groups: Vec<Group<'_>>) -> Option<Group<'_>> {
    let whole = groups.iter().position(Group::is_whole);
    let plain = || groups.iter().position(|group| group.prefix.is_empty());
    let only = || (groups.len() == 1).then_some(0);
    let best = whole.or_else(plain).or_else(only)?;
    groups.into_iter().nth(best)
}

fn groups(file: &ExrFile) -> Vec<Group<'_>> {
    file.layers.iter().flat_map(groups_of).collect()
}

fn groups_of(layer: &ExrLayer) -> Vec<Group<'_>> {
    let mut prefixes: Vec<&str> = Vec::new();
    for channel in &layer.channels {
        let prefix = split(&channel.name).0;
        if !prefixes.contains(&prefix) {
            prefixes.push(prefix);
        }
    }
    let alpha = |prefix| channel(layer, prefix, "A");
    let group = |prefix| {
        bands(layer, prefix).map(|bands| Group { layer, prefix, bands, alpha: alpha(prefix) })
    };
    prefixes.into_iter().filter_map(group).collect()
}

/// R, G and B, or three times Y. Y with RY and BY, or with X and Z, is a picture in
/// colours, of which Y would be a part.
fn bands<'a>(layer: &'a ExrLayer, prefix: &str) -> Option<[&'a ExrChannel; 3]> {
    let band = |wanted| channel(layer, prefix, wanted);
    match (band("R"), band("G"), band("B"), band("Y")) {
        (Some(r), Some(g), Some(b), _) => Some([r, g, b]),
        (None, None, None, Some(y)) if !has_chroma(layer, prefix) => Some([y; 3]),
        _ => None,
    }
}

/// The channel of this name that has a value for each pixel.
fn channel<'a>(layer: &'a ExrLayer, prefix: &str, wanted: &str) -> Option<&'a ExrChannel> {
    layer.channels.iter().find(|channel| is_named(channel, prefix, wanted) && channel.complete)
}

fn is_named(channel: &ExrChannel, prefix: &str, wanted: &str) -> bool {
    let (before, last) = split(&channel.name);
    before == prefix && last.eq_ignore_ascii_case(wanted)
}

fn has_chroma(layer: &ExrLayer, prefix: &str) -> bool {
    let has = |name| layer.channels.iter().any(|channel| is_named(channel, prefix, name));
    has("RY") || has("BY") || (has("X") && has("Z"))
}

/// Splits a channel's name at its last dot into the prefix and the band.
fn split(name: &str) -> (&str, &str) {
    name.rsplit_once('.').unwrap_or(("", name))
}

/// The display window with what the pixels of a layer have, by their numbers.
fn spread<T: Clone>(
    file: &ExrFile,
    layer: &ExrLayer,
    around: T,
    value: impl Fn(usize) -> T,
) -> Grid<T> {
    let mut shown = Grid::filled(file.width, file.height, around);
    for y in 0..layer.height {
        for x in 0..layer.width {
            if let Some(place) = place(file, layer, x, y) {
                shown.values_mut()[place] = value(y * layer.width + x);
            }
        }
    }
    shown
}

/// Returns the index of the pixel that shows a layer's pixel; `None` outside of the picture.
fn place(file: &ExrFile, layer: &ExrLayer, x: usize, y: usize) -> Option<usize> {
    let [column, row] = [(0, x), (1, y)]
        .map(|(axis, n)| usize::try_from(layer.at[axis].saturating_add_unsigned(n as u64)).ok());
    let (column, row) = (column?, row?);
    (column < file.width && row < file.height).then_some(row * file.width + column)
}

fn channel_names(file: &ExrFile) -> Vec<String> {
    let full = |layer: &ExrLayer, channel: &ExrChannel| match &layer.name {
        Some(layer) => format!("{layer}/{}", channel.name),
        None => channel.name.clone(),
    };
    let names = |layer: &ExrLayer| {
        layer.channels.iter().map(|channel| full(layer, channel)).collect::<Vec<_>>()
    };
    file.layers.iter().flat_map(names).collect()
}

#[cfg(test)]
mod tests;
