//! Pictures inside the page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use maud::{Markup, html};
use traylib_io::picture::screen_rgb;
use traylib_math::{Grid, Rgb};

/// A picture as a screen shows it.
pub(crate) fn picture(
    radiance: &Grid<Rgb>,
    exposure: f32,
    alt: &str,
    id: Option<String>,
) -> Markup {
    bytes_as_image(&radiance.map(|&light| screen_rgb(light, exposure)), alt, id)
}

/// A picture of 8 bits a channel.
pub(crate) fn bytes_as_image(pixels: &Grid<[u8; 3]>, alt: &str, id: Option<String>) -> Markup {
    let Some(png) = png(pixels) else { return html! { p.note { "No picture." } } };
    let source = format!("data:image/png;base64,{}", STANDARD.encode(png));
    let (width, height) = (pixels.width(), pixels.height());
    html! { img id=[id] src=(source) width=(width) height=(height) alt=(alt); }
}

fn png(pixels: &Grid<[u8; 3]>) -> Option<Vec<u8>> {
    let (width, height) =
        (u32::try_from(pixels.width()).ok()?, u32::try_from(pixels.height()).ok()?);
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(pixels.values().as_flattened(), width, height, ExtendedColorType::Rgb8)
        .ok()?;
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_carries_its_pixels() {
        let grid = Grid::from_values(2, 1, vec![[255, 0, 0], [0, 0, 255]]).unwrap();
        let bytes = png(&grid).unwrap();
        let read = image::load_from_memory(&bytes).unwrap().into_rgb8();
        assert_eq!(read.into_raw(), [255, 0, 0, 0, 0, 255]);
    }

    #[test]
    fn an_empty_picture_is_a_remark() {
        let grid = Grid::from_values(0, 0, Vec::new()).unwrap();
        assert!(bytes_as_image(&grid, "nothing", None).into_string().contains("No picture"));
    }
}
