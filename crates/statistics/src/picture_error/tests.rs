use super::*;

fn close(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-12 * expected.abs(), "{value} is not {expected}");
}

#[test]
fn the_floor_is_a_hundredth_of_the_squared_mean() {
    close(error_floor(&[[1.0, 2.0, 3.0], [4.0, 0.0, 2.0]]), 0.04);
    assert_eq!(error_floor(&[[0.0; 3]]), 0.0);
}

#[test]
fn figures_follow_their_definitions() {
    let reference = [[1.0, 2.0, 3.0], [0.0, 0.0, 0.0]];
    let picture = [[2.0, 2.0, 1.0], [1.0, 0.0, 0.0]];
    let error = PictureError::between(&picture, &reference, 1.0).unwrap();
    // Squares 1, 0, 4 and 1, 0, 0, over 2, 5, 10 and 1, 1, 1.
    close(error.mse, 1.0);
    close(error.rel_mse, (0.5 + 0.4 + 1.0) / 6.0);
    close(error.smape, (1.0 / 3.0 + 2.0 / 4.0 + 1.0) / 6.0);
    // Sums 6 and 6.
    assert_eq!(error.mean_ratio, 1.0);
    let pixels = relative_square_errors(&picture, &reference, 1.0).unwrap();
    close(pixels[0], 0.3);
    close(pixels[1], 1.0 / 3.0);
}

#[test]
fn the_ratio_is_that_of_the_means() {
    let error = PictureError::between(&[[1.0, 1.0, 4.0]], &[[1.0; 3]], 1.0).unwrap();
    close(error.mean_ratio, 2.0);
}

#[test]
fn without_a_floor_light_where_none_should_be_is_an_infinite_error() {
    let black = [[0.0; 3]];
    let same = PictureError::between(&black, &black, 0.0).unwrap();
    let none =
        PictureError { mse: 0.0, rel_mse: 0.0, trimmed_rel_mse: 0.0, smape: 0.0, mean_ratio: 1.0 };
    assert_eq!(same, none);
    let lit = PictureError::between(&[[0.0, 0.5, 0.0]], &black, 0.0).unwrap();
    assert_eq!((lit.rel_mse, lit.mean_ratio), (f64::INFINITY, f64::INFINITY));
    close(lit.smape, 1.0 / 3.0);
}

#[test]
fn one_pixel_in_a_thousand_is_trimmed() {
    let all = |value: f64, n: usize| vec![[value; 3]; n];
    let mut pixels = all(2.0, 2000);
    pixels[7] = [1001.0; 3];
    let error = PictureError::between(&pixels, &all(1.0, 2000), 0.0).unwrap();
    close(error.rel_mse, (1999.0 + 1e6) / 2000.0);
    close(error.trimmed_rel_mse, 1.0);
    let few = PictureError::between(&pixels[..999], &all(1.0, 999), 0.0).unwrap();
    assert_eq!(few.trimmed_rel_mse, few.rel_mse, "of 999 none is left out");
}

#[test]
fn other_sizes_and_no_pixels_have_no_error() {
    let (two, three) = ([[1.0; 3]; 2], [[1.0; 3]; 3]);
    assert_eq!(PictureError::between(&two, &three, 0.1), None);
    assert_eq!(relative_square_errors(&two, &three, 0.1), None);
    assert!(rel_mse(&two, &three, 0.1).is_nan());
    assert_eq!(PictureError::between::<3>(&[], &[], 0.1), None);
}

/// Variances 0.1 and 0.2 over 2 and 5; where neither light nor noise is, nothing.
#[test]
fn noise_of_a_reference_is_relative_too() {
    close(own_rel_mse(&[[1.0], [2.0]], &[[0.1], [0.2]], 1.0), 0.045);
    assert_eq!(own_rel_mse(&[[0.0; 3]], &[[0.0; 3]], 0.0), 0.0);
}

#[test]
fn a_value_that_is_not_a_number_shows() {
    let error = PictureError::between(&[[f64::NAN, 1.0, 1.0]], &[[1.0; 3]], 0.1);
    let error = error.unwrap();
    assert!(error.mse.is_nan() && error.smape.is_nan() && error.mean_ratio.is_nan());
}
