//! Sums and where they come from.

use super::*;

fn film_of(values: &[f32]) -> Film {
    let mut film = Film::new(2, 1);
    for (number, &value) in (0..).zip(values) {
        let mut pass = PassImage::new(2, 1);
        pass.add(1, Rgb::splat(value));
        film.add_pass(number, pass);
    }
    film
}

#[test]
fn mean_and_variance_are_those_of_the_passes() {
    let film = film_of(&[1.0, 2.0, 6.0]);
    assert_eq!(*film.develop().get(1, 0), Rgb::splat(3.0));
    assert_eq!(*film.develop().get(0, 0), Rgb::BLACK);
    // Sample variance 7, of the mean 7/3.
    let variance = film.variance_of_mean().unwrap().get(1, 0)[0];
    assert!((variance - 7.0 / 3.0).abs() < 1e-12, "{variance}");
    assert!((film.relative_error().unwrap() - (7.0_f64 / 6.0).sqrt() / 1.5).abs() < 1e-12);
}

#[test]
fn one_pass_has_no_variance() {
    assert!(film_of(&[1.0]).variance_of_mean().is_none());
    assert!(film_of(&[]).relative_error().is_none());
    assert!(film_of(&[0.0, 0.0]).relative_error().is_none());
}

#[test]
fn splats_and_samples_of_a_pass_add_up() {
    let mut pass = PassImage::new(1, 1);
    pass.add(0, Rgb::splat(0.5));
    pass.add(0, Rgb::new(0.25, 0.0, 0.0));
    let mut film = Film::new(1, 1);
    film.add_pass(0, pass);
    assert_eq!(*film.develop().get(0, 0), Rgb::new(0.75, 0.5, 0.5));
}

/// A pass whose sums are rounded, some with light in a layer.
fn pass(number: u32) -> PassImage {
    let mut pass = PassImage::new(3, 2);
    for pixel in 0..6 {
        let value = 1.0 / (1 + number * 6 + pixel) as f32;
        pass.add(pixel, Rgb::new(value, 1e3 * value, 1e-3));
        if number % 3 == 1 {
            pass.add_to_layer(7, pixel, Rgb::splat(value));
        }
    }
    pass
}

fn film_of_passes(numbers: impl IntoIterator<Item = u32>) -> Film {
    let mut film = Film::new(3, 2);
    for number in numbers {
        film.add_pass(number, pass(number));
    }
    film
}

fn bits(film: &Film) -> Vec<u64> {
    let sums = [film.mean(), film.variance_of_mean().unwrap()];
    sums.iter().flat_map(|grid| grid.values().as_flattened()).map(|v| v.to_bits()).collect()
}

/// The bits are those of 61 passes in 2, 3, 7 and 61 parts, that begin and end anywhere, in many
/// orders.
#[test]
fn parts_in_any_order_make_the_same_film() {
    const PASSES: u32 = 61;
    let whole = film_of_passes(0..PASSES);
    let light = whole.mean().values()[0];
    let plain = (0..PASSES).map(|n| f64::from(1.0 / (1 + n * 6) as f32)).sum::<f64>();
    assert!((light[0] - plain / f64::from(PASSES)).abs() < 1e-15, "{light:?}");
    for parts in [2, 3, 7, PASSES] {
        for step in 1..parts {
            // Every step that misses no part is an order of its own.
            let order: Vec<u32> = (0..parts).map(|i| i * step % parts).collect();
            if (0..parts).any(|part| !order.contains(&part)) {
                continue;
            }
            let mut film = Film::new(3, 2);
            for part in order {
                let range = PASSES * part / parts..PASSES * (part + 1) / parts;
                film.merge(film_of_passes(range)).unwrap();
            }
            assert_eq!(film, whole);
            assert_eq!(bits(&film), bits(&whole));
            assert_eq!(film.develop_layers(), whole.develop_layers());
        }
    }
}

#[test]
fn a_film_that_is_given_up_leaves_its_picture() {
    for passes in 0..9 {
        let film = film_of_passes(0..passes);
        assert_eq!(film.clone().into_picture(), film.develop());
    }
}

/// One for each binary one of the number of passes.
#[test]
fn a_film_has_few_blocks() {
    for passes in 0..70_u32 {
        assert_eq!(film_of_passes(0..passes).blocks().count() as u32, passes.count_ones());
    }
    assert_eq!(film_of_passes((0..64).rev()).blocks().count(), 1);
}

#[test]
fn layers_count_the_passes_in_which_they_are_black() {
    let layers = film_of_passes(0..5).develop_layers();
    let known = (1.0 / 7.0 + 1.0 / 25.0) / 5.0;
    assert_eq!(layers.keys().copied().collect::<Vec<_>>(), [7]);
    assert!((layers[&7].values()[0].r - known).abs() < 1e-7, "{layers:?}");
}

#[test]
fn a_pass_counts_once() {
    let mut film = film_of_passes(0..6);
    let before = film.clone();
    for (other, pass) in [(5..9, 5), (0..1, 0), (2..4, 2), (0..8, 0)] {
        let other = film_of_passes(other);
        assert_eq!(film.merge(other), Err(MergeError::SamePass(pass)));
        assert_eq!(film, before);
    }
    let other = Film::new(2, 3);
    assert_eq!(film.merge(other), Err(MergeError::Size([[3, 2], [2, 3]])));
    assert_eq!(film, before);
}

fn film_of_sequences(numbers: impl IntoIterator<Item = u32>) -> Film {
    let mut film = Film::of_sequences(3, 2, 4);
    for number in numbers {
        film.add_pass(number, pass(number));
    }
    film
}

/// The variance of four means, each of a quarter of the passes.
#[test]
fn sequences_are_what_variance_is_estimated_from() {
    let film = film_of_sequences(0..32);
    let value = |number: u32| f64::from(1.0 / (1 + number * 6) as f32);
    let mean_of = |sequence: u32| (0..8).map(|i| value(4 * i + sequence)).sum::<f64>() / 8.0;
    let means = [0, 1, 2, 3].map(mean_of);
    let mean = means.iter().sum::<f64>() / 4.0;
    let variance = means.map(|m| (m - mean).powi(2)).iter().sum::<f64>() / 12.0;
    assert!((film.mean().values()[0][0] - mean).abs() < 1e-15);
    let estimate = film.variance_of_mean().unwrap().values()[0][0];
    assert!((estimate / variance - 1.0).abs() < 1e-12, "{estimate} {variance}");
}

/// One sequence tells nothing of its error, two do.
#[test]
fn a_single_sequence_has_no_variance() {
    let tells = |numbers: &[u32]| film_of_sequences(numbers.iter().copied());
    assert!(tells(&[0, 4, 8, 12]).variance_of_mean().is_none());
    assert!(tells(&[0, 4, 8, 12]).relative_error().is_none());
    // Two sequences of one and three passes, by their passes.
    let estimate = tells(&[0, 4, 8, 1]).variance_of_mean().unwrap().values()[0][0];
    let value = |number: u32| f64::from(1.0 / (1 + number * 6) as f32);
    let (one, three) = (value(1), (value(0) + value(4) + value(8)) / 3.0);
    let mean = (one + 3.0 * three) / 4.0;
    let variance = 0.25 * (one - mean).powi(2) + 0.75 * (three - mean).powi(2);
    assert!((estimate / variance - 1.0).abs() < 1e-12, "{estimate} {variance}");
}

#[test]
fn sequences_merge_from_parts_in_any_order() {
    let whole = film_of_sequences(0..29);
    for parts in [2, 3, 7] {
        let mut film = Film::of_sequences(3, 2, 4);
        for part in (0..parts).rev() {
            film.merge(film_of_sequences(29 * part / parts..29 * (part + 1) / parts)).unwrap();
        }
        assert_eq!(bits(&film), bits(&whole), "{parts}");
        assert_eq!(film, whole);
    }
    let mut film = film_of_sequences([6]);
    assert!(film.has_pass(6) && !film.has_pass(2) && film.passes() == 1);
    assert_eq!(film.merge(film_of_sequences([5, 6])), Err(MergeError::SamePass(6)));
    assert_eq!(film.merge(film_of_passes([1])), Err(MergeError::Sequences([4, 1])));
    assert_eq!(film.passes(), 1);
}
