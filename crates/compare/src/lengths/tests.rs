use super::*;
use traylib_known::furnace::{diffuse_walls, glowing_ball};

fn furnace(passes: u32) -> Vec<LengthShare> {
    lengths(&glowing_ball(diffuse_walls(), None).scene, 0.04, passes).unwrap()
}

#[track_caller]
fn whole(shares: &[LengthShare], of: impl Fn(&LengthShare) -> f64) {
    let sum: f64 = shares.iter().map(of).sum();
    assert!((sum - 1.0).abs() < 1e-9, "{sum}");
}

/// Walls that glow and keep ρ = 0.5: the share of K edges is (1 − ρ)ρ^(K−1), and the
/// last entry holds the rest, ρ^(K−1).
#[test]
fn light_of_the_furnace_halves_with_each_edge() {
    let shares = furnace(16);
    assert_eq!(shares.len(), LENGTHS);
    for (i, share) in shares.iter().enumerate() {
        assert_eq!(share.edges as usize, i + 1);
        let rest = 0.5_f64.powf(i as f64);
        let expected = if i + 1 == LENGTHS { rest } else { 0.5 * rest };
        // Some 16 · 1024 paths with roulette: half of them get one edge further.
        let allowed = 0.02 * expected + 4.0 * (expected / 16_384.0).sqrt();
        assert!((share.light - expected).abs() < allowed, "{share:?} {expected}");
    }
    whole(&shares, |share| share.light);
}

/// Lamps seen directly glow evenly: no noise. Each further edge needs rays.
#[test]
fn noise_and_rays_belong_to_the_lengths_that_make_them() {
    let shares = furnace(8);
    assert!(shares[0].variance < 1e-12, "{:?}", shares[0]);
    assert!(shares[1].variance > 0.0 && shares[2].variance > 0.0);
    assert!(shares[..8].iter().all(|share| share.rays > 0.0), "{shares:?}");
    assert!(shares[7].rays < shares[2].rays, "{shares:?}");
    whole(&shares, |share| share.variance);
    whole(&shares, |share| share.rays);
}

#[test]
fn one_pass_shows_no_noise() {
    assert!(furnace(1).iter().all(|share| share.variance == 0.0));
}
