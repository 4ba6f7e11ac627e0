use super::*;
use std::path::PathBuf;
use std::{fs, io};

mod formats;

/// A folder that is removed at the end.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("traylib-{}-{test}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn files(&self) -> Vec<String> {
        let name = |entry: io::Result<fs::DirEntry>| entry.unwrap().file_name();
        fs::read_dir(&self.0).unwrap().map(|e| name(e).to_string_lossy().into_owned()).collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The formats that can be written.
const FORMATS: [&str; 5] = ["png", "exr", "hdr", "tga", "pcx"];

fn info() -> PictureInfo {
    PictureInfo {
        exposure: 0.5,
        tone: Tone::Linear,
        program: "tests 1.0".to_string(),
        integrator: "none".to_string(),
        command: "none snow.ron --spp 16".to_string(),
        scene: "snow ☃".to_string(),
        seed: u64::MAX,
        spp: 16,
        rejected_samples: 0,
        frame: None,
    }
}

/// More rows than one compressed block holds, and values PNG cannot hold.
fn picture() -> Grid<Rgb> {
    let value = |i: usize| Rgb::new(i as f32 * 0.37 - 1.0, 1e-20 * i as f32, 3e30 / (i + 1) as f32);
    Grid::from_values(7, 41, (0..7 * 41).map(value).collect()).unwrap()
}

#[test]
fn exr_keeps_every_bit() {
    let folder = Folder::new("exr");
    let paths = [folder.0.join("a.exr"), folder.0.join("b.EXR")];
    for path in &paths {
        check_writable(path).unwrap();
        save_picture(path, &picture(), &info()).unwrap();
        assert_eq!(load_exr(path).unwrap(), picture());
    }
    assert_eq!(folder.files().len(), 2);
}

/// An order that is left to chance would show: nine attributes have 362,880.
#[test]
fn equal_pictures_have_equal_bytes() {
    let folder = Folder::new("equal");
    for format in FORMATS {
        let files = ["a", "b", "c"].map(|name| folder.0.join(format!("{name}.{format}")));
        let bytes = files.map(|path| {
            save_picture(&path, &picture(), &info()).unwrap();
            fs::read(path).unwrap()
        });
        assert!(bytes[0] == bytes[1] && bytes[0] == bytes[2], "{format}");
    }
}

#[test]
fn the_header_says_how_the_picture_was_made() {
    let folder = Folder::new("header");
    let path = folder.0.join("a.exr");
    save_picture(&path, &picture(), &info()).unwrap();
    let bytes = fs::read(&path).unwrap();
    for words in ["tests 1.0", "integrator", "snow ?", "18446744073709551615"] {
        assert!(bytes.windows(words.len()).any(|w| w == words.as_bytes()), "{words}");
    }
}

#[test]
fn png_says_so_too() {
    let folder = Folder::new("text");
    let path = folder.0.join("a.png");
    let odd = [("", "no name"), ("no keyword: \n", "x"), ("good", "a\0b")];
    let odd = odd.map(|(name, text)| (name.to_string(), text.to_string()));
    let attributes = [info().attributes(), odd.to_vec()].concat();
    write_picture(&path, &picture(), 1.0, &attributes).unwrap();
    let decoder = ::png::Decoder::new(io::BufReader::new(fs::File::open(&path).unwrap()));
    let read = decoder.read_info().unwrap();
    let texts = &read.info().utf8_text;
    let texts: Vec<_> =
        texts.iter().map(|text| (text.keyword.clone(), text.get_text().unwrap())).collect();
    let mut expected = info().attributes();
    expected.push(("good".into(), "a b".into()));
    assert_eq!(texts, expected);
    assert!(texts.contains(&("scene".into(), "snow ☃".into())));
    assert!(read.info().srgb.is_some());
}

#[test]
fn png_has_the_exposure_applied() {
    let folder = Folder::new("png");
    let path = folder.0.join("a.png");
    let radiance = Grid::from_values(2, 1, vec![Rgb::new(0.0, 1.0, 9.0), Rgb::WHITE]).unwrap();
    save_picture(&path, &radiance, &info()).unwrap();
    let read = image::load_from_memory(&fs::read(&path).unwrap()).unwrap().to_rgb8();
    assert_eq!((read.width(), read.height()), (2, 1));
    assert_eq!(read.into_raw(), [0, 188, 255, 188, 188, 188]);
}

#[test]
fn what_a_format_cannot_hold_is_counted() {
    let values = [f32::NAN, f32::INFINITY, -1.0, 2e38, 0.5, 0.0];
    let picture = Grid::from_values(
        2,
        1,
        vec![Rgb::new(values[0], values[1], values[2]), Rgb::new(values[3], values[4], values[5])],
    )
    .unwrap();
    let count = |name: &str| {
        losses(Path::new(name), &picture).unwrap().map(|warning| (warning.file, warning.count))
    };
    assert_eq!(count("a.hdr"), Some(("a.hdr".to_string(), 4)));
    assert_eq!(count("a.png"), Some(("a.png".to_string(), 1)));
    assert_eq!(count("a.exr"), None);
    assert_eq!(losses(Path::new("a.hdr"), &Grid::filled(1, 1, Rgb::WHITE)).unwrap(), None);
}

#[test]
fn unknown_formats_and_folders_are_refused_beforehand() {
    let folder = Folder::new("refused");
    for name in ["a.jpg", "a", ".png", "a.gif"] {
        let checked = check_writable(&folder.0.join(name));
        assert!(matches!(checked, Err(Error::PictureFormat(_))), "{name}: {checked:?}");
    }
    let missing = check_writable(&folder.0.join("no-such-folder/a.png")).unwrap_err();
    assert!(matches!(missing, Error::Write { .. }), "{missing}");
    fs::create_dir(folder.0.join("dir.png")).unwrap();
    assert!(check_writable(&folder.0.join("dir.png")).is_err());
}

#[test]
fn a_failure_leaves_what_was_there() {
    let folder = Folder::new("failure");
    for format in FORMATS {
        let path = folder.0.join(format!("a.{format}"));
        fs::write(&path, "before").unwrap();
        check_writable(&path).unwrap();
        // A picture without pixels cannot be encoded.
        let nothing = Grid::from_values(0, 0, Vec::new()).unwrap();
        let refused = save_picture(&path, &nothing, &info());
        assert!(matches!(refused, Err(Error::Write { .. })), "{refused:?}");
        assert_eq!(fs::read(&path).unwrap(), b"before");
    }
    assert_eq!(folder.files().len(), FORMATS.len());
}

#[test]
fn pictures_too_wide_for_a_format_are_refused() {
    let folder = Folder::new("wide");
    for (format, width) in [("pcx", 65_535), ("tga", 65_536), ("hdr", 32_768)] {
        let path = folder.0.join(format!("a.{format}"));
        let checked = [width - 1, width].map(|width| check_picture(&path, width as u32, 1));
        assert!(matches!(checked, [Ok(()), Err(Error::Write { .. })]), "{format}: {checked:?}");
        save_picture(&path, &Grid::filled(width - 1, 1, Rgb::WHITE), &info()).unwrap();
        fs::remove_file(&path).unwrap();
        let refused = folder.0.join(format!("a.{format}"));
        let refused = save_picture(&refused, &Grid::filled(width, 1, Rgb::WHITE), &info());
        assert!(matches!(refused, Err(Error::Write { .. })), "{format}: {refused:?}");
    }
    assert_eq!(folder.files(), [""; 0]);
}

/// Cut anywhere, or with any byte of its header changed, a file is read or refused.
#[test]
fn damaged_files_are_errors() {
    let folder = Folder::new("damaged");
    let path = folder.0.join("a.exr");
    save_picture(&path, &picture(), &info()).unwrap();
    let whole = fs::read(&path).unwrap();
    for length in (0..whole.len()).step_by(97) {
        fs::write(&path, &whole[..length]).unwrap();
        let read = load_exr(&path);
        assert!(matches!(read, Err(Error::ReadPicture { .. })), "{length} bytes: {read:?}");
    }
    let mut refused = 0;
    for (at, change) in (0..900).step_by(5).flat_map(|at| [(at, 0x01), (at, 0xff)]) {
        let mut bytes = whole.clone();
        bytes[at] ^= change;
        fs::write(&path, &bytes).unwrap();
        refused += u32::from(load_exr(&path).is_err());
    }
    assert!(refused > 20, "{refused}");
}
