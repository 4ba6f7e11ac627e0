//! PCX, of any version.

use super::raster::from_rgba8;
use super::{Decoded, TextureError, TextureLimits};
use crate::Fault;
use pcx::Reader;
use std::io::{self, Cursor};

/// Red, green and blue of 256 colours.
type Palette = [u8; 3 * 256];

/// A palette of 256 colours is the end of the file, after a byte of its own.
const TRAILER: usize = 1 + size_of::<Palette>();

/// Rows that are not there in full are left black, or of colour 0.
pub(super) fn decode(bytes: &[u8], limits: TextureLimits) -> Result<Decoded, TextureError> {
    let (width, height) = Reader::from_mem(bytes).map_err(failed)?.dimensions();
    limits.check(width.into(), height.into())?;
    let mut repairs = Vec::new();
    let (body, palette) = palette(bytes, &mut repairs)?;
    let mut reader = Reader::from_mem(body).map_err(failed)?;
    let mut pixels = Vec::with_capacity(usize::from(width) * usize::from(height));
    for _ in 0..height {
        let row = row(&mut reader, &palette).or_else(|error| {
            let cut_off = error.kind() == io::ErrorKind::UnexpectedEof;
            if cut_off { Ok(None) } else { Err(failed(error)) }
        })?;
        let Some(row) = row else {
            repairs.push("cut off, rows at the bottom are missing");
            break;
        };
        pixels.extend(row);
    }
    let [r, g, b] = colour(&palette, 0).map(|byte| byte * u8::from(reader.is_paletted()));
    pixels.resize(usize::from(width) * usize::from(height), [r, g, b, u8::MAX]);
    let decoded = from_rgba8(width.into(), height.into(), &pixels);
    Ok(Decoded { repairs, ..decoded })
}

fn failed(error: io::Error) -> TextureError {
    TextureError::Decoder { format: "PCX", fault: Fault::of(&error), source: error.into() }
}

/// The colours, and the file without them where they are at its end. Greys where
/// there should be 256 and are none.
fn palette<'a>(
    bytes: &'a [u8],
    repairs: &mut Vec<&'static str>,
) -> Result<(&'a [u8], Palette), TextureError> {
    let mut palette: Palette = std::array::from_fn(|index| (index / 3) as u8);
    let reader = Reader::from_mem(bytes).map_err(failed)?;
    if reader.palette_length() != Some(256) {
        reader.read_palette(&mut palette).map_err(failed)?;
        return Ok((bytes, palette));
    }
    if reader.read_palette(&mut palette).is_err() {
        repairs.push("no palette, its colours are taken for greys");
        return Ok((bytes, palette));
    }
    Ok((&bytes[..bytes.len().saturating_sub(TRAILER)], palette))
}

type Rows<'a> = Reader<Cursor<&'a [u8]>>;

fn row(reader: &mut Rows<'_>, palette: &Palette) -> io::Result<Option<Vec<[u8; 4]>>> {
    let width = usize::from(reader.width());
    if reader.is_paletted() {
        let mut row = vec![0; width];
        reader.next_row_paletted(&mut row)?;
        let opaque = |index| opaque(colour(palette, index));
        return Ok(Some(row.into_iter().map(opaque).collect()));
    }
    let mut row = vec![0; 3 * width];
    reader.next_row_rgb(&mut row)?;
    Ok(Some(row.as_chunks().0.iter().copied().map(opaque).collect()))
}

fn opaque([r, g, b]: [u8; 3]) -> [u8; 4] {
    [r, g, b, u8::MAX]
}

fn colour(palette: &Palette, index: u8) -> [u8; 3] {
    palette.as_chunks().0[usize::from(index)]
}
