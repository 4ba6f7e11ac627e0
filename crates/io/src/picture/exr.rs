//! OpenEXR: ours are 32-bit floats, others' may be anything.

mod light;
mod read;

pub use light::load_exr;
pub use read::{ExrChannel, ExrFile, ExrLayer, open_exr};

use super::PictureInfo;
use exr::image::Blocks;
use exr::prelude::{
    AttributeValue, Compression, Encoding, Image, Layer, LayerAttributes, LineOrder,
    SpecificChannels, Text, Vec2, WritableImage,
};
use std::io::Cursor;
use traylib_math::{Grid, Rgb};

type Cause = Box<dyn std::error::Error + Send + Sync>;

/// One thread and a fixed order of lines, so that equal pictures have equal
/// bytes.
pub(super) fn encode(radiance: &Grid<Rgb>, info: &PictureInfo) -> Result<Vec<u8>, Cause> {
    let pixel = |at: Vec2<usize>| {
        let light = radiance.get(at.x(), at.y());
        (light.r, light.g, light.b)
    };
    let layer = Layer::new(
        (radiance.width(), radiance.height()),
        attributes(info),
        Encoding {
            compression: Compression::ZIP16,
            blocks: Blocks::ScanLines,
            line_order: LineOrder::Increasing,
        },
        SpecificChannels::rgb(pixel),
    );
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes)?;
    Ok(bytes.into_inner())
}

/// The header. Whole numbers are text: the format's integers end at 2³¹.
fn attributes(info: &PictureInfo) -> LayerAttributes {
    let program = Some(text(&info.program));
    let mut attributes = LayerAttributes { software_name: program, ..Default::default() };
    let own = [
        ("integrator", AttributeValue::Text(text(&info.integrator))),
        ("scene", AttributeValue::Text(text(&info.scene))),
        ("seed", AttributeValue::Text(text(&info.seed.to_string()))),
        ("spp", AttributeValue::Text(text(&info.spp.to_string()))),
        ("seconds", AttributeValue::F64(info.seconds)),
        ("rejectedSamples", AttributeValue::Text(text(&info.rejected_samples.to_string()))),
    ];
    attributes.other.extend(own.map(|(name, value)| (text(name), value)));
    attributes
}

/// Header text; characters beyond Latin-1 become question marks.
fn text(value: &str) -> Text {
    let plain = |c: char| u8::try_from(c).map_or('?', char::from);
    Text::new_or_none(value.chars().map(plain).collect::<String>()).unwrap_or_default()
}
