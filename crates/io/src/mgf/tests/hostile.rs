//! Damaged files end in a document or an error, soon.

use super::*;
use traylib_math::Sampler;

const SHAPES: &str = include_str!("../../../tests/data/shapes.mgf");

const ARRAYS: &str = include_str!("../../../tests/data/arrays.mgf");

const INCLUDES: &str = "\
i part.mgf -a 3 -t 0 0 2\ni sub/deep.mgf\nxf -s 3\ni part.mgf\nxf\ni PART.MGF\n";

const SAMPLES: [&str; 3] = [SHAPES, ARRAYS, INCLUDES];

fn folder() -> Folder {
    Folder::new(&[("part.mgf", "v z =\np 1 1 1\nsph z .5\n"), ("sub/deep.mgf", "i ../part.mgf\n")])
}

fn survive(folder: &Folder, bytes: &[u8]) -> bool {
    // A new file each time: some systems wait for the disk when one is cut short.
    let _ = fs::remove_file(folder.0.join("x.mgf"));
    folder.write("x.mgf", bytes);
    let options = Options {
        max_surfaces: 1000,
        max_cutting: 50_000,
        max_work: 200_000,
        ..Options::default()
    };
    let Ok(document) = decode(&[folder.0.join("x.mgf")], &options) else { return false };
    for surface in document.surfaces.iter().take(20) {
        for corner in tessellate::triangles(&surface.shape, 1).iter().flatten() {
            assert!(!corner.position.is_nan());
        }
        assert!(surface.material < document.materials.len());
    }
    true
}

#[test]
fn the_samples_are_sound() {
    let folder = folder();
    for text in SAMPLES {
        assert!(survive(&folder, text.as_bytes()), "{text}");
    }
}

#[test]
fn every_beginning_is_survived() {
    let folder = folder();
    for text in SAMPLES {
        let sound = (0..text.len()).filter(|&end| survive(&folder, &text.as_bytes()[..end]));
        assert!(sound.count() > text.len() / 10, "{text}");
    }
}

#[test]
fn changed_bytes_are_survived() {
    let folder = folder();
    let mut sampler = Sampler::numbered(5, 0);
    for text in SAMPLES {
        let mut refused = 0;
        for _ in 0..2000 {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..3 {
                let place = (sampler.next_1d() * bytes.len() as f32) as usize;
                mutate(&mut bytes, place.min(text.len() / 2), &mut sampler);
            }
            refused += u32::from(!survive(&folder, &bytes));
        }
        assert!((1..2000).contains(&refused), "{refused} of 2000 for {text}");
    }
}

/// Another byte, a number, a word, or a line less or twice.
fn mutate(bytes: &mut Vec<u8>, place: usize, sampler: &mut Sampler) {
    const WORDS: [&str; 12] = [
        "-a 99999999 ",
        "1e308 ",
        "-1 ",
        "0 ",
        "\nxf\n",
        "\no\n",
        "\\",
        "=",
        " nan ",
        "\r",
        "-s 1e200 ",
        "i x.mgf\n",
    ];
    let end = bytes[place..]
        .iter()
        .position(|&byte| byte == b'\n')
        .map_or(bytes.len(), |n| place + n + 1);
    match (sampler.next_1d() * 4.0) as u32 {
        0 => bytes[place] = (sampler.next_1d() * 256.0) as u8,
        1 => {
            let word = WORDS[(sampler.next_1d() * WORDS.len() as f32) as usize];
            bytes.splice(place..place, word.bytes());
        }
        2 => {
            bytes.drain(place..end);
        }
        _ => {
            let line = bytes[place..end].to_vec();
            bytes.splice(place..place, line);
        }
    }
}
