use super::*;

fn lobe(n: f32, degrees: f32) -> Lobe {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Lobe::new(n, Vec3::new(0.6 * sin, 0.8 * sin, cos))
}

/// Values by an independent quadrature, to the digits given there.
#[test]
fn albedo_and_hidden_part_have_their_known_values() {
    const ANGLES: [f32; 6] = [0.0, 30.0, 60.0, 80.0, 85.0, 89.0];
    for (n, albedos) in [
        (1.0, [1.0, 0.8808, 0.6090, 0.4100, 0.3631, 0.3271]),
        (5.0, [1.0, 0.8663, 0.5194, 0.2693, 0.2166, 0.1786]),
        (20.0, [1.0, 0.8660, 0.5005, 0.2003, 0.1383, 0.0971]),
        (100.0, [1.0, 0.8660, 0.5, 0.1752, 0.0976, 0.0491]),
        (1e3, [1.0, 0.8660, 0.5, 0.1737, 0.0872, 0.0232]),
        (1e6, [1.0, 0.8660, 0.5, 0.1736, 0.0872, 0.0175]),
    ] {
        for (degrees, albedo) in ANGLES.into_iter().zip(albedos) {
            let found = lobe(n, degrees).phong_albedo();
            assert!((found - albedo).abs() < 6e-5, "n {n}, {degrees}°: {found} {albedo}");
        }
    }
    for (n, degrees, hidden) in
        [(1.0, 60.0, 0.25), (5.0, 80.0, 0.340), (20.0, 89.0, 0.469), (1e3, 89.0, 0.290)]
    {
        let found = lobe(n, degrees).hidden();
        assert!((found - hidden).abs() < 6e-4, "n {n}, {degrees}°: {found}");
    }
}

/// At n = 0, seen along the normal, the lobe is the whole hemisphere evenly:
/// A = 2·∫cosθ/(2π) dω = 1, and for Max-Phong ∫ 1/(2π)·cosθ dω = 1/2. At 80° a sharp
/// one tends to one: 0.928 at n = 1000, 0.998 at 10⁶.
#[test]
fn max_phong_has_its_known_values() {
    assert!((lobe(0.0, 0.0).phong_albedo() - 1.0).abs() < 1e-5);
    assert!((lobe(0.0, 0.0).max_phong_albedo() - 0.5).abs() < 1e-5);
    assert!((lobe(1e3, 80.0).max_phong_albedo() - 0.928).abs() < 1e-3);
    assert!((lobe(1e6, 80.0).max_phong_albedo() - 0.998).abs() < 1e-3);
}

/// The cells of a diffuse surface sum to the part of cosθ/π within a right angle
/// of R: (1 + cosθ)/2.
#[test]
fn diffuse_cells_sum_to_a_hemispheres_share() {
    for n in [0.0, 20.0, 1e6] {
        for degrees in [0.0_f32, 60.0, 89.99] {
            let sum: f64 = lobe(n, degrees).diffuse().iter().sum();
            let share = 0.5 * (1.0 + f64::from(degrees.to_radians()).cos());
            assert!((sum - share).abs() < 2e-5, "n {n}, {degrees}°: {sum} {share}");
        }
    }
}

#[test]
fn coordinates_are_those_of_the_angles() {
    let lobe = lobe(3.0, 60.0);
    let [mirrored, first, second] = lobe.axes;
    assert!((mirrored.z - 0.5).abs() < 1e-7 && first.z > 0.0);
    let w = mirrored * 0.8 + second * 0.6;
    let found = lobe.coordinates(w.as_vec3()).unwrap();
    assert!((found[0] - 0.75).abs() < 1e-6, "{found:?}");
    assert!((found[1] - 0.8_f64.powi(4)).abs() < 1e-6, "{found:?}");
    assert_eq!(lobe.coordinates((mirrored * -1.0).as_vec3()), None);
}
