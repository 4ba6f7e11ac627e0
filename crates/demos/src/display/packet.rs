//! What tev is told, as bytes.
//!
//! A packet is its own length in bytes (`u32`), its kind (`u8`) and what belongs to the kind, all
//! of it little-endian; texts end with a zero byte (`Ipc.h` of tev 2, which has taken no other
//! form of these three kinds since 2021).

use super::tiles::Tile;
use traylib_math::{Grid, Rgb};

/// Kinds of packets, the latest version of each.
const CREATE_IMAGE: u8 = 4;
const UPDATE_IMAGE: u8 = 6;
const VECTOR_GRAPHICS: u8 = 8;

/// Commands of vector graphics.
const STROKE_COLOUR: u8 = 4;
const STROKE: u8 = 5;
const BEGIN_PATH: u8 = 6;
const RECTANGLE: u8 = 18;

/// Red, green, blue and opacity of boxes.
const BOX_COLOUR: [f32; 4] = [1.0, 0.2, 0.1, 1.0];

const CHANNELS: [&str; 3] = ["R", "G", "B"];

/// Pixels in a packet: with three bands they fit into the buffer of 1 MiB that tev begins with.
const MOST_PIXELS: usize = 1 << 16;

/// A packet that is being written.
struct Packet(Vec<u8>);

impl Packet {
    /// About the image of this name, which becomes the one that is seen if it is to be shown.
    fn new(kind: u8, is_shown: bool, name: &str) -> Self {
        Self(vec![0; 4]).byte(kind).byte(u8::from(is_shown)).text(name)
    }

    fn byte(mut self, byte: u8) -> Self {
        self.0.push(byte);
        self
    }

    fn text(mut self, text: &str) -> Self {
        self.0.extend(text.bytes().filter(|&byte| byte != 0));
        self.byte(0)
    }

    fn channels(self) -> Self {
        CHANNELS.iter().fold(self.count(CHANNELS.len()), |packet, name| packet.text(name))
    }

    /// A number of 32 bits with a sign; sides of pictures are far from their end.
    fn count(mut self, number: usize) -> Self {
        self.0.extend(i32::try_from(number).unwrap_or(i32::MAX).to_le_bytes());
        self
    }

    /// A number of 64 bits with a sign.
    fn long(mut self, number: i64) -> Self {
        self.0.extend(number.to_le_bytes());
        self
    }

    fn floats(mut self, numbers: impl IntoIterator<Item = f32>) -> Self {
        self.0.extend(numbers.into_iter().flat_map(f32::to_le_bytes));
        self
    }

    fn finish(mut self) -> Vec<u8> {
        let length = self.0.len() as u32;
        self.0[..4].copy_from_slice(&length.to_le_bytes());
        self.0
    }
}

/// A black image of red, green and blue, which is shown at once. One of the same name gives way.
pub(super) fn create(name: &str, width: usize, height: usize) -> Vec<u8> {
    Packet::new(CREATE_IMAGE, true, name).count(width).count(height).channels().finish()
}

/// The pixels of a whole image, some rows to a packet.
pub(super) fn updates<'a>(
    name: &'a str,
    picture: &'a Grid<Rgb>,
) -> impl Iterator<Item = Vec<u8>> + 'a {
    let width = picture.width();
    let rows = (MOST_PIXELS / width).max(1);
    picture.values().chunks(rows * width).enumerate().map(move |(strip, pixels)| {
        let head = Packet::new(UPDATE_IMAGE, false, name).channels();
        let place = head.count(0).count(strip * rows).count(width).count(pixels.len() / width);
        // The first float of each band, and how far it is from one to the next.
        let bands = place.long(0).long(1).long(2).long(3).long(3).long(3);
        bands.floats(pixels.iter().flat_map(|light| light.to_array())).finish()
    })
}

/// Boxes on an image, in place of those before.
pub(super) fn boxes(name: &str, tiles: &[Tile]) -> Vec<u8> {
    let is_added = 0;
    let head = Packet::new(VECTOR_GRAPHICS, false, name).byte(is_added).count(4 * tiles.len());
    let draw = |packet: Packet, tile: &Tile| {
        let place = [tile.x, tile.y, tile.width, tile.height].map(|pixels| pixels as f32);
        let path = packet.byte(BEGIN_PATH).byte(RECTANGLE).floats(place);
        path.byte(STROKE_COLOUR).floats(BOX_COLOUR).byte(STROKE)
    };
    tiles.iter().fold(head, draw).finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bytes that tev's own client for Python, tevclient 1.0.4, makes of the same.
    #[test]
    fn packets_are_those_of_another_client() {
        let bytes = |hex: &str| -> Vec<u8> {
            let digit = |digit: &u8| char::from(*digit).to_digit(16).unwrap() as u8;
            hex.as_bytes().chunks(2).map(|pair| 16 * digit(&pair[0]) + digit(&pair[1])).collect()
        };
        assert_eq!(create("a b", 300, 2), bytes(CREATED));
        let picture = Grid::from_fn(2, 1, |pixel| Rgb::new(pixel as f32, 0.5, -1.0));
        assert_eq!(updates("a b", &picture).collect::<Vec<_>>(), [bytes(UPDATED)]);
        let tile = Tile { x: 16, y: 8, width: 4, height: 2 };
        assert_eq!(boxes("a b", &[tile]), bytes(BOXED));
    }

    const CREATED: &str = "1c0000000401612062002c0100000200000003000000520047004200";
    const UPDATED: &str = "\
        6c000000060061206200030000005200470042000000000000000000020000000100000000000000\
        00000000010000000000000002000000000000000300000000000000030000000000000003000000\
        00000000000000000000003f000080bf0000803f0000003f000080bf";
    const BOXED: &str = "\
        330000000800612062000004000000061200008041000000410000804000000040040000803fcdcc\
        4c3ecdcccc3d0000803f05";

    /// A text ends where it seems to.
    #[test]
    fn names_have_no_zero() {
        assert_eq!(create("a\0b", 1, 1), create("ab", 1, 1));
    }

    #[test]
    fn large_pictures_are_cut_into_strips() {
        let picture = Grid::filled(30_000, 5, Rgb::BLACK);
        let lengths: Vec<usize> = updates("a", &picture).map(|packet| packet.len()).collect();
        let head = lengths[0] - 2 * 30_000 * 12;
        assert_eq!(lengths, [720_000 + head, 720_000 + head, 360_000 + head]);
        assert!(lengths[0] < 1 << 20);
    }
}
