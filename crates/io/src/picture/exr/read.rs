//! The contents of an EXR file.

use crate::texture_error::check_memory;
use crate::{Error, Fault, MAX_PIXELS, TextureError};
use exr::block;
use exr::meta::attribute::Chromaticities;
use exr::meta::header::Header;
use exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, FlatSamples, Image, Layer, Layers, ReadChannels,
    ReadLayers, Text, read,
};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Samples that a file may hold, of all channels and layers: 16 GiB of floats.
/// More is taken for damage.
const MAX_SAMPLES: u64 = 16 * MAX_PIXELS;

/// An EXR file.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrFile {
    /// Columns of the display window, which is what a viewer shows.
    pub width: usize,
    /// Its rows.
    pub height: usize,
    /// CIE x and y of red, green, blue and white, where the file says them.
    pub chromaticities: Option<[f32; 8]>,
    /// Layers, in the order of the file; at least one.
    pub layers: Vec<ExrLayer>,
}

/// A layer, also called part.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrLayer {
    /// Its name, where it has one.
    pub name: Option<String>,
    /// Column and row of its first pixel, from the corner of the display window.
    pub at: [i64; 2],
    /// Columns of its data.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Channels, by name.
    pub channels: Vec<ExrChannel>,
    /// Texts and numbers of its header that say something of the picture, by name.
    pub attributes: Vec<(String, String)>,
}

/// One value of each pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrChannel {
    /// Its name, as `R` or `beauty.R`.
    pub name: String,
    /// `half`, `float` or `uint`.
    pub kind: &'static str,
    /// True if it has a value for each pixel, and not one for several.
    pub complete: bool,
    /// Its values, row by row.
    pub values: Vec<f32>,
}

/// Reads an EXR file with all its layers and channels. Of a picture in several
/// resolutions it is the finest; deep data are not supported.
///
/// # Errors
/// [`Error::ReadPicture`] if the file cannot be read or is no such file.
pub fn open_exr(path: &Path) -> Result<ExrFile, Error> {
    open_within(path, MAX_PIXELS, MAX_SAMPLES)
}

/// [`open_exr`] with other bounds on the pixels of a layer and on all samples.
pub(super) fn open_within(path: &Path, pixels: u64, samples: u64) -> Result<ExrFile, Error> {
    decode(path, pixels, samples)
        .map_err(|cause| Error::ReadPicture { file: path.to_path_buf(), cause: cause.into() })
}

fn decode(path: &Path, pixels: u64, samples: u64) -> Result<ExrFile, TextureError> {
    let chunks = block::read(BufReader::new(File::open(path)?), false).map_err(failed)?;
    check_sizes(chunks.headers(), pixels, samples)?;
    let reader = read().no_deep_data().largest_resolution_level().all_channels();
    Ok(file(reader.all_layers().all_attributes().from_chunks(chunks).map_err(failed)?))
}

fn failed(error: exr::error::Error) -> TextureError {
    use exr::error::Error::{Aborted, Invalid, Io, NotSupported};
    let fault = match &error {
        NotSupported(_) => Fault::Unsupported,
        Io(error) => Fault::of(error),
        Invalid(_) | Aborted => Fault::Damaged,
    };
    TextureError::Decoder { format: "EXR", fault, source: error.into() }
}

/// The bytes that a sample takes: as it is decoded, and as light.
const BYTES_OF_A_SAMPLE: u64 = 4 + 4;

/// Before memory is taken for what a header claims.
fn check_sizes(
    headers: &[Header],
    most_pixels: u64,
    most_samples: u64,
) -> Result<(), TextureError> {
    let area = |width: usize, height: usize| (width as u64).saturating_mul(height as u64);
    let mut samples = 0_u64;
    for header in headers {
        let (data, shown) = (header.layer_size, header.shared_attributes.display_window.size);
        for size in [data, shown] {
            if area(size.width(), size.height()) > most_pixels {
                let [width, height] = [size.width(), size.height()]
                    .map(|side| u32::try_from(side).unwrap_or(u32::MAX));
                return Err(TextureError::TooLarge { width, height, most: most_pixels });
            }
        }
        let channels = header.channels.list.len() as u64;
        samples = samples.saturating_add(area(data.width(), data.height()) * channels);
    }
    if samples > most_samples {
        return Err(TextureError::TooManyLayers(most_samples));
    }
    check_memory(samples.saturating_mul(BYTES_OF_A_SAMPLE))
}

type FlatImage = Image<Layers<AnyChannels<FlatSamples>>>;

fn file(image: FlatImage) -> ExrFile {
    let window = image.attributes.display_window;
    let corner = [window.position.x(), window.position.y()];
    let shared: Vec<_> = image.attributes.other.iter().filter_map(attribute).collect();
    ExrFile {
        width: window.size.width(),
        height: window.size.height(),
        chromaticities: image.attributes.chromaticities.map(coordinates),
        layers: image.layer_data.into_iter().map(|data| layer(data, corner, &shared)).collect(),
    }
}

fn coordinates(found: Chromaticities) -> [f32; 8] {
    let Chromaticities { red, green, blue, white } = found;
    let pairs = [red, green, blue, white].map(|place| [place.x(), place.y()]);
    std::array::from_fn(|index| pairs[index / 2][index % 2])
}

fn layer(
    data: Layer<AnyChannels<FlatSamples>>,
    corner: [i32; 2],
    shared: &[(String, String)],
) -> ExrLayer {
    let own = &data.attributes;
    let at = [own.layer_position.x(), own.layer_position.y()];
    let known = [
        ("software", &own.software_name),
        ("owner", &own.owner),
        ("comments", &own.comments),
        ("capDate", &own.capture_date),
        ("view", &own.view_name),
    ];
    let known = known.into_iter().filter_map(|(name, value)| {
        value.as_ref().map(|value| (name.to_string(), value.to_string()))
    });
    let others = own.other.iter().filter_map(attribute);
    let mut attributes: Vec<_> = known.chain(others).chain(shared.iter().cloned()).collect();
    attributes.sort();
    ExrLayer {
        name: own.layer_name.as_ref().map(Text::to_string).filter(|name| !name.is_empty()),
        at: [0, 1].map(|axis| i64::from(at[axis]) - i64::from(corner[axis])),
        width: data.size.width(),
        height: data.size.height(),
        channels: data.channel_data.list.into_iter().map(channel).collect(),
        attributes,
    }
}

fn channel(data: AnyChannel<FlatSamples>) -> ExrChannel {
    let kind = match &data.sample_data {
        FlatSamples::F16(_) => "half",
        FlatSamples::F32(_) => "float",
        FlatSamples::U32(_) => "uint",
    };
    ExrChannel {
        name: data.name.to_string(),
        kind,
        complete: (data.sampling.x(), data.sampling.y()) == (1, 1),
        values: match data.sample_data {
            FlatSamples::F32(values) => values,
            others @ (FlatSamples::F16(_) | FlatSamples::U32(_)) => {
                others.values_as_f32().collect()
            }
        },
    }
}

/// Texts and numbers; what else there may be says nothing to people.
#[expect(clippy::wildcard_enum_match_arm, reason = "sets, boxes and the like, for programs")]
fn attribute((name, value): (&Text, &AttributeValue)) -> Option<(String, String)> {
    let words = match value {
        AttributeValue::Text(text) => text.to_string(),
        AttributeValue::TextVector(texts) => {
            texts.iter().map(Text::to_string).collect::<Vec<_>>().join(", ")
        }
        AttributeValue::F64(number) => number.to_string(),
        AttributeValue::F32(number) => number.to_string(),
        AttributeValue::I32(number) => number.to_string(),
        _ => return None,
    };
    Some((name.to_string(), words))
}
