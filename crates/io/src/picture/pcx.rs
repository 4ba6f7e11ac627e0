//! PCX, version 5, 24 bits.

use super::Cause;
use super::screen::Screen;
use pcx::WriterRgb;

/// Dots an inch. Nobody asks, but zero would be no answer.
const RESOLUTION: (u16, u16) = (72, 72);

/// Rows of a plane are padded to an even number of bytes.
pub(super) fn encode(screen: &Screen) -> Result<Vec<u8>, Cause> {
    let size = (screen.width.try_into()?, screen.height.try_into()?);
    let mut bytes = Vec::new();
    let mut writer = WriterRgb::new(&mut bytes, size, RESOLUTION)?;
    for row in screen.bytes.chunks_exact(3 * screen.width as usize) {
        writer.write_row(row)?;
    }
    writer.finish()?;
    Ok(bytes)
}
