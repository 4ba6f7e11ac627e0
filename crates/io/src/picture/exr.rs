//! OpenEXR: ours are 32-bit floats, others' may be anything.

mod light;
mod order;
mod read;

pub use light::load_exr;
pub(crate) use light::{ExrPicture, load_exr_within};
pub use read::{ExrChannel, ExrFile, ExrLayer, open_exr};

use super::{Cause, Extras, PictureFrame, PictureLayer};
use exr::image::Blocks;
use exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, Compression, Encoding, FlatSamples, Image,
    IntegerBounds, Layer, LayerAttributes, LineOrder, Text, Vec2, WritableImage,
};
use std::io::Cursor;
use traylib_math::{Grid, Rgb};

/// One thread and fixed orders of lines and attributes, so that equal pictures have
/// equal bytes.
pub(super) fn encode(radiance: &Grid<Rgb>, extras: Extras<'_>) -> Result<Vec<u8>, Cause> {
    let Extras { attributes, frame, layers } = extras;
    let mut header = header(attributes);
    if let Some(PictureFrame { corner: (x, y), .. }) = frame {
        header.layer_position = Vec2(i32::try_from(x)?, i32::try_from(y)?);
    }
    let layer = Layer::new(
        (radiance.width(), radiance.height()),
        header,
        Encoding {
            compression: Compression::ZIP16,
            blocks: Blocks::ScanLines,
            line_order: LineOrder::Increasing,
        },
        channels(radiance, layers),
    );
    let mut bytes = Cursor::new(Vec::new());
    let mut image = Image::from_layer(layer);
    if let Some(PictureFrame { size: (width, height), .. }) = frame {
        let size = Vec2(width as usize, height as usize);
        image.attributes.display_window = IntegerBounds::from_dimensions(size);
    }
    image.write().non_parallel().to_buffered(&mut bytes)?;
    order::sorted(bytes.into_inner()).ok_or_else(|| "the header has no end".into())
}

/// The light without a prefix, and all layers with theirs.
fn channels(radiance: &Grid<Rgb>, layers: &[PictureLayer]) -> AnyChannels<FlatSamples> {
    let channel = |name: String, values: &Grid<Rgb>, band: usize| {
        let values = values.values().iter().map(|value| value.to_array()[band]).collect();
        AnyChannel::new(name.as_str(), FlatSamples::F32(values))
    };
    let light = ["R", "G", "B"].into_iter().enumerate();
    let light = light.map(|(band, name)| channel(name.to_owned(), radiance, band));
    let beside = layers.iter().flat_map(|PictureLayer { name, channels, values }| {
        let named = channels.iter().enumerate();
        named.map(move |(band, own)| channel(format!("{name}.{own}"), values, band))
    });
    AnyChannels::sort(light.chain(beside).collect())
}

/// All attributes are text: the format's integers end at 2³¹. One without a name
/// would be the end of the header.
fn header(attributes: &[(String, String)]) -> LayerAttributes {
    let mut header = LayerAttributes::default();
    for (name, value) in attributes.iter().filter(|(name, _)| !name.is_empty()) {
        let value = text(value);
        match name.as_str() {
            "software" => header.software_name = Some(value),
            "owner" => header.owner = Some(value),
            "comments" => header.comments = Some(value),
            "capDate" => header.capture_date = Some(value),
            "view" => header.view_name = Some(value),
            _ => _ = header.other.insert(text(name), AttributeValue::Text(value)),
        }
    }
    header
}

/// Header text; characters beyond Latin-1 and zeros become question marks.
fn text(value: &str) -> Text {
    let plain = |c: char| u8::try_from(c).ok().filter(|&byte| byte != 0).map_or('?', char::from);
    Text::new_or_none(value.chars().map(plain).collect::<String>()).unwrap_or_default()
}
