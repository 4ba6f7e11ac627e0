use super::*;

fn read_with(lines: &str, size: &str, body: &[u8]) -> Result<Grid<Rgb>, String> {
    let head = format!("#?RADIANCE\n{lines}FORMAT=32-bit_rle_rgbe\n\n{size}\n");
    let bytes = [head.as_bytes(), body].concat();
    let decoded = decode(&bytes, TextureLimits { pixels: 100, file_bytes: 100 });
    decoded.map(|found| found.pixels).map_err(|error| error.to_string())
}

fn read(size: &str, body: &[u8]) -> Result<Vec<Rgb>, String> {
    read_with("", size, body).map(|found| found.values().to_vec())
}

#[test]
fn values_are_mantissas_times_a_power_of_two() {
    let found = read("-Y 2 +X 1", &[128, 64, 0, 129, 255, 1, 0, 1]).unwrap();
    let least = 2.0_f32.powi(-100) * 2.0_f32.powi(-35);
    assert_eq!(found, [Rgb::new(1.0, 0.5, 0.0), Rgb::new(255.0 * least, least, 0.0)]);
    assert_eq!(read("-Y 1 +X 1", &[9, 9, 9, 0]).unwrap(), [Rgb::BLACK]);
}

/// three 0.187.0 takes such a repetition for a pixel, and loses those that it stands for.
#[test]
fn old_repetitions_count_in_growing_units() {
    // One pixel, again none and then 256 times: too many. Or 2 times, and one more.
    let one = [128, 128, 128, 129];
    let too_many = [&one[..], &[1, 1, 1, 0], &[1, 1, 1, 1]].concat();
    assert!(read("-Y 1 +X 9", &too_many).unwrap_err().ends_with("beyond its scan line"));
    let three = [&one[..], &[1, 1, 1, 2], &[128, 128, 128, 130]].concat();
    let expected = [1.0, 1.0, 1.0, 2.0].map(|x| Rgb::new(x, x, x));
    assert_eq!(read("-Y 1 +X 4", &three).unwrap(), expected);
    // Any number of empty ones is no reason to panic.
    let empty = [&one[..], &[1, 1, 1, 0].repeat(20), &one].concat();
    assert_eq!(read("-Y 1 +X 2", &empty).unwrap(), [Rgb::WHITE; 2]);
}

const RUNS: [u8; 13] = [0x88, 128, 0x88, 64, 4, 1, 2, 3, 4, 0x84, 0, 0x88, 129];

#[test]
fn bands_are_unpacked() {
    let found = read("-Y 1 +X 8", &[&[2, 2, 0, 8][..], &RUNS].concat()).unwrap();
    let blue = [1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0, 0.0].map(|x| x / 128.0);
    assert_eq!(found, blue.map(|b| Rgb::new(1.0, 0.5, b)));
}

/// Six pixels in three rows of two: `1 2 / 3 4 / 5 6` as they are shown.
#[test]
fn scan_lines_run_in_all_eight_orders() {
    for (size, stored) in [
        ("-Y 3 +X 2", [1, 2, 3, 4, 5, 6]),
        ("-Y 3 -X 2", [2, 1, 4, 3, 6, 5]),
        ("+Y 3 +X 2", [5, 6, 3, 4, 1, 2]),
        ("+Y 3 -X 2", [6, 5, 4, 3, 2, 1]),
        ("+X 2 -Y 3", [1, 3, 5, 2, 4, 6]),
        ("+X 2 +Y 3", [5, 3, 1, 6, 4, 2]),
        ("-X 2 -Y 3", [2, 4, 6, 1, 3, 5]),
        ("-X 2 +Y 3", [6, 4, 2, 5, 3, 1]),
    ] {
        let body = stored.map(|n| [n, 0, 0, 136]);
        let found = read_with("", size, body.as_flattened()).unwrap();
        assert_eq!((found.width(), found.height()), (2, 3), "{size}");
        let red: Vec<f32> = found.values().iter().map(|light| light.r).collect();
        assert_eq!(red, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], "{size}");
    }
    // Packed scan lines, which are columns from the bottom.
    let body = [&[2, 2, 0, 8][..], &RUNS].concat();
    let found = read_with("", "+X 1 +Y 8", &body).unwrap();
    let blue: Vec<f32> = found.values().iter().map(|light| 128.0 * light.b).collect();
    assert_eq!((found.width(), blue), (1, vec![0.0, 0.0, 0.0, 0.0, 4.0, 3.0, 2.0, 1.0]));
}

/// Lines multiply, and those behind a tab are the history of what the picture was made of.
/// three 0.187.0 takes the last of all.
#[test]
fn light_is_what_was_there_before_the_exposure() {
    let one = [128, 128, 128, 129];
    let light = |lines| *read_with(lines, "-Y 1 +X 1", &one).unwrap().get(0, 0);
    assert_eq!(light("EXPOSURE=2\n"), Rgb::splat(0.5));
    assert_eq!(light("EXPOSURE=2.0\nEXPOSURE= 4 (and a word)\n"), Rgb::splat(0.125));
    assert_eq!(light("COLORCORR=1 2 4\nEXPOSURE=.5\n"), Rgb::new(2.0, 1.0, 0.5));
    assert_eq!(light("COLORCORR= 2 2 1\nCOLORCORR=1 2 1\n"), Rgb::new(0.5, 0.25, 1.0));
    // Of another picture, which went into this one.
    assert_eq!(light("\tEXPOSURE=2\n\tFORMAT=other\nVIEW= -vtv\nEXPOSURES=9\n"), Rgb::WHITE);
    // A power that no 32-bit number has, twice.
    assert_eq!(light("EXPOSURE=1e-60\nEXPOSURE=1e60\n"), Rgb::WHITE);
}

#[test]
fn primaries_are_turned_into_ours() {
    let pixel = [10, 20, 30, 136];
    let light = |lines| *read_with(lines, "-Y 1 +X 1", &pixel).unwrap().get(0, 0);
    let usual = "PRIMARIES= 0.6400 0.3300 0.2900 0.6000 0.1500 0.0600 0.3333 0.3333\n";
    assert_eq!(light(usual), Rgb::new(10.0, 20.0, 30.0));
    let wide = light("PRIMARIES=.708 .292 .17 .797 .131 .046 .3127 .3290\n").to_array();
    for (found, expected) in wide.into_iter().zip([2.67, 21.16, 31.36]) {
        assert!((found - expected).abs() < 0.01, "{wide:?}");
    }
}

#[test]
fn places_are_named() {
    for (size, body, expected) in [
        ("+Y 1 +Y 1", &[][..], "Radiance: at byte 35: wanted is the size"),
        ("-Y 1 +Z 1", &[], "Radiance: at byte 35: wanted is the size"),
        ("-Y 1 +X 1 5", &[], "Radiance: at byte 35: wanted is the size"),
        ("-Y 1 +X 1", &[1, 2, 3], "Radiance: at byte 45: it ends within the picture"),
        ("-Y 1 +X 8", &[2, 2, 0, 9], "Radiance: at byte 49: a scan line is not as long"),
        ("-Y 1 +X 8", &[2, 2, 0, 8, 0x89, 0], "Radiance: at byte 50: a run goes beyond"),
        ("-Y 1 +X 2", &[1, 1, 1, 1], "Radiance: at byte 49: a scan line begins with"),
        ("-Y 11 +X 10", &[], "10x11 pixels are more than the 100 allowed"),
        ("+X 10 -Y 11", &[], "10x11 pixels are more than the 100 allowed"),
        ("-Y 0 +X 10", &[], "it has no pixels"),
        ("-X 0 +Y 10", &[], "it has no pixels"),
    ] {
        let said = read(size, body).unwrap_err();
        assert!(said.starts_with(expected), "{size}: {said}");
    }
}

#[test]
fn lines_without_sense_are_refused() {
    for (lines, expected) in [
        ("EXPOSURE=\n", "EXPOSURE is no number above 0"),
        ("EXPOSURE=0\n", "EXPOSURE is no number above 0"),
        ("EXPOSURE=-1\n", "EXPOSURE is no number above 0"),
        ("EXPOSURE=inf\n", "EXPOSURE is no number above 0"),
        ("COLORCORR=1 1\n", "COLORCORR is not three numbers above 0"),
        ("COLORCORR=1 nan 1\n", "COLORCORR is not three numbers above 0"),
        ("PRIMARIES=.3 .3 .3\n", "PRIMARIES are not x and y"),
        ("PRIMARIES=.3 .3 .3 .3 .3 .3 .3 .3\n", "PRIMARIES are not x and y"),
        ("FORMAT=32-bit_rle_xyze\n", "the format is not 32-bit_rle_rgbe"),
    ] {
        let said = read_with(lines, "-Y 1 +X 1", &[1; 4]).unwrap_err();
        assert!(said.starts_with(&format!("Radiance: at byte 11: {expected}")), "{said}");
    }
}
