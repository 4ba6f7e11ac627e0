//! Films through files and together.

use super::*;
use crate::picture::tests::Folder;
use std::fs;
use std::path::PathBuf;
use traylib_math::Rgb;
use traylib_scene::PassImage;

/// More than a stripe, and no whole number of them.
const SIZE: (u32, u32) = (150, 130);

fn film(sequences: u32, passes: impl IntoIterator<Item = u32>) -> Film {
    film_of_size(SIZE, sequences, passes)
}

fn film_of_size(
    (width, height): (u32, u32),
    sequences: u32,
    passes: impl IntoIterator<Item = u32>,
) -> Film {
    let mut film = Film::of_sequences(width, height, sequences);
    for number in passes {
        let mut pass = PassImage::new(width, height);
        for pixel in 0..width * height {
            let value = 1.0 / (1 + number * 7 + pixel) as f32;
            pass.add(pixel, Rgb::new(value, 3.0 * value, 1e-3));
            if number % 3 == 1 && pixel % 5 == 0 {
                pass.add_to_layer(300, pixel, Rgb::splat(value));
            }
        }
        film.add_pass(number, pass);
    }
    film
}

fn about(rays: u64) -> FilmAbout {
    let pair = |name: &str, text: &str| (name.to_string(), text.to_string());
    FilmAbout {
        settings: vec![pair("seed", "7"), pair("method", "bdpt --max-depth 5")],
        notes: vec![pair("scene", "größe")],
        counters: vec![("rays".to_string(), rays), ("paths".to_string(), 1)],
    }
}

fn save(folder: &Folder, name: &str, film: &Film, about: &FilmAbout) -> PathBuf {
    let path = folder.path().join(name);
    save_film(&path, None, film, about).unwrap();
    path
}

#[test]
fn a_film_comes_back_as_it_was() {
    let folder = Folder::new("film-round");
    for (sequences, passes) in [(1, 0..0), (1, 0..1), (1, 3..14), (4, 0..1), (4, 2..21)] {
        let film = film(sequences, passes);
        let path = save(&folder, "a.film", &film, &about(12));
        let (found, said) = load_film(&path).unwrap();
        assert!(found == film, "{sequences}");
        assert_eq!(said, about(12));
    }
}

/// Of 21 passes in 2, 3, 7 and 21 parts, the last of which comes first.
#[test]
fn merged_files_are_those_of_one_rendering() {
    const PASSES: u32 = 21;
    let folder = Folder::new("film-merge");
    for sequences in [1, 4] {
        let whole = save(&folder, "whole.film", &film(sequences, 0..PASSES), &about(210));
        let whole = fs::read(whole).unwrap();
        for parts in [1, 2, 3, 7, PASSES] {
            let range = |part: u32| PASSES * part / parts..PASSES * (part + 1) / parts;
            let mut films: Vec<FilmReader> = (0..parts)
                .rev()
                .map(|part| {
                    let mut about = about(10 * range(part).len() as u64);
                    about.counters[1].1 = u64::from(part == 0);
                    let film = film(sequences, range(part));
                    let path = save(&folder, &format!("{part}.film"), &film, &about);
                    FilmReader::open(&path).unwrap()
                })
                .collect();
            let path = folder.path().join("merged.film");
            merge_films(&path, &mut films, about(0).notes).unwrap();
            assert!(fs::read(&path).unwrap() == whole, "{sequences} {parts}");
        }
    }
}

#[test]
fn what_does_not_fit_is_named() {
    let folder = Folder::new("film-unfit");
    let a = save(&folder, "a.film", &film(1, 0..4), &about(1));
    let overlap = save(&folder, "b.film", &film(1, 3..6), &about(1));
    let mut other = about(1);
    other.settings[0].1 = "8".into();
    let differs = save(&folder, "c.film", &film(1, 4..6), &other);
    let small = save(&folder, "d.film", &Film::new(3, 2), &about(1));
    let sequences = save(&folder, "e.film", &film(4, 4..6), &about(1));
    let before = folder.files().len();
    for (file, words) in [
        (overlap, "b.film: has pass 3, and so has "),
        (differs, "its seed is 8, not 7"),
        (small, "its size is"),
        (sequences, "its number of sequences is 4, not 1"),
    ] {
        let mut films = [&file, &a].map(|path| FilmReader::open(path).unwrap());
        let out = folder.path().join("out.film");
        let said = merge_films(&out, &mut films, Vec::new()).unwrap_err().to_string();
        assert!(said.contains(words), "{said}");
        assert_eq!(folder.files().len(), before);
    }
}

/// Wherever a byte is changed or the file ends.
#[test]
fn damage_is_told_and_never_used() {
    let folder = Folder::new("film-damage");
    let whole =
        fs::read(save(&folder, "a.film", &film_of_size((12, 10), 1, 0..3), &about(1))).unwrap();
    let path = folder.path().join("b.film");
    let refused = |bytes: &[u8]| {
        fs::write(&path, bytes).unwrap();
        load_film(&path).unwrap_err().to_string()
    };
    let header = 16 + u32::from_le_bytes(whole[12..16].try_into().unwrap()) as usize + 4;
    let spread = (header..whole.len()).step_by(97).chain([whole.len() - 1]);
    for place in (0..header).chain(spread) {
        for bit in [0, 7] {
            let mut bytes = whole.clone();
            bytes[place] ^= 1 << bit;
            let said = refused(&bytes);
            let expected = match place {
                0..8 => "it is no film",
                8..12 => "its format has version ",
                _ if place < header => "its header is damaged",
                _ => "it is damaged from pixel ",
            };
            assert!(said.contains(expected), "{place} {said}");
        }
    }
    for length in (0..header).chain([header, header + 1, whole.len() / 2, whole.len() - 1]) {
        let said = refused(&whole[..length]);
        assert!(said.contains("b.film: cannot be read as a film: "), "{said}");
    }
    let said = refused(&[whole.as_slice(), b"\n"].concat());
    let lengths = format!("it has {} bytes instead of {}", whole.len() + 1, whole.len());
    assert!(said.ends_with(&lengths), "{said}");
    // One that is read only while it is merged.
    let mut bytes = whole.clone();
    bytes[header + 1000] ^= 1;
    fs::write(&path, &bytes).unwrap();
    let mut films = [FilmReader::open(&path).unwrap()];
    let out = folder.path().join("out.film");
    let said = merge_films(&out, &mut films, Vec::new()).unwrap_err().to_string();
    assert!(said.contains("b.film: cannot be read as a film: it is damaged"), "{said}");
    assert_eq!(folder.files().len(), 2);
}

#[test]
fn the_film_before_is_kept() {
    let folder = Folder::new("film-kept");
    let [path, kept] = ["a.film", "a.film.previous"].map(|name| folder.path().join(name));
    for passes in 1..4 {
        save_film(&path, Some(&kept), &film(1, 0..passes), &about(1)).unwrap();
        assert_eq!(load_film(&path).unwrap().0.passes(), passes);
        let before = load_film(&kept).map_or(0, |(film, _)| film.passes());
        assert_eq!(before, passes - 1);
    }
    assert_eq!(folder.files().len(), 2);
}
