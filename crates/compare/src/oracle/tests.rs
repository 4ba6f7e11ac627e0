use super::*;

/// Fixed seeds: an interval of 99.9 % at each of eight points, which a correct
/// program would have missed once in 125 times when this was first run, and never
/// after. Times are never compared.
#[test]
fn noise_and_crossing_follow_theory() {
    let size = Size { passes: 16, radii: &[0.5, 2.0], timing: (1e-4, 3) };
    let told = std::cell::Cell::new(0);
    let found = measure(&size, &|_| told.set(told.get() + 1));
    assert_eq!((told.get(), found.samples), (3, 65_536));
    let names: Vec<&str> = found.curves.iter().map(|curve| curve.method.as_str()).collect();
    assert_eq!(names, ESTIMATORS.map(|of| of.method().to_string()));
    for curve in &found.curves {
        for (point, radius) in curve.points.iter().zip(size.radii) {
            let OraclePoint { theory, variance: Estimate { low, high, .. }, .. } = *point;
            assert_eq!(point.radius, *radius);
            assert!((low..=high).contains(&theory), "{} {point:?}", curve.method);
            assert!(high - low < 0.2 * theory, "{} {point:?}", curve.method);
            assert!(point.seconds > 0.0 && point.seconds < 1e-3, "{point:?}");
        }
        assert_eq!(curve.points.len(), 2);
    }
    // 95 % each; the second holds for whatever the costs are.
    for crossing in [found.crossing, found.crossing_in_time] {
        let Estimate { value, low, high } = crossing.measured;
        assert!((low..=high).contains(&crossing.theory), "{crossing:?}");
        assert!(low < value && value < high && high - low < 0.2, "{crossing:?}");
    }
    assert!((found.crossing.theory - 1.450_45).abs() < 1e-5);
}
