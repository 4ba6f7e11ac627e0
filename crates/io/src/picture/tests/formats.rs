//! Files of each format as other readers find them.

use super::*;

/// Sizes of every width modulo 2 and 4, and both sides of where compressed runs end.
const SIZES: [(usize, usize); 8] =
    [(1, 1), (2, 3), (3, 2), (5, 1), (17, 4), (255, 2), (511, 2), (62, 3)];

/// Stripes, dark and bright, some across rows.
fn stripes(width: usize, height: usize) -> Grid<Rgb> {
    let band = |i: usize| [0.0, 0.3, 1.0, 0.003][i % 4];
    let value = |i: usize| Rgb::new(band(i / 70), band(i / 3), band(i));
    Grid::from_values(width, height, (0..width * height).map(value).collect()).unwrap()
}

/// Other readers find in 8-bit formats the bytes that a screen shows.
#[test]
fn pixels_of_eight_bits_come_back() {
    let folder = Folder::new("bytes");
    for (width, height) in SIZES {
        let picture = stripes(width, height);
        let expected: Vec<u8> =
            picture.values().iter().flat_map(|&light| screen_rgb(light, 0.5)).collect();
        for format in ["png", "tga", "pcx"] {
            let path = folder.0.join(format!("a.{format}"));
            save_picture(&path, &picture, &info()).unwrap();
            let read = if format == "pcx" { read_pcx(&path) } else { read_image(&path) };
            assert_eq!(read, (width, height, expected.clone()), "{format}");
        }
    }
}

fn read_image(path: &Path) -> (usize, usize, Vec<u8>) {
    let read = image::open(path).unwrap().to_rgb8();
    (read.width() as usize, read.height() as usize, read.into_raw())
}

fn read_pcx(path: &Path) -> (usize, usize, Vec<u8>) {
    let mut reader = ::pcx::Reader::from_file(path).unwrap();
    let (width, height) = (usize::from(reader.width()), usize::from(reader.height()));
    let mut pixels = vec![0; 3 * width * height];
    pixels.chunks_mut(3 * width).for_each(|row| reader.next_row_rgb(row).unwrap());
    (width, height, pixels)
}

/// Old programs decode plane by plane: a run must not reach into the next.
#[test]
fn pcx_is_as_the_format_says() {
    let folder = Folder::new("pcx");
    let path = folder.0.join("a.pcx");
    let light = |[r, g, b]: [u8; 3]| {
        let [r, g, b] = [r, g, b].map(|byte| crate::srgb::decode(f32::from(byte) / 255.0));
        Rgb::new(r, g, b)
    };
    let row = [[10, 20, 30]; 4].into_iter().chain([[1, 2, 3]]).map(light);
    let picture = Grid::from_values(5, 2, row.clone().chain(row).collect()).unwrap();
    write_picture(&path, &picture, 1.0, &[]).unwrap();
    let bytes = fs::read(&path).unwrap();
    let (header, body) = bytes.split_at(128);
    assert_eq!(header[..12], [10, 5, 1, 8, 0, 0, 0, 0, 4, 0, 1, 0]);
    assert_eq!(header[64..70], [0, 3, 6, 0, 1, 0]);
    let row = [0xc4, 10, 1, 0, 0xc4, 20, 2, 0, 0xc4, 30, 3, 0];
    assert_eq!(body, [row, row].concat());
    write_picture(&path, &Grid::filled(130, 2, Rgb::BLACK), 1.0, &[]).unwrap();
    let planes = fs::read(&path).unwrap().split_off(128);
    let (mut ends, mut place, mut at) = (Vec::new(), 0, 0);
    while let Some(&byte) = planes.get(at) {
        let is_run = byte >= 0xc0;
        place += if is_run { usize::from(byte & 0x3f) } else { 1 };
        at += if is_run { 2 } else { 1 };
        ends.push(place);
    }
    assert!((1..=6).all(|plane| ends.contains(&(130 * plane))), "{ends:?}");
    assert_eq!(ends.last(), Some(&(130 * 6)));
}

#[test]
fn tga_is_as_the_format_says() {
    let folder = Folder::new("tga");
    let path = folder.0.join("a.tga");
    let picture = Grid::from_values(1, 2, vec![Rgb::new(1.0, 0.0, 0.0), Rgb::BLACK]).unwrap();
    write_picture(&path, &picture, 1.0, &[]).unwrap();
    let bytes = fs::read(&path).unwrap();
    assert_eq!(bytes[..18], [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 24, 0x20]);
    assert_eq!(bytes[18..24], [0, 0, 255, 0, 0, 0]);
    assert_eq!(bytes[24..], *b"\0\0\0\0\0\0\0\0TRUEVISION-XFILE.\0");
}

/// Each band within half a step of the pixel's brightest one.
#[test]
fn hdr_keeps_light_to_eight_bits() {
    let folder = Folder::new("hdr");
    let path = folder.0.join("a.hdr");
    for picture in
        SIZES.map(|(width, height)| stripes(width, height)).into_iter().chain([picture()])
    {
        save_picture(&path, &picture, &info()).unwrap();
        let read = image::open(&path).unwrap();
        let image::DynamicImage::ImageRgb32F(read) = read else { panic!("{read:?}") };
        assert_eq!(
            (read.width() as usize, read.height() as usize),
            (picture.width(), picture.height())
        );
        for (read, light) in read.pixels().zip(picture.values()) {
            let light = light.to_array().map(|band| band.max(0.0));
            let step = light.into_iter().fold(0.0, f32::max) / 128.0;
            let off = (0..3).map(|band| (read.0[band] - light[band]).abs()).fold(0.0, f32::max);
            assert!(off <= 0.5 * step, "{light:?} became {read:?}");
        }
    }
}
