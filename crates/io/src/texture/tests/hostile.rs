//! Damage of any kind ends in a texture or an error, never in a panic.

use super::*;
use traylib_math::Sampler;

const LIMITS: TextureLimits = TextureLimits { pixels: 1 << 12, file_bytes: 1 << 20 };

/// Tells whether it can be read; what is read is whole.
fn survives(format: &str, bytes: &[u8]) -> bool {
    match texture_from_bytes(bytes, Path::new("a.tga"), LIMITS) {
        Ok(found) => {
            let count = found.pixels.values().len();
            assert!(count > 0 && count as u64 <= LIMITS.pixels, "{format}");
            assert!(found.alpha.is_none_or(|alpha| alpha.values().len() == count), "{format}");
            true
        }
        Err(Error::ReadPicture { cause, .. }) => {
            assert!(cause.is::<TextureError>(), "{format}: {cause}");
            false
        }
        Err(other) => panic!("{format}: {other}"),
    }
}

#[test]
fn every_beginning_of_a_file() {
    for (format, bytes) in made::all(9, 7) {
        let read = (0..bytes.len()).filter(|&length| survives(format, &bytes[..length])).count();
        assert!(survives(format, &bytes), "{format}");
        assert!(
            read < bytes.len() / 2 || format.starts_with("pcx") || format == "jpeg",
            "{format}: {read}"
        );
    }
}

/// Messages are for the owner of the file, not for those who know the decoder.
#[test]
fn damage_is_told_in_plain_words() {
    let known = ["is cut off", "is damaged", "is of a kind that is not read"];
    for (format, bytes) in made::all(9, 7) {
        for length in 0..bytes.len() {
            let Err(error) = texture_from_bytes(&bytes[..length], Path::new("a.tga"), LIMITS)
            else {
                continue;
            };
            let Error::ReadPicture { cause, .. } = error else { panic!("{error}") };
            let said = cause.to_string();
            let fault = said.strip_prefix("the ").and_then(|said| said.split_once(" picture "));
            let is_fault = fault.is_some_and(|(_, fault)| known.contains(&fault));
            let is_own = said.starts_with("Radiance: at byte ") || said.starts_with("it ");
            assert!(is_fault || is_own, "{format}: {said}");
        }
    }
}

#[test]
fn random_bytes_in_a_file() {
    let mut sampler = Sampler::numbered(5, 0);
    for (format, bytes) in made::all(9, 7) {
        let mut read = 0;
        for _ in 0..1000 {
            let mut changed = bytes.clone();
            for _ in 0..=pick(&mut sampler, 3) {
                // Half of all changes are in the header.
                let range = if pick(&mut sampler, 2) == 0 { 50 } else { bytes.len() };
                let at = pick(&mut sampler, range.min(bytes.len()));
                changed[at] =
                    [0, 1, 0x7f, 0x80, 0xff, pick(&mut sampler, 256) as u8][pick(&mut sampler, 6)];
            }
            read += usize::from(survives(format, &changed));
        }
        assert!(read > 0 && read < 1000, "{format}: {read}");
    }
}

fn pick(sampler: &mut Sampler, below: usize) -> usize {
    (sampler.next_1d() * below as f32) as usize
}

/// Random bytes come with the beginning of a format, or with nothing but the name.
#[test]
fn random_bytes_alone() {
    let mut sampler = Sampler::numbered(6, 0);
    let starts: [&[u8]; 6] =
        [b"", b"GIF89a", b"#?RGBE\n\n-Y 3 +X 9\n", b"\xff\xd8\xff", &[10, 5, 1, 8], &[0, 0, 10]];
    for start in starts {
        for _ in 0..300 {
            let rest = (0..pick(&mut sampler, 300)).map(|_| pick(&mut sampler, 256) as u8);
            let bytes: Vec<u8> = start.iter().copied().chain(rest.collect::<Vec<_>>()).collect();
            survives(&format!("{start:x?}"), &bytes);
        }
    }
}
