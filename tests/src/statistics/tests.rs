use super::*;
use traylib_math::{Purpose, Sampler};

/// Two-sided quantiles of Student's law from printed tables, one of them far
/// out where the levels of families lie.
#[test]
fn quantiles_are_those_of_the_tables() {
    // Values with mean zero and variance of the mean one.
    let values = |n: usize| {
        let unit = ((n - 1) as f64).sqrt();
        (0..n).map(|i| if i % 2 == 0 { unit } else { -unit }).collect::<Vec<_>>()
    };
    for (count, level, quantile) in [(2, 0.05, 12.706), (10, 0.01, 3.250), (32, 1e-3, 3.633)] {
        let interval = mean_interval(&values(count), level);
        assert!((interval.half_width - quantile).abs() < 1e-3, "{count}: {interval:?}");
    }
    // With one degree of freedom, Cauchy's law, it is cot(π·level/2).
    let half_width = mean_interval(&values(2), 1e-6).half_width;
    let exact = 1.0 / (std::f64::consts::FRAC_PI_2 * 1e-6).tan();
    assert!((half_width / exact - 1.0).abs() < 1e-6, "{half_width} {exact}");
    // DVec3 families of many passes: normal to the eye, 4.89164 at 1e-6.
    let half_width = mean_interval(&values(100_000), 1e-6).half_width;
    assert!((half_width - 4.892).abs() < 2e-3, "{half_width}");
}

#[test]
fn one_value_says_nothing() {
    assert!(mean_interval(&[1.0], 0.01).half_width.is_infinite());
    assert_eq!(mean_interval(&[1.0; 5], 0.01), Interval { mean: 1.0, half_width: 0.0 });
}

/// The interval at level 0.1 misses the mean in a tenth of 4000 trials; five
/// standard errors of that count are 95.
#[test]
fn intervals_miss_as_often_as_they_say() {
    let mut sampler = Sampler::new(1, Purpose::Test, 0, 0);
    let mut values = || -> Vec<f64> { (0..16).map(|_| f64::from(sampler.next_1d())).collect() };
    let missed = (0..4000).filter(|_| !mean_interval(&values(), 0.1).contains(0.5)).count();
    assert!(missed.abs_diff(400) < 95, "{missed}");
}

/// The same for Welch's test with unequal variances and counts.
#[test]
fn welch_raises_false_alarms_as_often_as_it_says() {
    let mut sampler = Sampler::new(2, Purpose::Test, 0, 0);
    let mut sample = |count: usize, width: f64| {
        let values: Vec<f64> =
            (0..count).map(|_| width * (f64::from(sampler.next_1d()) - 0.5)).collect();
        Sample::of(&values)
    };
    let alarms = (0..4000).filter(|_| welch(&sample(12, 1.0), &sample(40, 5.0)) < 0.1).count();
    assert!(alarms.abs_diff(400) < 95, "{alarms}");
}

/// By hand: means 2 and 4, variances of the mean 1/3 and 4/3, so that
/// t = 2/√(5/3) = 1.5492 with (5/3)²/(1/18 + 16/18) = 2.9412 degrees of
/// freedom, whose two-sided tail is 0.2209 (quadrature of the density).
#[test]
fn welch_is_the_textbook_formula() {
    let a = Sample::of(&[1.0, 2.0, 3.0]);
    let b = Sample::of(&[2.0, 4.0, 6.0]);
    let exact = tail_by_quadrature(2.0 / (5.0_f64 / 3.0).sqrt(), 25.0 / 8.5);
    assert!((welch(&a, &b) - exact).abs() < 1e-6, "{} {exact}", welch(&a, &b));
    assert_eq!(welch(&a, &a), 1.0);
    let constant = Sample::of(&[1.0, 1.0]);
    assert_eq!(welch(&constant, &constant), 1.0);
    assert_eq!(welch(&constant, &Sample::of(&[2.0, 2.0])), 0.0);
}

/// Both tails of Student's density (1 + x²/ν)^(−(ν+1)/2), by the midpoint rule
/// after x = √ν·tan a, which makes it cos^(ν−1) a.
fn tail_by_quadrature(t: f64, freedom: f64) -> f64 {
    let integral = |from: f64| {
        let steps = 200_000;
        let width = (std::f64::consts::FRAC_PI_2 - from) / f64::from(steps);
        let height = |i: i32| (from + (f64::from(i) + 0.5) * width).cos().powf(freedom - 1.0);
        (0..steps).map(height).sum::<f64>() * width
    };
    integral((t / freedom.sqrt()).atan()) / integral(0.0)
}

#[test]
fn levels_of_a_family_add_up() {
    for tests in [1, 2, 100] {
        let level = sidak(1e-3, tests);
        let family = 1.0 - (1.0 - level).powf(tests as f64);
        assert!((family - 1e-3).abs() < 1e-9, "{tests}: {family}");
    }
}

#[test]
fn holm_grows_more_lenient_and_stops_at_the_first_survivor() {
    // Limits 0.0125, 0.0167, 0.025: the third fails, so the last, though small
    // enough for its own limit of 0.05, stands as well.
    assert_eq!(holm(&[0.04, 0.01, 0.016, 0.03], 0.05), [false, true, true, false]);
    assert_eq!(holm(&[], 0.05), Vec::<bool>::new());
}

#[test]
fn batches_and_tiles_are_means() {
    assert_eq!(batch_means(&[1.0, 3.0, 5.0, 7.0, 100.0], 2), [2.0, 6.0]);
    let image = Grid::from_values(3, 2, vec![1.0, 2.0, 3.0, 5.0, 6.0, 7.0]).unwrap();
    assert_eq!(tile_means(&image, 2), [3.5, 5.0]);
    assert_eq!(tile_means(&image, 1).len(), 6);
}

#[test]
fn evenly_spread_values_are_told_from_others() {
    let even: Vec<f64> = (0..100).map(|i| (f64::from(i) + 0.5) / 100.0).collect();
    assert!(uniformity(&even) > 0.999);
    // Squares lie 1/4 off at most: Kolmogorov's law beyond 2.5 is 7e-6.
    let squares: Vec<f64> = even.iter().map(|x| x * x).collect();
    let p = uniformity(&squares);
    assert!((2e-6..2e-5).contains(&p), "{p}");
    // Of 1000 distances of ten random values a twentieth is below 0.05.
    let mut sampler = Sampler::new(0, Purpose::Test, 0, 0);
    let mut draw = || {
        let values: Vec<f64> = (0..10).map(|_| f64::from(sampler.next_1d())).collect();
        usize::from(uniformity(&values) < 0.05)
    };
    let rare: usize = (0..1000).map(|_| draw()).sum();
    assert!((25..80).contains(&rare), "{rare}");
}
