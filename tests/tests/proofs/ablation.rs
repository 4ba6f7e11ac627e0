//! Each technique (s, t) alone, and random sets of them, against radiance that
//! is known for each length of path.

use traylib_known::furnace::{diffuse_walls, mirroring_walls};
use traylib_tests::ablation::{Budget, Spectrum, ball, lit_ball, random_subset};
use traylib_tests::findings::{Finding, settle};

/// For all comparisons of this file at once, about 100 in either form, a false
/// alarm with probability 10⁻³.
const LEVEL: f64 = 1e-5;
/// A single technique may find its light by rare and bright paths.
const FAST: Budget = Budget { batches: 16, passes: 12, level: LEVEL, equivalence: 0.15 };
const LONG_ALONE: Budget = Budget { batches: 32, passes: 96, level: LEVEL, equivalence: 0.03 };
const LONG_SETS: Budget = Budget { batches: 32, passes: 32, level: LEVEL, equivalence: 0.05 };

fn subsets(spectrum: &Spectrum, count: u64, budget: Budget) -> Vec<Finding> {
    (0..count)
        .flat_map(|number| {
            let chosen = random_subset(spectrum, number);
            spectrum.subset(&chosen, budget, 1000 * (number + 1))
        })
        .collect()
}

#[test]
fn each_technique_alone_finds_all_light_of_an_area_lamp() {
    settle(&ball(diffuse_walls()).each_alone(FAST, 1));
}

#[test]
fn each_technique_alone_finds_all_light_of_a_point_light() {
    settle(&lit_ball().each_alone(FAST, 2));
}

#[test]
fn any_techniques_share_the_light_among_them() {
    settle(&subsets(&ball(diffuse_walls()), 3, FAST));
    settle(&subsets(&lit_ball(), 3, FAST));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn techniques_at_length() {
    let (area, point) = (ball(diffuse_walls()), lit_ball());
    settle(&area.each_alone(LONG_ALONE, 3));
    settle(&point.each_alone(LONG_ALONE, 4));
    settle(&subsets(&area, 4, LONG_SETS));
    settle(&subsets(&point, 4, LONG_SETS));
}

/// No technique but a hit finds paths that are mirrored twice in a row; all
/// together find everything.
#[test]
fn mirrors_leave_their_paths_to_others() {
    let spectrum = ball(mirroring_walls());
    let findings = spectrum.each_alone(FAST, 5);
    settle(&findings.into_iter().filter(|f| f.claim.ends_with("all weighted")).collect::<Vec<_>>());
}
